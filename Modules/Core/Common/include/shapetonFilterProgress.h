#ifndef shapetonFilterProgress_h
#define shapetonFilterProgress_h

#include "itkProcessObject.h"

namespace shapeton
{
/** Throws itk::ProcessAborted if AbortGenerateData is set on the filter. \ingroup ShapetonCommon */
inline void
AbortIfAsked(const itk::ProcessObject & filter)
{
  if (filter.GetAbortGenerateData())
  {
    throw itk::ProcessAborted(__FILE__, __LINE__);
  }
}

/** Reports the progress of a filter to its observers; throws itk::ProcessAborted if the filter is to be aborted.
 * Call it from the filter's thread only. \ingroup ShapetonCommon */
inline void
ReportProgress(itk::ProcessObject & filter, double share)
{
  filter.UpdateProgress(static_cast<float>(share));
  AbortIfAsked(filter);
}

/** Reports the progress of a filter again without setting it, because each setting would round it down. The thread and
 * exceptions are those of ReportProgress(). \ingroup ShapetonCommon */
inline void
RepeatProgress(itk::ProcessObject & filter)
{
  filter.InvokeEvent(itk::ProgressEvent());
  AbortIfAsked(filter);
}
} // namespace shapeton

#endif
