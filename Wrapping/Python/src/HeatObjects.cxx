#include "Bindings.h"
#include "Conversions.h"
#include "Options.h"

#include "shapetonObjectParameters.h"
#include "shapetonWindowObjects.h"

namespace shapeton::python
{
namespace
{
using ImageType = itk::Image<float, 3>;

/** Result of find_objects(), with the volumes that masks need. */
struct HeatObjects
{
  HeatObjectList                  list;
  std::vector<ImageType::Pointer> heats;

  std::vector<const ImageType *>
  Heats() const
  {
    return { heats.begin(), heats.end() };
  }
};

/** An object, and the place of its seed in the array. */
struct PlacedObject
{
  HeatObject    object;
  itk::Index<3> seed;
};

std::vector<PlacedObject>
PlacedObjects(const HeatObjects & found)
{
  std::vector<PlacedObject> placed;
  for (const HeatObject & object : found.list.objects)
  {
    placed.push_back({ object, found.heats[0]->ComputeIndex(object.seed) });
  }
  return placed;
}

HeatObjects
FindObjects(const std::vector<ImageType::Pointer> & heats,
            const Given<HeatObjectOptions> &        given,
            bool                                    areWindows,
            const Progress &                        progress)
{
  HeatObjects found{ {}, heats };
  const auto  find = areWindows ? &FindWindowObjects : &FindHeatObjects;
  found.list = find(found.Heats(), given.options, progress.Part("Finding objects", 0.0, 1.0));
  return found;
}

/** ChooseObjectWindows() as arguments of diffuse_heat(). */
std::vector<py::dict>
WindowsOf(const ImageType::Pointer & image, const Progress & progress)
{
  const auto choices =
    ChooseObjectWindows(VolumeView(image.GetPointer()), {}, {}, progress.Part("Choosing windows", 0.0, 1.0));
  const WithGil         gil;
  std::vector<py::dict> windows;
  for (const HeatParameterChoice & choice : choices)
  {
    windows.push_back(py::dict("intensity_window"_a = choice.intensityWindow,
                               "p"_a = choice.p,
                               "smoothing"_a = choice.smoothing,
                               "time_steps"_a = choice.timeSteps));
  }
  return windows;
}
} // namespace

void
AddHeatObjects(py::module_ & module)
{
  const auto readOnly = [](auto member) {
    return [member](const PlacedObject & placed) { return placed.object.*member; };
  };
  py::class_<PlacedObject>(module, "HeatObject", "A connected region that changes little over a range of heat.")
    .def_property_readonly("parent",
                           readOnly(&HeatObject::parent),
                           "Number of the smallest object, from 1, that contains this one; 0 for none.")
    .def_property_readonly("is_warm",
                           readOnly(&HeatObject::isWarm),
                           "Whether its voxels have at least `heat`; otherwise they have at most `heat`.")
    .def_property_readonly("time", readOnly(&HeatObject::time), "From 0: the heat image in which it was found.")
    .def_property_readonly("heat", readOnly(&HeatObject::heat), "The threshold.")
    .def_property_readonly(
      "seed",
      [](const PlacedObject & placed) { return py::make_tuple(placed.seed[2], placed.seed[1], placed.seed[0]); },
      "Its warmest, or coldest, voxel, [z, y, x].")
    .def_property_readonly("center", readOnly(&HeatObject::center), "Mean position of its voxels, LPS, mm.")
    .def_property_readonly("voxels", readOnly(&HeatObject::voxels), "Number of voxels, with those of objects in it.")
    .def_property_readonly("volume", readOnly(&HeatObject::volume), "mm^3.")
    .def_property_readonly("heat_curve", readOnly(&HeatObject::heatCurve), "Mean of its voxels in each heat image.")
    .def_property_readonly("growth",
                           readOnly(&HeatObject::growth),
                           "Logarithmic change of the volume when the threshold changes by 5 %; 0: none.")
    .def_property_readonly(
      "range", readOnly(&HeatObject::range), "Range of thresholds with a volume within 20 %, as a natural logarithm.")
    .def_property_readonly("contrast",
                           readOnly(&HeatObject::contrast),
                           "Median over its border of the absolute log ratio of the heat on both sides.")
    .def_property_readonly(
      "compactness", readOnly(&HeatObject::compactness), "36 pi volume^2 / surface^3: 1 for a ball.")
    .def_property_readonly("cut", readOnly(&HeatObject::cut), "Share of its border at the border of the volume.")
    .def_property_readonly(
      "probability", readOnly(&HeatObject::probability), "Probability that it is one whole object, 0 to 1.");

  py::class_<HeatObjects>(module, "HeatObjects", "Result of `find_objects`.")
    .def_property_readonly("objects", &PlacedObjects, "By descending volume; the number of the first one is 1.")
    .def_property_readonly(
      "labels",
      [](const HeatObjects & found) { return found.list.labels; },
      "uint16: the number of the smallest object at each voxel; 0 for none.")
    .def(
      "mask",
      [](const HeatObjects & found, int number) { return MaskOfObject(found.list, number); },
      "number"_a,
      ReleaseGil(),
      "uint8: 1 in an object, with those in it, otherwise 0.");

  module.def("find_objects", Reporting(&FindObjects), ReleaseGil());
  module.def("object_windows", Reporting(&WindowsOf), ReleaseGil());
}
} // namespace shapeton::python
