#ifndef shapetonParallelInvoke_h
#define shapetonParallelInvoke_h

#include "ShapetonCommonExport.h"

#include <functional>

namespace shapeton
{
/** Calls `first` on this thread and `second` concurrently on another one if ITK's settings allow two threads, otherwise
 * one after the other. Both may use ParallelFor(). If both throw, the exception of `first` is rethrown.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
ParallelInvoke(const std::function<void()> & first, const std::function<void()> & second);
} // namespace shapeton

#endif
