#include "Bindings.h"
#include "Conversions.h"
#include "Errors.h"
#include "Options.h"

#include "shapetonHeatObjects.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace shapeton::python
{
namespace
{
using ImageType = itk::Image<float, 3>;
using MaskType = itk::Image<unsigned char, 3>;

HeatObjectList
FindObjects(const ImageType::Pointer &               heat,
            const std::optional<MaskType::Pointer> & domain,
            const Given<HeatObjectOptions> &         given,
            const Progress &                         progress)
{
  return HeatObjectTree(heat, given.options, domain.value_or(nullptr), progress.Part("Finding objects", 0.0, 1.0))
    .List();
}
} // namespace

void
AddHeatObjects(py::module_ & module)
{
  py::class_<HeatObject>(module, "HeatObject", "A region of heat with a border: a part that a person sees.")
    .def_readonly(
      "parent", &HeatObject::parent, "Number of the smallest object, from 1, that contains this one; 0 for none.")
    .def_readonly("center", &HeatObject::center, "Mean position of its voxels, LPS, mm.")
    .def_readonly("voxels", &HeatObject::voxels, "Number of voxels, with those of objects in it.")
    .def_readonly("volume", &HeatObject::volume, "mm^3.")
    .def_readonly("mean_heat", &HeatObject::meanHeat, "Mean of its voxels.")
    .def_readonly(
      "contrast", &HeatObject::contrast, "Mean over its border of the absolute log ratio of the heat on both sides.")
    .def_readonly(
      "range",
      &HeatObject::range,
      "Range of border strengths over which its volume changes by less than a factor of 2, as a natural logarithm.")
    .def_readonly("compactness", &HeatObject::compactness, "36 pi volume^2 / surface^3: 1 for a ball.")
    .def_readonly("cut", &HeatObject::cut, "Share of its border at the border of the volume.")
    .def_readonly(
      "score",
      &HeatObject::score,
      "Of two objects of which one contains the other, a person more probably means the one with the greater score.")
    .def_readonly("probability", &HeatObject::probability, "Probability that it is one whole object, 0 to 1.");

  py::class_<HeatObjectList>(module, "HeatObjects", "Result of `find_objects`.")
    .def_readonly("objects", &HeatObjectList::objects, "By descending volume; the number of the first one is 1.")
    .def_property_readonly(
      "labels",
      [](const HeatObjectList & list) { return list.labels; },
      "uint16: the number of the smallest object at each voxel; 0 for none.")
    .def_property_readonly(
      "warnings",
      [](const HeatObjectList & list) {
        Remarks warnings;
        std::transform(list.warnings.begin(), list.warnings.end(), std::back_inserter(warnings), InPython);
        return warnings;
      },
      "What to do if no object was found.")
    .def(
      "mask",
      [](const HeatObjectList & list, int number) { return MaskOfObject(list, number); },
      "number"_a,
      ReleaseGil(),
      "uint8: 1 in an object, with those in it, otherwise 0.");

  module.def("find_objects", Reporting(&FindObjects), ReleaseGil());
}
} // namespace shapeton::python
