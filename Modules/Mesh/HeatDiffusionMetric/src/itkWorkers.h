#ifndef itkWorkers_h
#define itkWorkers_h

#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <exception>
#include <mutex>

namespace itk
{
/** Runs `body()` on up to `workers` workers of ITK's threader, at most as many as its settings allow. A worker may
 * start after another one has ended, so none may wait for one that has not begun. The first exception is thrown again
 * when all have ended; ITK's threader would lose those of all workers but one. */
template <typename TBody>
void
RunWorkers(unsigned int workers, const TBody & body)
{
  workers =
    std::min<unsigned int>(workers, std::max<unsigned int>(1, MultiThreaderBase::GetGlobalDefaultNumberOfThreads()));
  if (workers <= 1)
  {
    body();
    return;
  }
  std::mutex         mutex;
  std::exception_ptr failure;
  auto               threader = MultiThreaderBase::New();
  threader->SetNumberOfWorkUnits(workers);
  threader->ParallelizeArray(
    0,
    workers,
    [&](SizeValueType) {
      try
      {
        body();
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        failure = failure ? failure : std::current_exception();
      }
    },
    nullptr);
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
} // namespace itk

#endif
