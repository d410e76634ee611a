#ifndef shapetonFilterProgress_h
#define shapetonFilterProgress_h

#include "itkProcessObject.h"

namespace shapeton
{
/** Throws itk::ProcessAborted where the filter is to be aborted. \ingroup Base */
inline void
AbortIfAsked(const itk::ProcessObject & filter)
{
  if (filter.GetAbortGenerateData())
  {
    throw itk::ProcessAborted(__FILE__, __LINE__);
  }
}

/** Hands the share of a filter's work on to ITK's observers; throws itk::ProcessAborted where the filter is to be
 * aborted. From the thread of the filter only. \ingroup Base */
inline void
ReportProgress(itk::ProcessObject & filter, double share)
{
  filter.UpdateProgress(static_cast<float>(share));
  AbortIfAsked(filter);
}
} // namespace shapeton

#endif
