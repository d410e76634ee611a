#ifndef shapetonParticleMonitor_h
#define shapetonParticleMonitor_h

#include "ShapetonHeatToolsExport.h"
#include "shapetonPicture.h"
#include "shapetonParticleDiffusionImageFilter.h"

#include <memory>

namespace shapeton
{
class CommandLine;

/** Progress of a shapeton diffusion run, for display.
 * \ingroup ShapetonHeatTools */
struct ParticleProgress
{
  ParticleMeasures measures;
  std::uint64_t    timeSteps{ 0 };        ///< maximum number of steps of the run
  double           stepsPerSecond{ 0.0 }; ///< of all shapetons together; 0 if unknown
  double           epsilon{ 0.0 };        ///< largest change in a steady state
};

/** Three slices through `cut` with the visits so far in color, from blue (fewest) to red (most). The header shows
 * step, rate, coverage and distance from the steady state. \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT Picture::Pointer
                         DrawParticlePreview(const itk::Image<float, 3> *         gray,
                                             const itk::Image<std::uint32_t, 3> * visits,
                                             const itk::Index<3> &                cut,
                                             const ParticleProgress &             progress);

/** Mean position of the voxels with intensity above `lower`; the center of the volume if there are none.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT itk::Index<3>
                         MiddleOfObjects(const itk::Image<float, 3> * gray, double lower);

/** Resumes the filter from the checkpoint named by the parameter `resume`; the new checkpoint may replace it.
 * Throws InputError if the file is not a checkpoint, ParameterError if the run would end before its time step.
 * \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
ResumeFromCheckpoint(CommandLine & commandLine, ParticleDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** \class ParticleMonitor
 * \brief Preview and checkpoint of a shapeton diffusion run, declared by the parameters of the tool's XML: `preview`,
 * a PNG or the page of LiveExplorer (.html) replaced every `previewEvery` seconds, and `checkpoint`, a saved state
 * replaced about every minute.
 *
 * Finish() replaces both one last time. The picture shows a rate, so unlike results it differs between runs.
 *
 * \ingroup ShapetonHeatTools
 */
class ShapetonHeatTools_EXPORT ParticleMonitor
{
public:
  using FilterType = ParticleDiffusionImageFilter<itk::Image<float, 3>>;

  /** Registers the outputs and observes the filter, whose input must be set. Both must outlive the monitor. */
  ParticleMonitor(CommandLine & commandLine, FilterType * filter);
  ~ParticleMonitor();
  ParticleMonitor(const ParticleMonitor &) = delete;
  ParticleMonitor &
  operator=(const ParticleMonitor &) = delete;

  /** Call after the filter has run. */
  void
  Finish();

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // namespace shapeton

#endif
