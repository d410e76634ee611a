#ifndef itkParallelFor_h
#define itkParallelFor_h

#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace itk
{
/** Calls `body(i)` for 0 <= i < number on ITK's threads, each i once, in no certain order. The first exception is
 * thrown again when all have ended. */
template <typename TBody>
void
ParallelFor(std::size_t number, const TBody & body)
{
  std::atomic<std::size_t> next{ 0 };
  std::mutex               mutex;
  std::exception_ptr       failure;
  const auto               work = [&](SizeValueType) {
    try
    {
      for (std::size_t i = next++; i < number; i = next++)
      {
        body(i);
      }
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = failure ? failure : std::current_exception();
    }
  };
  const std::size_t allowed = std::max<std::size_t>(1, MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
  const auto        workers = std::min(allowed, number);
  if (workers <= 1)
  {
    work(0);
  }
  else
  {
    auto threader = MultiThreaderBase::New();
    threader->SetNumberOfWorkUnits(static_cast<ThreadIdType>(workers));
    threader->ParallelizeArray(0, workers, work, nullptr);
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
} // namespace itk

#endif
