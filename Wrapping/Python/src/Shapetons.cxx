#include "Bindings.h"
#include "Conversions.h"
#include "Diffusion.h"
#include "Options.h"

#include "shapetonExceptions.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticlePreset.h"
#include "shapetonVisitDensity.h"

namespace shapeton::python
{
namespace
{
using ImageType = itk::Image<float, 3>;
using FilterType = ParticleDiffusionImageFilter<ImageType>;
using Visits = FilterType::VisitsImageType;

/** Result of diffuse_shapetons(). */
struct Shapetons
{
  Visits::Pointer  visits;
  ParticleMeasures measures;
  HeatHistogram    histogram;
  double           distance;
  std::uint32_t    shapetons;
  std::string      reason;
  double           p;
  double           smoothing;
};

Shapetons
Diffuse(const ImageType::Pointer &                                image,
        const std::optional<FilterType::MaskImageType::Pointer> & mask,
        const Given<ShapetonPresetOptions> &                      given,
        const std::vector<std::string> &                          names,
        const std::string &                                       modality,
        const std::vector<std::uint64_t> &                        histogramSteps,
        const Progress &                                          progress)
{
  if (!modality.empty())
  {
    itk::EncapsulateMetaData(image->GetMetaDataDictionary(), DicomModality, modality);
  }
  const auto filter = FilterType::New();
  filter->SetInput(image);
  if (mask)
  {
    filter->SetMaskImage(*mask);
  }
  const auto choice = ChooseShapetonParameters(
    VolumeView(image.GetPointer()), given.options, names, progress.Part("Choosing parameters", 0.0, 0.0));
  filter->SetOptions(choice.options);
  filter->SetHistogramSteps(histogramSteps);
  UpdateWithProgress(filter.GetPointer(), "Diffusing shapetons", progress);
  return { filter->GetOutput(),    filter->GetMeasures(),         filter->GetHistogram(), filter->GetDistance(),
           filter->GetShapetons(), choice.feature.distanceReason, filter->GetP(),         filter->GetSmoothing() };
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
    .def_readonly("p", &Shapetons::p, "The p used.")
    .def_readonly("smoothing", &Shapetons::smoothing, "Standard deviation of the smoothing, mm.")
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
  module.def("diffuse_shapetons", Reporting(&Diffuse), ReleaseGil());
  module.def(
    "visit_density", [](const Visits::Pointer & visits) { return NormalizeVisits(visits); }, ReleaseGil());
  module.def(
    "classify_visits",
    [](const Visits::Pointer & visits) {
      const auto found = ClassifyVisits(visits, NormalizeVisits(visits));
      return std::make_pair(found.labels, found.classes);
    },
    ReleaseGil());
}
} // namespace shapeton::python
