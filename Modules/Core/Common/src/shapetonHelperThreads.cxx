#include "shapetonHelperThreads.h"

#include "itkThreadPool.h"

#ifdef SHAPETON_USE_TBB
#  include <tbb/global_control.h>
#  include <tbb/task_arena.h>

#  include <optional>
#endif

namespace shapeton
{
namespace
{
class ItkThreads : public HelperThreads
{
public:
  const char *
  NameOfLibrary() const override
  {
    return "ITK";
  }

  void
  SetLimit(unsigned int threads) override
  {
    // One thread more than the helpers, so that ITK filters always find one.
    const auto pool = itk::ThreadPool::GetInstance();
    const auto present = pool->GetMaximumNumberOfThreads();
    if (present < threads)
    {
      pool->AddThreads(threads - present);
    }
  }

  void
  Run(const std::function<void()> & task) override
  {
    itk::ThreadPool::GetInstance()->AddWork(task);
  }
};

#ifdef SHAPETON_USE_TBB
class TbbThreads : public HelperThreads
{
public:
  const char *
  NameOfLibrary() const override
  {
    return "oneTBB";
  }

  void
  SetLimit(unsigned int threads) override
  {
    m_Control.reset(); // the lowest of several limits counts
    m_Control.emplace(tbb::global_control::max_allowed_parallelism, threads);
    if (threads > 1)
    {
      m_Arena.emplace(static_cast<int>(threads - 1), 0U); // no place for callers, who take no tasks of others
    }
  }

  void
  Run(const std::function<void()> & task) override
  {
    m_Arena->enqueue(task);
  }

private:
  std::optional<tbb::global_control> m_Control;
  std::optional<tbb::task_arena>     m_Arena;
};
#endif
} // namespace

std::unique_ptr<HelperThreads>
MakeItkThreads()
{
  return std::make_unique<ItkThreads>();
}

std::unique_ptr<HelperThreads>
MakeThreads()
{
#ifdef SHAPETON_USE_TBB
  return std::make_unique<TbbThreads>();
#else
  return MakeItkThreads();
#endif
}
} // namespace shapeton
