#include "Bindings.h"
#include "Conversions.h"
#include "Diffusion.h"
#include "Options.h"

#include "shapetonAutomaticParameters.h"
#include "shapetonExceptions.h"
#include "shapetonHeatSeeds.h"
#include "shapetonImageGrid.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"

#include <atomic>
#include <map>
#include <mutex>
#include <thread>
#include <optional>

namespace shapeton::python
{
namespace
{
using ImageType = itk::Image<float, 3>;
using MaskType = itk::Image<unsigned char, 3>;
using SeedFilter = SeededHeatSegmentationImageFilter<ImageType>;

/** Result of SeededHeat.segment(). */
struct SeededLabels
{
  SeedImage::Pointer                           labels;
  ImageType::Pointer                           uncertainty;
  std::map<unsigned short, ImageType::Pointer> probabilities; ///< by label; empty unless requested
  unsigned int                                 iterations;
  Remarks                                      warnings;
};

/** A volume to be labeled from seeds repeatedly. */
class SeededHeat
{
public:
  SeededHeat(const ImageType::Pointer &                   image,
             const std::optional<MaskType::Pointer> &     domain,
             const Given<SeededHeatSegmentationOptions> & given,
             bool                                         automaticP)
  {
    CheckOptions(given.options);
    if (domain && !HaveSameGrid(image, *domain))
    {
      throw InputError("the grids of the domain and of the image differ; use a mask on the grid of the image");
    }
    m_Filter->SetInput(image);
    m_Filter->SetDomain(domain.value_or(nullptr));
    m_Filter->SetOptions(given.options);
    if (automaticP)
    {
      m_Filter->SetP(ChooseP(m_Filter->GetVolume(), given.options).p);
    }
  }

  SeededLabels
  Segment(const SeedImage::Pointer & seeds,
          const SeedImage::Pointer & before,
          bool                       wantsProbabilities,
          const Progress &           progress)
  {
    RequireParameter(m_Worker != std::this_thread::get_id(),
                     "a progress function called `segment` of the reporting object; create another SeededHeat");
    const std::lock_guard<std::mutex> lock(m_Mutex); // Python threads may share this object
    const Working                     working(m_Worker);
    if (!HaveSameGrid(m_Filter->GetInput(), seeds))
    {
      throw InputError("the grids of the seeds and of the image differ; use a label map on the grid of the image");
    }
    if (before && !HaveSameGrid(m_Filter->GetInput(), before))
    {
      throw InputError("the grids of the labels before and of the image differ");
    }
    m_Filter->SetSeeds(seeds);
    m_Filter->SetLabelsBefore(before);
    UpdateWithProgress(m_Filter.GetPointer(), "Diffusing heat from the seeds", progress);
    SeededLabels result{
      m_Filter->GetOutput(), m_Filter->GetUncertaintyOutput(), {}, m_Filter->GetIterations(), m_Filter->GetRemarks()
    };
    if (wantsProbabilities)
    {
      for (const unsigned short label : m_Filter->GetLabelValues())
      {
        result.probabilities[label] = m_Filter->GetProbabilities(label);
      }
    }
    result.labels->DisconnectPipeline(); // the next call allocates a new output
    result.uncertainty->DisconnectPipeline();
    return result;
  }

private:
  /** Marks this thread as the running thread. */
  class Working
  {
  public:
    explicit Working(std::atomic<std::thread::id> & worker) : m_Worker(worker)
    {
      m_Worker = std::this_thread::get_id();
    }
    ~Working() { m_Worker = std::thread::id(); }

  private:
    std::atomic<std::thread::id> & m_Worker;
  };

  const SeedFilter::Pointer    m_Filter{ SeedFilter::New() };
  std::mutex                   m_Mutex;
  std::atomic<std::thread::id> m_Worker{ std::thread::id() };
};

SeedImage::Pointer
SeedsOf(const SeedImage::Pointer & classes, const std::vector<int> & chosen, int components)
{
  return SeedsOfClasses(classes, { chosen, components });
}
} // namespace

void
AddSeeds(py::module_ & module)
{
  py::class_<SeededLabels>(module, "SeededLabels", "Result of `SeededHeat.segment`.")
    .def_readonly("labels", &SeededLabels::labels, "uint16: the label of highest probability.")
    .def_readonly("uncertainty",
                  &SeededLabels::uncertainty,
                  "float32: 1 minus the difference of the two greatest probabilities; 0 if one label is certain.")
    .def_readonly("probabilities",
                  &SeededLabels::probabilities,
                  "By label, an image: float32 in [0, 1]; the images sum to 1. Empty unless requested.")
    .def_readonly(
      "iterations", &SeededLabels::iterations, "Number of solver iterations; few after a small change of the seeds.")
    .def_readonly("warnings", &SeededLabels::warnings, "Labels that hardly extend beyond their seeds, one per line.");

  py::class_<SeededHeat>(module, "_SeededHeat")
    .def(py::init<const ImageType::Pointer &,
                  const std::optional<MaskType::Pointer> &,
                  const Given<SeededHeatSegmentationOptions> &,
                  bool>())
    .def("segment",
         Reporting(+[](SeededHeat &                              heat,
                       const SeedImage::Pointer &                seeds,
                       const std::optional<SeedImage::Pointer> & before,
                       bool                                      probabilities,
                       const Progress &                          progress) {
           return heat.Segment(seeds, before.value_or(nullptr), probabilities, progress);
         }),
         ReleaseGil());

  module.def("seeds_of_classes", &SeedsOf, ReleaseGil());
}
} // namespace shapeton::python
