#include "shapetonOperatingSystem.h"

#include <atomic>
#include <csignal>
#include <iterator>

#include <unistd.h>

namespace shapeton
{
/** An entry of the list that the handlers traverse. Nodes are never freed, because a handler may run in any thread at
 * any time; only `isWanted` changes. */
struct RemovalAtDeath::Node
{
  std::string       path;
  Node *            next;
  std::atomic<bool> isWanted{ true };
};

namespace
{
std::atomic<RemovalAtDeath::Node *> newest{ nullptr };
std::atomic<bool>                   isDelayed{ false };
std::atomic<int>                    delayedSignal{ 0 };
std::atomic<pid_t>                  owner{ 0 }; // a forked child inherits the list, but the files belong to the parent

volatile std::sig_atomic_t pendingSignal = 0;

constexpr int deferred[] = { SIGINT, SIGTERM, SIGHUP }; // wait until the end of a delay
constexpr int requests[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGALRM, SIGXCPU }; // by the user or the system
constexpr int crashes[] = { SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL };                     // of this process

void
RemoveAll()
{
  if (getpid() != owner.load())
  {
    return;
  }
  for (const RemovalAtDeath::Node * node = newest.load(); node; node = node->next)
  {
    if (node->isWanted.load() && unlink(node->path.c_str()) != 0)
    {
      rmdir(node->path.c_str());
    }
  }
}

extern "C" void
ShapetonDieTidily(int signal)
{
  RemoveAll();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

extern "C" void
ShapetonDieTidilyUnlessDelayed(int signal)
{
  if (isDelayed.load())
  {
    delayedSignal.store(signal);
    return;
  }
  ShapetonDieTidily(signal);
}

void
InstallWhereDefault(int signal, void (*handler)(int))
{
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) != 0 || (action.sa_flags & SA_SIGINFO) || action.sa_handler != SIG_DFL)
  {
    return;
  }
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigfillset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}
} // namespace

void
RemovalAtDeath::InstallHandlers()
{
  owner.store(getpid());
  for (const int signal : requests)
  {
    InstallWhereDefault(signal, ShapetonDieTidilyUnlessDelayed);
  }
  for (const int signal : crashes)
  {
    InstallWhereDefault(signal, ShapetonDieTidily);
  }
  InstallWhereDefault(SIGXFSZ, SIG_IGN); // a write beyond the limit fails with EFBIG instead
}

RemovalAtDeath::RemovalAtDeath(const std::string & path) : m_Node(new Node{ path, newest.load() })
{
  while (!newest.compare_exchange_weak(m_Node->next, m_Node))
  {}
}

RemovalAtDeath::RemovalAtDeath(RemovalAtDeath && other) noexcept : m_Node(other.m_Node) { other.m_Node = nullptr; }

RemovalAtDeath::~RemovalAtDeath()
{
  if (m_Node)
  {
    m_Node->isWanted.store(false);
  }
}

DeathDelay::DeathDelay() { isDelayed.store(true); }

DeathDelay::~DeathDelay()
{
  isDelayed.store(false);
  if (const int signal = delayedSignal.exchange(0))
  {
    raise(signal);
  }
}

DeferredSignals::DeferredSignals()
{
  pendingSignal = 0;
  for (std::size_t i = 0; i < std::size(deferred); ++i)
  {
    m_Previous[i] = std::signal(deferred[i], [](int signal) { pendingSignal = signal; });
  }
}

DeferredSignals::~DeferredSignals()
{
  for (std::size_t i = 0; i < std::size(deferred); ++i)
  {
    std::signal(deferred[i], m_Previous[i]);
  }
  if (pendingSignal != 0)
  {
    std::raise(pendingSignal);
  }
}

bool
DeferredSignals::IsPending()
{
  return pendingSignal != 0;
}
} // namespace shapeton
