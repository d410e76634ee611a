#ifndef shapetonStartBeside_h
#define shapetonStartBeside_h

#include "shapetonParallelFor.h"

#include <future>
#include <utility>

namespace shapeton
{
/** Starts a work on a thread of its own, where ITK's settings allow two; else it is done when it is waited for. Wait
 * for it by get(), which throws what the work has thrown; without get(), the destructor waits for one that has begun.
 * Such a thread is none of ITK's pool, and loops of the pool never wait for it; it must not start a ContainedProcess,
 * see there. It asks the Interruption of the thread that started it, which must outlive the work.
 * \ingroup Base */
template <typename TWork>
std::future<void>
StartBeside(TWork work)
{
  const auto policy = NumberOfThreads() > 1 ? std::launch::async : std::launch::deferred;
  itk::MultiThreaderBase::New(); // the first object of ITK sets up its factories and its pool, unlocked
  return std::async(policy, [work = std::move(work), interruption = Interruption::OfThread()] {
    const LoopDepth               inside(1); // as one of two workers
    const Interruption::Inherited inherited(interruption);
    work();
  });
}
} // namespace shapeton

#endif
