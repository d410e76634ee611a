#ifndef shapetonParallelFor_h
#define shapetonParallelFor_h

#include "ShapetonCommonExport.h"

#include "shapetonInterruption.h"
#include "shapetonProgress.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <thread>

// Loops over threads. All loops of a process, nested or not, share NumberOfThreads() - 1 helper threads; the calling
// thread always works, too. Helpers come from oneTBB, or from ITK's thread pool if Shapeton was built without oneTBB or
// the environment variable SHAPETON_THREADS_FROM is "itk". Results do not depend on the number or source of helpers.
namespace shapeton
{
/** The thread limit: itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads(). \ingroup ShapetonCommon */
ShapetonCommon_EXPORT unsigned int
NumberOfThreads();

/** Limits the threads of these loops, of ITK filters, and of VTK and OpenCV where these use oneTBB. At least 1.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
SetNumberOfThreads(unsigned int number);

/** Name of the library that provides the helper threads: "oneTBB" or "ITK". \ingroup ShapetonCommon */
ShapetonCommon_EXPORT const char *
SourceOfThreads();

/** Calls `body(worker)` once for each worker < `workers`. The calling thread takes worker 0; helpers that are free take
 * others, and the calling thread takes those that are left. So a worker must not wait for one that has not started.
 * All workers are called, even after an exception; then the first exception is rethrown.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
ParallelWorkers(unsigned int workers, const std::function<void(unsigned int worker)> & body);

/** \class ProgressOfWorkers
 * \brief Restricts progress reports to the thread that constructed this object; the caller of the workers is one of
 * them.
 *
 * \ingroup ShapetonCommon */
class ProgressOfWorkers
{
public:
  explicit ProgressOfWorkers(const Progress & progress) : m_Progress(progress) {}

  /** Whether this thread reports progress. */
  bool
  IsReporter() const
  {
    return std::this_thread::get_id() == m_Reporter;
  }

  /** Reports if this thread is the reporter; every thread checks Interruption. */
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

/** Calls `body(i, worker)` once for each i with 0 <= i < number, in unspecified order. Progress is reported after each
 * i processed by the calling thread. After an exception, from a body or from progress, no further i is started.
 *
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
ParallelForWorkers(std::size_t                                                     number,
                   const std::function<void(std::size_t i, unsigned int worker)> & body,
                   const Progress &                                                progress = {});

/** Calls `body(i)` once for each i with 0 <= i < number, in unspecified order; for bodies that take a microsecond or
 * more. Progress is reported as in ParallelForWorkers(). \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
ParallelFor(std::size_t number, const std::function<void(std::size_t i)> & body, const Progress & progress = {});

/** ParallelFor() in blocks, for shorter bodies. \ingroup ShapetonCommon */
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

/** Calls `first` on this thread, and `second` concurrently if a helper is free, otherwise afterwards. If both throw,
 * the exception of `first` is rethrown. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
ParallelInvoke(const std::function<void()> & first, const std::function<void()> & second);

/** \class WorkBeside
 * \brief Work started by StartBeside(). The destructor waits for it if it has started, and drops it otherwise.
 *
 * \ingroup ShapetonCommon */
class ShapetonCommon_EXPORT WorkBeside
{
public:
  WorkBeside() noexcept;
  WorkBeside(WorkBeside && other) noexcept;
  WorkBeside &
  operator=(WorkBeside && other) noexcept;
  ~WorkBeside();

  /** Whether Get() must still be called. */
  bool
  IsPending() const
  {
    return m_Work != nullptr;
  }

  /** Waits for the work, or does it in this thread if no helper has started it; rethrows its exception. Does nothing if
   * no work is pending. */
  void
  Get();

private:
  struct Work;
  friend ShapetonCommon_EXPORT WorkBeside
  StartBeside(std::function<void()> work);

  std::unique_ptr<Work> m_Work;
};

/** Lets a helper do `work` as soon as one is free. The work uses the Interruption of this thread, which must outlive
 * it. \ingroup ShapetonCommon */
[[nodiscard]] ShapetonCommon_EXPORT WorkBeside
StartBeside(std::function<void()> work);
} // namespace shapeton

#endif
