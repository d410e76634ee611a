#include "Bindings.h"
#include "Conversions.h"
#include "Diffusion.h"
#include "Options.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonExceptions.h"
#include "shapetonHeatClassification.h"
#include "shapetonImageGrid.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>

namespace shapeton::python
{
namespace
{
using ImageType = itk::Image<float, 3>;
using MaskType = itk::Image<unsigned char, 3>;
using FilterType = CumulativeHeatDiffusionImageFilter<ImageType>;

/** Result of diffuse_heat(). */
struct Heat
{
  ImageType::Pointer            heat;
  ImageType::Pointer            initialHeat; // null unless requested
  CumulativeHeatDiffusionResult result;
  HeatParameterChoice           choice; // empty reasons with the published preset
};

/** Passes heat to a Python function while the filter runs. */
FilterType::SnapshotConsumer
ConsumerOf(const py::object & function)
{
  if (function.is_none())
  {
    return {};
  }
  return [&function](std::uint64_t step, const ImageType * heat) {
    const WithGil gil;
    const auto    image = ToPython<float>(heat);
    function(step, image.attr("like")(image.attr("array").attr("copy")())); // the filter continues with a separate copy
  };
}

Heat
Diffuse(const ImageType::Pointer &                    image,
        const std::optional<MaskType::Pointer> &      domain,
        const Given<CumulativeHeatDiffusionOptions> & given,
        const std::vector<std::string> &              names,
        const std::string &                           presetName,
        const std::string &                           modality,
        const std::vector<std::uint64_t> &            histogramSteps,
        const std::vector<std::uint64_t> &            snapshotSteps,
        const py::object &                            snapshot,
        bool                                          components,
        bool                                          initialHeat,
        const Progress &                              progress)
{
  CumulativeHeatDiffusionSettings settings;
  static_cast<CumulativeHeatDiffusionOptions &>(settings) = given.options;
  settings.histogramSteps = histogramSteps;
  settings.wantComponents = components;
  if (!modality.empty())
  {
    itk::EncapsulateMetaData(image->GetMetaDataDictionary(), DicomModality, modality);
  }
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetDomain(domain.value_or(nullptr));
  filter->SetOptions(settings);
  HeatParameterChoice choice;
  const bool isAutomatic = OptionInfo("preset").Words({ "automatic", "published" }).PositionOf(presetName) == 0;
  if (isAutomatic)
  {
    choice = ChooseHeatParameters(
      filter->GetVolume(), settings, GivenAmong(names, settings), progress.Part("Choosing parameters", 0.0, 0.0));
    filter->UseParameters(choice);
  }
  filter->SetSnapshotSteps(snapshotSteps, ConsumerOf(snapshot));
  filter->SetWantInitialHeat(initialHeat);
  UpdateWithProgress(filter.GetPointer(), "Diffusing heat", progress);
  Heat heat{ filter->GetOutput(), initialHeat ? filter->GetInitialHeatOutput() : nullptr, filter->GetResult(), choice };
  if (components)
  {
    heat.result.classes = ClassifyHeat(heat.heat, heat.result).classes;
  }
  return heat;
}

py::array
CountsOf(const HeatHistogram & histogram, const py::handle & owner)
{
  const std::uint32_t * const first = histogram.GetNumberOfRows() > 0 ? histogram.GetRow(0) : nullptr;
  return py::array_t<std::uint32_t>(
    { static_cast<py::ssize_t>(histogram.GetNumberOfRows()), static_cast<py::ssize_t>(HeatHistogram::NumberOfBins) },
    first,
    owner);
}

py::array_t<double>
LowerEdges()
{
  py::array_t<double> edges(HeatHistogram::NumberOfBins + 1);
  for (unsigned int bin = 0; bin <= HeatHistogram::NumberOfBins; ++bin)
  {
    edges.mutable_at(bin) = HeatHistogram::LowerEdge(bin);
  }
  return edges;
}

HeatHistogram
HistogramOf(const std::vector<ImageType::Pointer> & heats, const std::vector<std::uint64_t> & timeSteps)
{
  RequireParameter(heats.size() == timeSteps.size(), "the parameter \"time_steps\" must have one step per heat image");
  RequireParameter(std::adjacent_find(timeSteps.begin(), timeSteps.end(), std::greater_equal<>()) == timeSteps.end(),
                   "the parameter \"time_steps\" must be ascending");
  HeatHistogram histogram(timeSteps);
  for (std::size_t row = 0; row < heats.size(); ++row)
  {
    if (!HaveSameGrid(heats.front(), heats[row]))
    {
      throw InputError("the grids of the heat images 0 and " + std::to_string(row) + " differ");
    }
    RequireHeat(heats[row], "the heat image " + std::to_string(row));
    histogram.AddToRow(row, heats[row]->GetBufferPointer(), heats[row]->GetBufferedRegion().GetNumberOfPixels());
  }
  return histogram;
}

void
AddHistogram(py::module_ & module)
{
  py::class_<HeatHistogram>(module, "HeatHistogram", "Counts of voxels by heat, one row per recorded time step.")
    .def_property_readonly("time_steps", &HeatHistogram::GetTimeSteps, "Time steps of the rows, ascending.")
    .def_property_readonly(
      "counts",
      [](const py::object & self) { return CountsOf(self.cast<const HeatHistogram &>(), self); },
      "Rows x 4097, uint32: voxels in each bin; a view.")
    .def_property_readonly(
      "edges",
      [](const HeatHistogram &) { return LowerEdges(); },
      "4098 heat values: bin b contains edges[b] <= heat < edges[b + 1]. Bin 0 is the background, the others are 256 "
      "per factor of two.")
    .def("equalization",
         &HeatHistogram::GetEqualization,
         "4098 numbers from 0 to 1, ascending: the fraction of the counts, without bin 0, below the lower edge of "
         "each bin, averaged over the rows.")
    .def("__repr__", [](const HeatHistogram & histogram) {
      return "<shapeton.HeatHistogram of " + std::to_string(histogram.GetNumberOfRows()) + " time steps>";
    });

  module.def("heat_histogram", &HistogramOf, ReleaseGil());

  module.def("recorded_steps", [](std::uint64_t timeSteps, std::size_t snapshots, const std::string & spacing) {
    const auto words = OptionInfo("snapshotSpacing").Words({ "linear", "logarithmic" });
    return MakeSnapshotSteps(timeSteps, snapshots, static_cast<SnapshotSpacing>(words.PositionOf(spacing)));
  });
}

void
AddClasses(py::module_ & module)
{
  py::class_<HeatClass>(module, "HeatClass", "A class of voxels with similar heat: a line of the heat histogram.")
    .def_readonly("label", &HeatClass::label, "0 is the background, 1 the class of lowest heat.")
    .def_readonly("lower_heat", &HeatClass::lowerHeat, "The class contains lower_heat <= heat < upper_heat.")
    .def_readonly("upper_heat", &HeatClass::upperHeat, "See lower_heat.")
    .def_readonly("mean_heat", &HeatClass::meanHeat, "Mean heat, in [0, 1].")
    .def_readonly("voxels", &HeatClass::voxels, "Number of voxels.")
    .def_readonly("volume", &HeatClass::volume, "mm^3.")
    .def_readonly(
      "border_share", &HeatClass::borderShare, "Fraction of the voxels at the border of the volume, 0 to 1.")
    .def_readonly("coherence",
                  &HeatClass::coherence,
                  "Near 1 for a region bounded by edges, near 0 for speckle; None if not measured.")
    .def_readonly("components", &HeatClass::components, "Converged closed components in the class.")
    .def_readonly(
      "normalized_heat", &HeatClass::normalizedHeat, "Scale-invariant heat of closed components; 0 without any.");

  py::class_<ShapeComponent>(module, "ShapeComponent", "Voxels connected by edges of positive weight.")
    .def_property_readonly(
      "index",
      [](const ShapeComponent & c) { return py::make_tuple(c.index[2], c.index[1], c.index[0]); },
      "First voxel, [z, y, x].")
    .def_readonly("voxels", &ShapeComponent::voxels, "Number of voxels.")
    .def_readonly("volume", &ShapeComponent::volume, "mm^3.")
    .def_readonly("closed", &ShapeComponent::closed, "False if the component reaches the border of the volume.")
    .def_readonly("converged_heat", &ShapeComponent::convergedHeat, "Steady-state heat of each voxel.")
    .def_readonly("surface_area", &ShapeComponent::surfaceArea, "mm^2; 0 for an open component.")
    .def_readonly("normalized_heat", &ShapeComponent::normalizedHeat, "Area / (6 volume^(2/3)): 1 for a cube.");

  module.def(
    "classify_heat",
    [](const ImageType::Pointer &          heat,
       const std::vector<ShapeComponent> & components,
       unsigned int                        maximum,
       double                              backgroundHeat,
       double                              minimumShare,
       double                              minimumPeakToValley) {
      const auto require = [](const char * name, double value, double greatest) {
        RequireParameter(value >= 0.0 && value <= greatest,
                         std::string("the parameter \"") + name + "\" is out of range: 0 to " +
                           (greatest > 1.0 ? "any finite number" : "1"));
      };
      RequireParameter(maximum >= 1 && maximum <= 254,
                       "the parameter \"maximum_classes\" = " + std::to_string(maximum) + " must be 1 to 254");
      require("background_heat", backgroundHeat, 1.0);
      require("minimum_share", minimumShare, 1.0);
      require("minimum_peak_to_valley", minimumPeakToValley, std::numeric_limits<double>::max());
      const auto found = ClassifyHeat(heat, components, { maximum, backgroundHeat, minimumShare, minimumPeakToValley });
      return std::make_pair(found.labels, found.classes);
    },
    ReleaseGil());
}
} // namespace

void
AddHeat(py::module_ & module)
{
  AddHistogram(module);
  AddClasses(module);
  py::class_<Heat>(module, "HeatResult", "Result of `diffuse_heat`.")
    .def_readonly("heat", &Heat::heat, "Heat after the last step, in [0, 1]; float32, on the grid of the input.")
    .def_property_readonly(
      "initial_heat",
      [](const Heat & heat) { return heat.initialHeat ? std::optional(heat.initialHeat) : std::nullopt; },
      "Heat at step 0; None unless requested.")
    .def_property_readonly(
      "p", [](const Heat & heat) { return heat.result.p; }, "The p used.")
    .def_property_readonly(
      "reasons",
      [](const Heat & heat) {
        return std::map<std::string, std::string>{ { "intensity_window", heat.choice.windowReason },
                                                   { "p", heat.choice.pReason },
                                                   { "smoothing", heat.choice.smoothingReason },
                                                   { "time_steps", heat.choice.timeReason } };
      },
      "Reasons for the parameters chosen from the data; empty for given ones.")
    .def_property_readonly(
      "smoothing", [](const Heat & heat) { return heat.result.smoothing; }, "Standard deviation of the smoothing, mm.")
    .def_property_readonly(
      "classes",
      [](const Heat & heat) { return heat.result.classes; },
      "With coherence; empty unless components are requested.")
    .def_property_readonly(
      "window",
      [](const Heat & heat) { return py::make_tuple(heat.result.windowLower, heat.result.windowUpper); },
      "The intensities mapped to 0 and 1.")
    .def_property_readonly(
      "time_step", [](const Heat & heat) { return heat.result.timeStep; }, "The last step computed.")
    .def_property_readonly(
      "time_step_length", [](const Heat & heat) { return heat.result.timeStepLength; }, "dt, at most 1/12.")
    .def_property_readonly(
      "steady", [](const Heat & heat) { return heat.result.steady; }, "Whether the steady state was reached.")
    .def_property_readonly(
      "cold",
      [](const Heat & heat) { return heat.result.cold; },
      "Whether the volume has no edges; the heat is then 0 everywhere.")
    .def_property_readonly(
      "histogram",
      [](const Heat & heat) -> const HeatHistogram & { return heat.result.histogram; },
      py::return_value_policy::reference_internal,
      "One row per step of histogram_steps reached.")
    .def_property_readonly(
      "components", [](const Heat & heat) { return heat.result.components; }, "Largest first; empty unless requested.");

  module.def("diffuse_heat", Reporting(&Diffuse), ReleaseGil());
}
} // namespace shapeton::python
