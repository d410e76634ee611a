#ifndef shapetonShapetonMonitor_h
#define shapetonShapetonMonitor_h

#include "HeatToolsExport.h"
#include "shapetonPicture.h"
#include "shapetonShapetonDiffusionImageFilter.h"

#include <memory>

namespace shapeton
{
class CommandLine;

/** Progress of a shapeton diffusion run, for display.
 * \ingroup HeatTools */
struct ShapetonProgress
{
  ShapetonMeasures measures;
  std::uint64_t    timeSteps{ 0 };        ///< maximum number of steps of the run
  double           stepsPerSecond{ 0.0 }; ///< of all shapetons together; 0 if unknown
  double           epsilon{ 0.0 };        ///< largest change in a steady state
};

/** Three slices through `cut` with the visits so far in color, from blue (fewest) to red (most). The header shows
 * step, rate, coverage and distance from the steady state. \ingroup HeatTools */
HeatTools_EXPORT Picture::Pointer
                 DrawShapetonPreview(const itk::Image<float, 3> *         gray,
                                     const itk::Image<std::uint32_t, 3> * visits,
                                     const itk::Index<3> &                cut,
                                     const ShapetonProgress &             progress);

/** Mean position of the voxels with intensity above `lower`; the center of the volume if there are none.
 * \ingroup HeatTools */
HeatTools_EXPORT itk::Index<3>
                 MiddleOfObjects(const itk::Image<float, 3> * gray, double lower);

/** Resumes the filter from the checkpoint named by the parameter `resume`; the new checkpoint may replace it.
 * Throws InputError if the file is not a checkpoint, ParameterError if the run would end before its time step.
 * \ingroup HeatTools */
HeatTools_EXPORT void
ResumeFromCheckpoint(CommandLine & commandLine, ShapetonDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** \class ShapetonMonitor
 * \brief Preview and checkpoint of a shapeton diffusion run, declared by the parameters of the tool's XML: `preview`,
 * a PNG or the page of LiveExplorer (.html) replaced every `previewEvery` seconds, and `checkpoint`, a saved state
 * replaced about every minute.
 *
 * Finish() replaces both once more. The picture states a rate and so, unlike results, differs between runs.
 *
 * \ingroup HeatTools
 */
class HeatTools_EXPORT ShapetonMonitor
{
public:
  using FilterType = ShapetonDiffusionImageFilter<itk::Image<float, 3>>;

  /** Registers the outputs and observes the filter, whose input must be set. Both must outlive the monitor. */
  ShapetonMonitor(CommandLine & commandLine, FilterType * filter);
  ~ShapetonMonitor();
  ShapetonMonitor(const ShapetonMonitor &) = delete;
  ShapetonMonitor &
  operator=(const ShapetonMonitor &) = delete;

  /** Call after the filter has run. */
  void
  Finish();

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // namespace shapeton

#endif
