#ifndef shapetonShapetonMonitor_h
#define shapetonShapetonMonitor_h

#include "HeatToolsExport.h"
#include "shapetonPicture.h"
#include "shapetonShapetonDiffusionImageFilter.h"

#include <memory>

namespace shapeton
{
class CommandLine;

/** How far a run of shapeton diffusion has come, for a person who watches.
 * \ingroup HeatTools */
struct ShapetonProgress
{
  ShapetonMeasures measures;
  std::uint64_t    timeSteps{ 0 };        ///< that the run takes at most
  double           stepsPerSecond{ 0.0 }; ///< of all shapetons together; 0 where it is not known
  double           epsilon{ 0.0 };        ///< greatest change of a steady state
};

/** Three slices through `cut` with the visits so far in colour, red for most and blue for fewest, and above them step,
 * rate, coverage and distance from the steady state. \ingroup HeatTools */
HeatTools_EXPORT Picture::Pointer
                 DrawShapetonPreview(const itk::Image<float, 3> *         grey,
                                     const itk::Image<std::uint32_t, 3> * visits,
                                     const itk::Index<3> &                cut,
                                     const ShapetonProgress &             progress);

/** The voxel in the middle of all whose intensity lies above `lower`; the middle of the volume where none does.
 * \ingroup HeatTools */
HeatTools_EXPORT itk::Index<3>
                 MiddleOfObjects(const itk::Image<float, 3> * grey, double lower);

/** Has the filter go on from the checkpoint that the parameter `resume` names, which the new checkpoint may replace.
 * Throws InputError for a file that is no checkpoint, ParameterError where the run would end before it.
 * \ingroup HeatTools */
HeatTools_EXPORT void
ResumeFromCheckpoint(CommandLine & commandLine, ShapetonDiffusionImageFilter<itk::Image<float, 3>> * filter);

/** \class ShapetonMonitor
 * \brief What a tool shows and saves while shapetons diffuse, by the parameters of its XML: `preview`, a PNG or the
 * page of LiveExplorer (.html) that is replaced every `previewEvery` seconds, and `checkpoint`, a saved state that is
 * replaced about every minute.
 *
 * Both are replaced once more by Finish(). The picture states a rate and is, unlike results, not the same in two runs.
 *
 * \ingroup HeatTools
 */
class HeatTools_EXPORT ShapetonMonitor
{
public:
  using FilterType = ShapetonDiffusionImageFilter<itk::Image<float, 3>>;

  /** Registers the outputs and begins to watch the filter, whose input must be set. Both must outlive the monitor. */
  ShapetonMonitor(CommandLine & commandLine, FilterType * filter);
  ~ShapetonMonitor();
  ShapetonMonitor(const ShapetonMonitor &) = delete;
  ShapetonMonitor &
  operator=(const ShapetonMonitor &) = delete;

  /** To be called when the filter has run. */
  void
  Finish();

private:
  struct Impl;
  std::unique_ptr<Impl> m_Impl;
};
} // namespace shapeton

#endif
