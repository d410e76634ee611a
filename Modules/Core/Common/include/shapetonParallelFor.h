#ifndef shapetonParallelFor_h
#define shapetonParallelFor_h

#include "ShapetonCommonExport.h"

#include "shapetonInterruption.h"
#include "shapetonProgress.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <thread>

namespace shapeton
{
/** Number of threads that ITK's settings allow. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT unsigned int
NumberOfThreads();

/** Nesting depth of parallel loops in this thread. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT unsigned int &
DepthOfLoops();

/** \class LoopDepth
 * \brief Sets DepthOfLoops() during its lifetime.
 * \ingroup ShapetonCommon */
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

/** Runs `body(worker)` on `workers` workers. Workers use ITK's threader; nested loops use separate threads, because
 * pool threads that wait for inner loops would leave no thread to run them. At the third nesting level the caller runs
 * the loop alone. A worker may start after another one has ended, so a worker must not wait for one that has not
 * started. The first exception is rethrown when all workers have ended; ITK's threader would keep the exception of one
 * worker only.
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
} // namespace shapeton

#endif
