#ifndef shapetonParallelInvoke_h
#define shapetonParallelInvoke_h

#include "shapetonParallelFor.h"

namespace shapeton
{
/** Calls `first` on this thread and `second` at the same time on another one, where ITK's settings allow two; else one
 * after the other. Both may use ParallelFor(). Where both throw, the exception of `first` is thrown again.
 * \ingroup Base */
template <typename TFirst, typename TSecond>
void
ParallelInvoke(const TFirst & first, const TSecond & second)
{
  if (NumberOfThreads() == 1)
  {
    first();
    second();
    return;
  }
  // So that ITK's pool has a free thread for filters of ITK in `second`, which keeps one.
  itk::MultiThreaderBase::New()->SetMaximumNumberOfThreads(2);
  std::exception_ptr failures[2];
  ParallelWorkers(2, [&](unsigned int worker) {
    try
    {
      worker == 0 ? first() : second();
    }
    catch (...)
    {
      failures[worker] = std::current_exception();
    }
  });
  for (const std::exception_ptr & failure : failures)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
}
} // namespace shapeton

#endif
