#include "shapetonOperatingSystem.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#ifdef __linux__
#  include <sys/prctl.h>
#endif

namespace shapeton
{
namespace
{
/** What the child does before it becomes the program. */
struct StartPlan
{
  char * const *                   words;
  std::vector<std::pair<int, int>> descriptors; // from, to
  int                              firstClosed{ -1 };
  int                              signalWithParent{ SIGTERM };
  bool                             hasDefaultSignals{ false };
  sigset_t                         blocked{};
};

/** Handlers of the parent must not run in the child; other settings remain, such as those of nohup. */
void
ResetHandlers(bool all)
{
  for (int number = 1; number < NSIG; ++number)
  {
    struct sigaction action = {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_DFL &&
        (all || action.sa_handler != SIG_IGN))
    {
      action.sa_handler = SIG_DFL;
      action.sa_flags = 0;
      sigaction(number, &action, nullptr);
    }
  }
}

/** Runs in the child, which shares the memory of the parent until exec(): system calls only. Returns errno in case of
 * an error. */
int
BecomeProgram(const StartPlan & plan, pid_t parent)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, plan.signalWithParent);
  if (getppid() != parent) // the parent died before that call
  {
    _exit(1);
  }
#endif
  for (const auto & [from, to] : plan.descriptors)
  {
    dup2(from, to);
  }
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
  if (plan.firstClosed >= 0)
  {
    closefrom(plan.firstClosed);
  }
#endif
  ResetHandlers(plan.hasDefaultSignals);
  pthread_sigmask(SIG_SETMASK, &plan.blocked, nullptr);
  execv(plan.words[0], plan.words);
  return errno;
}

pid_t
StartProgram(const std::string & program, const std::vector<std::string> & arguments, StartPlan & plan)
{
  std::vector<char *> words{ const_cast<char *>(program.c_str()) };
  for (const std::string & argument : arguments)
  {
    words.push_back(const_cast<char *>(argument.c_str()));
  }
  words.push_back(nullptr);
  plan.words = words.data();
  // No target of a copy may also be a source.
  std::vector<FileDescriptor> sources;
  for (auto & copy : plan.descriptors)
  {
    constexpr int unusedTarget = 16;
    sources.emplace_back(fcntl(copy.first, F_DUPFD_CLOEXEC, unusedTarget));
    copy.first = sources.back().Get();
  }
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  if (!plan.hasDefaultSignals)
  {
    plan.blocked = before;
  }
  const pid_t  parent = getpid();
  volatile int error = 0; // written by the child
  const pid_t  child = vfork();
  if (child == 0)
  {
    error = BecomeProgram(plan, parent); // NOLINT(clang-analyzer-unix.Vfork): see there
    _exit(127);
  }
  if (child < 0)
  {
    error = errno;
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (error != 0)
  {
    while (child > 0 && waitpid(child, nullptr, 0) < 0 && errno == EINTR)
    {}
    throw std::system_error(error, std::generic_category());
  }
  return child;
}
} // namespace

Pipe::Pipe()
{
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) // atomically: another thread may start a program concurrently
  {
    throw std::system_error(errno, std::generic_category());
  }
  m_Output = FileDescriptor(ends[0]);
  m_Input = FileDescriptor(ends[1]);
}

void
ReadPipes(const Pipe & first, const TakePipeBytes & takeFirst, const Pipe & second, const TakePipeBytes & takeSecond)
{
  pollfd polled[2] = { { first.GetOutput(), POLLIN, 0 }, { second.GetOutput(), POLLIN, 0 } };
  char   buffer[65536];
  while (polled[0].fd >= 0 || polled[1].fd >= 0)
  {
    if (poll(polled, 2, -1) < 0)
    {
      continue; // interrupted by a signal
    }
    for (pollfd & pipe : polled)
    {
      const ssize_t number = pipe.fd >= 0 && pipe.revents != 0 ? read(pipe.fd, buffer, sizeof(buffer)) : -2;
      if (number > 0)
      {
        (&pipe == &polled[0] ? takeFirst : takeSecond)(buffer, static_cast<std::size_t>(number));
      }
      else if (number == 0 || (number == -1 && errno != EINTR))
      {
        pipe.fd = -1;
      }
    }
  }
}

ChildProcess
ChildProcess::StartTool(const std::string &              program,
                        const std::vector<std::string> & arguments,
                        const Pipe &                     out,
                        const Pipe &                     err)
{
  const FileDescriptor none(open("/dev/null", O_RDONLY | O_CLOEXEC));
  StartPlan            plan;
  plan.descriptors = { { none.Get(), STDIN_FILENO },
                       { out.GetInput(), STDOUT_FILENO },
                       { err.GetInput(), STDERR_FILENO } };
  return { StartProgram(program, arguments, plan), plan.signalWithParent };
}

ChildProcess
ChildProcess::StartIsolated(const std::string &              program,
                            const std::vector<std::string> & arguments,
                            const std::vector<int> &         descriptors)
{
  StartPlan plan;
  plan.signalWithParent = SIGKILL;
  plan.hasDefaultSignals = true;
  sigaddset(&plan.blocked, SIGINT);
  plan.firstClosed = FirstInheritedDescriptor;
  for (const int descriptor : descriptors)
  {
    plan.descriptors.emplace_back(descriptor, plan.firstClosed++);
  }
  return { StartProgram(program, arguments, plan), plan.signalWithParent };
}

ChildProcess::~ChildProcess() { this->Stop(); }

ChildProcess::End
ChildProcess::Wait()
{
  int   status = 0;
  pid_t ended = -1;
  while ((ended = waitpid(m_Number, &status, 0)) < 0 && errno == EINTR)
  {}
  m_Number = -1;
  if (ended < 0)
  {
    return {};
  }
  return WIFSIGNALED(status) ? End{ true, WTERMSIG(status) } : End{ false, WEXITSTATUS(status) };
}

void
ChildProcess::Stop()
{
  if (this->IsRunning())
  {
    kill(m_Number, m_Signal);
    this->Wait();
  }
}

int
ProcessNumber()
{
  return getpid();
}

bool
IsProcessAlive(long number)
{
  return kill(static_cast<pid_t>(number), 0) == 0 || errno != ESRCH;
}

bool
WasKilled(const ChildProcess::End & end)
{
  return end.isSignal && (end.number == SIGXCPU || end.number == SIGKILL);
}

void
CallAfterFork(void (*function)())
{
  pthread_atfork(nullptr, nullptr, function);
}
} // namespace shapeton
