#ifndef shapetonParallelInvoke_h
#define shapetonParallelInvoke_h

#include "BaseExport.h"

#include <functional>

namespace shapeton
{
/** Calls `first` on this thread and `second` at the same time on another one, where ITK's settings allow two; else one
 * after the other. Both may use ParallelFor(). Where both throw, the exception of `first` is thrown again.
 * \ingroup Base */
Base_EXPORT void
ParallelInvoke(const std::function<void()> & first, const std::function<void()> & second);
} // namespace shapeton

#endif
