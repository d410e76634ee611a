#ifndef shapetonParallelFor_h
#define shapetonParallelFor_h

#include "BaseExport.h"

#include "shapetonInterruption.h"
#include "shapetonProgress.h"

#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace shapeton
{
/** The number of threads that ITK's settings allow. \ingroup Base */
inline unsigned int
NumberOfThreads()
{
  return std::max<unsigned int>(1, itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
}

/** How many parallel loops the work of this thread lies in. \ingroup Base */
Base_EXPORT unsigned int &
DepthOfLoops();

/** \class LoopDepth
 * \brief Sets DepthOfLoops() for as long as it lives.
 * \ingroup Base */
class LoopDepth
{
public:
  explicit LoopDepth(unsigned int depth) : m_Before(DepthOfLoops()) { DepthOfLoops() = depth; }
  ~LoopDepth() { DepthOfLoops() = m_Before; }
  LoopDepth(const LoopDepth &) = delete;
  LoopDepth &
  operator=(const LoopDepth &) = delete;

private:
  unsigned int m_Before;
};

/** Calls work(worker) once for each of `workers` workers: the calling thread takes the first one, threads of their own
 * the others. `work` must not throw. \ingroup Base */
template <typename TWork>
void
OnOwnThreads(unsigned int workers, const TWork & work)
{
  std::vector<std::future<void>> others; // waited for when they go, whatever is thrown
  for (unsigned int worker = 1; worker < workers; ++worker)
  {
    others.push_back(std::async(std::launch::async, [&work, worker] { work(worker); }));
  }
  work(0U);
}

/** Runs `body(worker)` on `workers` workers: of ITK's threader, or within another loop on threads of their own, as
 * threads of ITK's pool that wait for loops would leave none to do them. A loop within a loop within a loop is done by
 * its caller alone. A worker may start after another one has ended, so none may wait for one that has not begun. The
 * first exception is thrown again when all workers have ended; ITK's threader would lose those of all workers but one.
 * \ingroup Base */
template <typename TBody>
void
ParallelWorkers(unsigned int workers, const TBody & body)
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
  const auto           work = [&](itk::SizeValueType worker) {
    const LoopDepth               inside(depth + 1);
    const Interruption::Inherited inherited(interruption);
    try
    {
      body(static_cast<unsigned int>(worker));
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
    threader->ParallelizeArray(0, workers, work, nullptr);
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

/** \class ProgressOfWorkers
 * \brief Lets one thread alone report progress, that which has made this object: the caller of workers is one of them.
 *
 * \ingroup Base */
class ProgressOfWorkers
{
public:
  explicit ProgressOfWorkers(const Progress & progress) : m_Progress(progress) {}

  /** Whether this thread may report. */
  bool
  IsReporter() const
  {
    return std::this_thread::get_id() == m_Reporter;
  }

  /** Reports if this thread may; all ask Interruption. */
  void
  operator()(double share) const
  {
    if (this->IsReporter())
    {
      m_Progress(share);
    }
    else
    {
      Interruption::Check();
    }
  }

private:
  const Progress &      m_Progress;
  const std::thread::id m_Reporter{ std::this_thread::get_id() };
};

/** Calls `body(i, worker)` for 0 <= i < number, each i once, in no certain order. Progress is reported after each i
 * that the calling thread has taken. After an exception, of a body or of progress, no other i is begun.
 *
 * \ingroup Base */
template <typename TBody>
void
ParallelForWorkers(std::size_t number, const TBody & body, const Progress & progress = {})
{
  std::atomic<std::size_t> next{ 0 };
  const ProgressOfWorkers  report(progress);
  ParallelWorkers(static_cast<unsigned int>(std::min<std::size_t>(NumberOfThreads(), number)),
                  [&](unsigned int worker) {
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
                  });
}

/** Calls `body(i)` for 0 <= i < number, each i once, in no certain order; for bodies that take a microsecond or more.
 * Progress as of ParallelForWorkers(). \ingroup Base */
template <typename TBody>
void
ParallelFor(std::size_t number, const TBody & body, const Progress & progress = {})
{
  ParallelForWorkers(
    number, [&body](std::size_t i, unsigned int) { body(i); }, progress);
}

/** ParallelFor() in blocks, for bodies that take less. \ingroup Base */
template <typename TBody>
void
ParallelForBlocks(std::size_t number, const TBody & body, const Progress & progress = {})
{
  constexpr std::size_t blockSize = 4096;
  ParallelFor((number + blockSize - 1) / blockSize,
              [&](std::size_t block) {
                const std::size_t end = std::min(number, (block + 1) * blockSize);
                for (std::size_t i = block * blockSize; i < end; ++i)
                {
                  body(i);
                }
              },
              progress);
}
} // namespace shapeton

#endif
