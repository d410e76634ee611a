#include "Bindings.h"
#include "Conversions.h"
#include "Diffusion.h"

#include "shapetonExceptions.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonVisitDensity.h"

namespace shapeton::python
{
namespace
{
using ImageType = itk::Image<float, 3>;
using FilterType = ParticleDiffusionImageFilter<ImageType>;
using Visits = FilterType::VisitsImageType;

const Words<DirectionSampling> samplingWords{ { "solidAngle", DirectionSampling::SolidAngle },
                                              { "sectorArea", DirectionSampling::SectorArea },
                                              { "uniform", DirectionSampling::Uniform } };
const Words<PathRule>          pathWords{ { "endpoint", PathRule::Endpoint }, { "traversal", PathRule::Traversal } };
const Words<ParticlePlacement> placementWords{ { "uniform", ParticlePlacement::Uniform },
                                               { "initialHeat", ParticlePlacement::InitialHeat } };

/** Result of diffuse_shapetons(). */
struct Shapetons
{
  Visits::Pointer  visits;
  ParticleMeasures measures;
  HeatHistogram    histogram;
  double           distance;
  std::uint32_t    shapetons;
  std::string      reason;
};

void
SetChoices(FilterType *        filter,
           const std::string & directionSampling,
           const std::string & pathRule,
           const std::string & placement)
{
  filter->SetDirectionSampling(ValueOf(directionSampling, "direction_sampling", samplingWords));
  filter->SetPathRule(ValueOf(pathRule, "path_rule", pathWords));
  filter->SetPlacement(ValueOf(placement, "placement", placementWords));
}

void
SetSteps(FilterType *                       filter,
         std::optional<std::uint32_t>       shapetons,
         double                             distance,
         std::optional<double>              featureSize,
         std::uint64_t                      timeSteps,
         const std::vector<std::uint64_t> & histogramSteps)
{
  filter->SetNumberOfShapetons(shapetons.value_or(filter->GetNumberOfShapetons()));
  filter->SetDistance(distance);
  filter->SetFeatureSize(featureSize.value_or(0.0));
  filter->SetAutomaticDistance(featureSize.has_value());
  filter->SetAutomaticNumberOfShapetons(featureSize.has_value() && !shapetons);
  filter->SetTimeSteps(timeSteps);
  filter->SetHistogramSteps(histogramSteps);
}

Shapetons
Diffuse(const ImageType::Pointer &                                image,
        const std::optional<FilterType::MaskImageType::Pointer> & mask,
        double                                                    p,
        const Window &                                            window,
        std::optional<std::uint32_t>                              shapetons,
        double                                                    distance,
        std::optional<double>                                     featureSize,
        std::uint64_t                                             timeSteps,
        const std::string &                                       directionSampling,
        const std::string &                                       pathRule,
        const std::string &                                       placement,
        std::uint64_t                                             seed,
        bool                                                      untilSteady,
        std::optional<double>                                     epsilon,
        const std::vector<std::uint64_t> &                        histogramSteps,
        const Progress &                                          progress)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  if (mask)
  {
    filter->SetMaskImage(*mask);
  }
  filter->SetP(p);
  SetWindow(window, filter.GetPointer());
  SetSteps(filter, shapetons, distance, featureSize, timeSteps, histogramSteps);
  SetChoices(filter, directionSampling, pathRule, placement);
  filter->SetSeed(seed);
  filter->SetUntilSteady(untilSteady);
  filter->SetAutomaticEpsilon(!epsilon);
  filter->SetEpsilon(epsilon.value_or(filter->GetEpsilon()));
  UpdateWithProgress(filter.GetPointer(), "Diffusing shapetons", progress);
  return { filter->GetOutput(),   filter->GetMeasures(),          filter->GetHistogram(),
           filter->GetDistance(), filter->GetNumberOfShapetons(), filter->GetAutomaticShapetons().distanceReason };
}

template <typename TMember>
auto
Measure(TMember ParticleMeasures::*member)
{
  return [member](const Shapetons & shapetons) { return shapetons.measures.*member; };
}

void
AddResult(py::module_ & module)
{
  py::class_<Shapetons>(module, "ShapetonResult", "Result of `diffuse_shapetons`.")
    .def_readonly("visits", &Shapetons::visits, "Number of visits of each voxel; uint32. The sum is shapetons x steps.")
    .def_property_readonly(
      "density",
      [](const Shapetons & s) { return NormalizeVisits(s.visits); },
      "Visits divided by their maximum, in [0, 1]; float32, computed on access.")
    .def_property_readonly("time_step", Measure(&ParticleMeasures::step), "The last step computed.")
    .def_property_readonly("steady", Measure(&ParticleMeasures::steady), "Whether the steady state was reached.")
    .def_property_readonly(
      "change", Measure(&ParticleMeasures::change), "Change of the density in the last step (3.10).")
    .def_property_readonly(
      "coverage",
      [](const Shapetons & s) { return s.measures.GetCoverage(); },
      "Fraction of the object voxels reached, 0 to 1.")
    .def_property_readonly(
      "trapped", Measure(&ParticleMeasures::trappedShapetons), "Shapetons in voxels disconnected from all neighbors.")
    .def_readonly("shapetons", &Shapetons::shapetons, "Number of shapetons.")
    .def_readonly("distance", &Shapetons::distance, "Step length, in units of the longest side.")
    .def_readonly(
      "reason_of_distance", &Shapetons::reason, "Reason for the distance, if chosen by feature_size; otherwise empty.")
    .def_property_readonly(
      "histogram",
      [](const Shapetons & s) -> const HeatHistogram & { return s.histogram; },
      py::return_value_policy::reference_internal,
      "One row per step of histogram_steps.");
}
} // namespace

void
AddShapetons(py::module_ & module)
{
  AddResult(module);
  const auto defaults = FilterType::New();
  module.def("diffuse_shapetons",
             Reporting(&Diffuse),
             "image"_a,
             py::kw_only(),
             "mask"_a = py::none(),
             "p"_a = defaults->GetP(),
             "window"_a = py::none(),
             "shapetons"_a = py::none(),
             "distance"_a = defaults->GetDistance(),
             "feature_size"_a = py::none(),
             "time_steps"_a = defaults->GetTimeSteps(),
             "direction_sampling"_a = WordOf(defaults->GetDirectionSampling(), samplingWords),
             "path_rule"_a = WordOf(defaults->GetPathRule(), pathWords),
             "placement"_a = WordOf(defaults->GetPlacement(), placementWords),
             "seed"_a = defaults->GetSeed(),
             "until_steady"_a = defaults->GetUntilSteady(),
             "epsilon"_a = defaults->GetEpsilon(),
             "histogram_steps"_a = std::vector<std::uint64_t>(),
             "progress"_a = py::none(),
             ReleaseGil(),
             R"(Shapeton diffusion: counts the visits of particles that perform a random walk through a volume.

image: intensities; not copied if float32 and C-contiguous. mask: shapetons start where it is nonzero.
p: steepness, from 0. window: (lower, upper) intensities mapped to 0 and 1; None: minimum and maximum.
shapetons: their number; None: 65000, or chosen from feature_size.
distance: step length in (0, 1], in units of the longest side of the volume.
feature_size: mm; sets distance, and shapetons, if these are None.
time_steps: at least 1.
direction_sampling: "solidAngle", "sectorArea" or "uniform". path_rule: "endpoint" or "traversal".
placement: "uniform" or "initialHeat". seed: the same seed gives the same visits.
until_steady: stops when the density changes by less than epsilon (3.10); None: chosen from the run.
histogram_steps: ascending steps, from 1, that become rows of the histogram.
progress: called with (share, stage) ten times a second; returning False, an exception or Ctrl-C aborts.

The visits are byte-identical for any number of threads.)");

  module.def(
    "visit_density",
    [](const Visits::Pointer & visits) { return NormalizeVisits(visits); },
    "visits"_a,
    ReleaseGil(),
    "Visits divided by their maximum: float32 in [0, 1].");
  module.def(
    "classify_visits",
    [](const Visits::Pointer & visits) {
      const auto found = ClassifyVisits(visits, NormalizeVisits(visits));
      return std::make_pair(found.labels, found.classes);
    },
    "visits"_a,
    ReleaseGil(),
    "The classes of a uint32 image of visits, analogous to `classify_heat`: (labels, classes).");
}
} // namespace shapeton::python
