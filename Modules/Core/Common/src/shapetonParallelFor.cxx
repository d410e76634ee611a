#include "shapetonParallelFor.h"

#include "shapetonHelperThreads.h"
#include "shapetonOperatingSystem.h"

#include "itkMultiThreaderBase.h"

#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <list>
#include <mutex>
#include <string>

// Loops are compiled once here instead of for each body, because thread code dominates the build time.
namespace shapeton
{
namespace
{
/** Work divided into shares, each done once by the thread that takes it. */
struct SharedWork
{
  SharedWork(unsigned int number, std::function<void(unsigned int share)> work)
    : body(std::move(work)), shares(number), interruption(Interruption::OfThread())
  {
    std::fegetenv(&floatingPoint);
  }

  const std::function<void(unsigned int share)> body;
  const unsigned int                            shares;
  Interruption * const                          interruption;
  std::fenv_t                                   floatingPoint; ///< all threads calculate like the caller

  // Guarded by the mutex of the scheduler:
  unsigned int            taken{ 0 };
  unsigned int            running{ 0 };
  std::exception_ptr      failure;
  std::condition_variable hasEnded;
};

/** Distributes the shares of all open work to the calling threads and the helpers. A caller takes shares of its own
 * work only and waits only for running shares, so nested work always ends, whatever the helpers do. If a waiting caller
 * took shares of other work, it could encounter a lock that it already holds. */
class Scheduler
{
public:
  static Scheduler &
  Instance()
  {
    Scheduler * scheduler = s_Instance.load();
    if (!scheduler)
    {
      auto fresh = std::make_unique<Scheduler>();
      if (s_Instance.compare_exchange_strong(scheduler, fresh.get()))
      {
        scheduler = fresh.release(); // never destroyed, because helpers may outlive static objects
      }
    }
    return *scheduler;
  }

  Scheduler()
  {
    static std::once_flag isRegistered;
    std::call_once(isRegistered, CallAfterFork, StartAgainInChild);
    // The first ITK object sets up factories without locking; helpers must find them complete.
    itk::MultiThreaderBase::New();
    const char * const wanted = std::getenv("SHAPETON_THREADS_FROM");
    m_Threads = s_IsForked || (wanted && wanted == std::string("itk")) ? MakeItkThreads() : MakeThreads();
  }

  const char *
  NameOfLibrary() const
  {
    return m_Threads->NameOfLibrary();
  }

  void
  SetLimit(unsigned int threads)
  {
    const std::lock_guard<std::mutex> lock(m_Mutex);
    this->AdaptTo(threads);
  }

  /** Offers the untaken shares to the helpers. */
  void
  Open(SharedWork & work)
  {
    const std::lock_guard<std::mutex> lock(m_Mutex);
    this->AdaptTo(NumberOfThreads());
    for (unsigned int left = work.shares - work.taken; left > 0 && m_Helpers + 1 < m_Limit; --left)
    {
      m_Threads->Run([this] { this->Help(); });
      ++m_Helpers;
    }
    m_Open.push_back(&work);
  }

  /** Does a share that the caller has taken. */
  void
  Do(SharedWork & work, unsigned int share)
  {
    std::unique_lock<std::mutex> lock(m_Mutex);
    this->Do(work, share, lock);
  }

  /** Does the untaken shares and waits for the running ones. */
  void
  Finish(SharedWork & work)
  {
    std::unique_lock<std::mutex> lock(m_Mutex);
    while (work.taken < work.shares)
    {
      this->Do(work, this->Take(work), lock);
    }
    this->Wait(work, lock);
  }

  /** Drops the untaken shares and waits for the running ones. */
  void
  Cancel(SharedWork & work)
  {
    std::unique_lock<std::mutex> lock(m_Mutex);
    m_Open.remove(&work);
    this->Wait(work, lock);
  }

private:
  /** A forked process has no helpers, and its copy of the mutex may be locked. It uses ITK's pool, because oneTBB would
   * offer threads that do not exist. */
  static void
  StartAgainInChild()
  {
    s_IsForked = true;
    s_Instance = nullptr;
  }

  void
  AdaptTo(unsigned int threads)
  {
    if (threads != m_Limit)
    {
      m_Threads->SetLimit(threads);
      m_Limit = threads;
    }
  }

  /** Runs in a helper: does shares of the oldest open work, which is the outermost one, until none are left. */
  void
  Help()
  {
    std::unique_lock<std::mutex> lock(m_Mutex);
    while (!m_Open.empty())
    {
      SharedWork & work = *m_Open.front();
      this->Do(work, this->Take(work), lock);
    }
    --m_Helpers;
  }

  unsigned int
  Take(SharedWork & work)
  {
    const unsigned int share = work.taken++;
    if (work.taken == work.shares)
    {
      m_Open.remove(&work);
    }
    return share;
  }

  void
  Do(SharedWork & work, unsigned int share, std::unique_lock<std::mutex> & lock)
  {
    ++work.running;
    lock.unlock();
    const std::exception_ptr failure = Call(work, share);
    lock.lock();
    work.failure = work.failure ? work.failure : failure;
    if (--work.running == 0)
    {
      work.hasEnded.notify_all();
    }
  }

  static std::exception_ptr
  Call(const SharedWork & work, unsigned int share)
  {
    std::exception_ptr failure;
    std::fenv_t        before;
    std::fegetenv(&before);
    std::fesetenv(&work.floatingPoint);
    try
    {
      const Interruption::Inherited inherited(work.interruption);
      work.body(share);
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    std::fesetenv(&before);
    return failure;
  }

  static void
  Wait(SharedWork & work, std::unique_lock<std::mutex> & lock)
  {
    work.hasEnded.wait(lock, [&work] { return work.running == 0; });
  }

  static inline std::atomic<Scheduler *> s_Instance{ nullptr };
  static inline std::atomic<bool>        s_IsForked{ false };

  std::mutex                     m_Mutex;
  std::unique_ptr<HelperThreads> m_Threads;
  unsigned int                   m_Limit{ 0 };
  unsigned int                   m_Helpers{ 0 }; ///< requested or at work
  std::list<SharedWork *>        m_Open;         ///< with shares to take, the oldest first
};

void
Rethrow(const std::exception_ptr & failure)
{
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
} // namespace

unsigned int
NumberOfThreads()
{
  return std::max<unsigned int>(1, itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads());
}

void
SetNumberOfThreads(unsigned int number)
{
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(number);
  Scheduler::Instance().SetLimit(NumberOfThreads());
}

const char *
SourceOfThreads()
{
  return Scheduler::Instance().NameOfLibrary();
}

void
ParallelWorkers(unsigned int workers, const std::function<void(unsigned int worker)> & body)
{
  Interruption::Check();
  if (workers <= 1 || NumberOfThreads() == 1)
  {
    for (unsigned int worker = 0; worker < workers; ++worker)
    {
      body(worker);
    }
    return;
  }
  SharedWork  work(workers, std::cref(body));
  Scheduler & scheduler = Scheduler::Instance();
  work.taken = 1;
  scheduler.Open(work);
  scheduler.Do(work, 0);
  scheduler.Finish(work);
  Rethrow(work.failure);
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
  WorkBeside beside = StartBeside(second);
  first();
  beside.Get();
}

struct WorkBeside::Work : public SharedWork
{
  using SharedWork::SharedWork;
};

WorkBeside::WorkBeside() noexcept = default;

WorkBeside::WorkBeside(WorkBeside && other) noexcept = default;

WorkBeside &
WorkBeside::operator=(WorkBeside && other) noexcept
{
  std::swap(m_Work, other.m_Work);
  return *this;
}

WorkBeside::~WorkBeside()
{
  if (m_Work)
  {
    Scheduler::Instance().Cancel(*m_Work);
  }
}

void
WorkBeside::Get()
{
  if (const std::unique_ptr<Work> work = std::move(m_Work))
  {
    Scheduler::Instance().Finish(*work);
    Rethrow(work->failure);
  }
}

WorkBeside
StartBeside(std::function<void()> work)
{
  WorkBeside beside;
  beside.m_Work = std::make_unique<WorkBeside::Work>(1U, [work = std::move(work)](unsigned int) { work(); });
  if (NumberOfThreads() > 1)
  {
    Scheduler::Instance().Open(*beside.m_Work);
  }
  return beside;
}
} // namespace shapeton
