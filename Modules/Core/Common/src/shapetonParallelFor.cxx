#include "shapetonParallelFor.h"

#include "shapetonParallelInvoke.h"
#include "shapetonStartBeside.h"

#include "itkMultiThreaderBase.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <vector>

// Loops are compiled once here instead of for each body, because thread code dominates the build time.
namespace shapeton
{
namespace
{
// Calls work(worker) once for each of `workers` workers: the calling thread runs the first one, separate threads the
// others. `work` must not throw.
void
OnOwnThreads(unsigned int workers, const std::function<void(unsigned int)> & work)
{
  std::vector<std::future<void>> others; // joined on destruction, even after an exception
  for (unsigned int worker = 1; worker < workers; ++worker)
  {
    others.push_back(std::async(std::launch::async, [&work, worker] { work(worker); }));
  }
  work(0U);
}
} // namespace

unsigned int
NumberOfThreads()
{
  return std::max<unsigned int>(1, itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
}

unsigned int &
DepthOfLoops()
{
  static thread_local unsigned int depth = 0;
  return depth;
}

void
ParallelWorkers(unsigned int workers, const std::function<void(unsigned int worker)> & body)
{
  constexpr unsigned int deepest = 2;
  const unsigned int     depth = DepthOfLoops();
  Interruption::Check();
  if (workers <= 1 || depth >= deepest)
  {
    for (unsigned int worker = 0; worker < workers; ++worker)
    {
      body(worker);
    }
    return;
  }
  std::mutex           mutex;
  std::exception_ptr   failure;
  Interruption * const interruption = Interruption::OfThread();
  const auto           work = [&](unsigned int worker) {
    const LoopDepth               inside(depth + 1);
    const Interruption::Inherited inherited(interruption);
    try
    {
      body(worker);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = failure ? failure : std::current_exception();
    }
  };
  if (depth > 0)
  {
    OnOwnThreads(workers, work);
  }
  else
  {
    const auto threader = itk::MultiThreaderBase::New();
    threader->SetNumberOfWorkUnits(workers);
    threader->ParallelizeArray(
      0, workers, [&work](itk::SizeValueType i) { work(static_cast<unsigned int>(i)); }, nullptr);
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

void
ParallelForWorkers(std::size_t                                                     number,
                   const std::function<void(std::size_t i, unsigned int worker)> & body,
                   const Progress &                                                progress)
{
  std::atomic<std::size_t> next{ 0 };
  const ProgressOfWorkers  report(progress);
  const auto               work = [&](unsigned int worker) {
    try
    {
      for (std::size_t i = next++; i < number; i = next++)
      {
        body(i, worker);
        report(static_cast<double>(i + 1) / static_cast<double>(number));
      }
    }
    catch (...)
    {
      next = number;
      throw;
    }
  };
  ParallelWorkers(static_cast<unsigned int>(std::min<std::size_t>(NumberOfThreads(), number)), work);
}

void
ParallelFor(std::size_t number, const std::function<void(std::size_t i)> & body, const Progress & progress)
{
  ParallelForWorkers(
    number, [&body](std::size_t i, unsigned int) { body(i); }, progress);
}

void
ParallelInvoke(const std::function<void()> & first, const std::function<void()> & second)
{
  if (NumberOfThreads() == 1)
  {
    first();
    second();
    return;
  }
  // Leaves a thread of ITK's pool for ITK filters in `second`, which itself occupies one.
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

std::future<void>
StartBeside(std::function<void()> work)
{
  const auto policy = NumberOfThreads() > 1 ? std::launch::async : std::launch::deferred;
  itk::MultiThreaderBase::New(); // the first ITK object sets up factories and the thread pool without locking
  return std::async(policy, [work = std::move(work), interruption = Interruption::OfThread()] {
    const LoopDepth               inside(1); // as one of two workers
    const Interruption::Inherited inherited(interruption);
    work();
  });
}
} // namespace shapeton
