#include "shapetonOperatingSystem.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#  include <sys/prctl.h>
#endif
#if defined(__SANITIZE_ADDRESS__)
#  include <sanitizer/common_interface_defs.h>
#endif

extern char ** environ;

namespace shapeton
{
namespace
{
/** File actions of posix_spawn. */
class SpawnActions
{
public:
  /** Passes descriptors as 3, 4, and so on, and no others. */
  explicit SpawnActions(const std::vector<int> & descriptors)
  {
    posix_spawn_file_actions_init(&m_Actions);
    const auto end = FirstInheritedDescriptor + static_cast<int>(descriptors.size());
    for (const int descriptor : descriptors)
    {
      m_Copies.emplace_back(fcntl(descriptor, F_DUPFD_CLOEXEC, end)); // so that no target is also a source
      const auto target = FirstInheritedDescriptor + static_cast<int>(m_Copies.size()) - 1;
      posix_spawn_file_actions_adddup2(&m_Actions, m_Copies.back().Get(), target);
    }
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
    posix_spawn_file_actions_addclosefrom_np(&m_Actions, end);
#endif
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&m_Actions); }
  SpawnActions(const SpawnActions &) = delete;
  SpawnActions &
  operator=(const SpawnActions &) = delete;

  const posix_spawn_file_actions_t *
  Get() const
  {
    return &m_Actions;
  }

private:
  posix_spawn_file_actions_t  m_Actions;
  std::vector<FileDescriptor> m_Copies;
};

/** Signals of a started program: SIGINT is blocked, and all others have their default action. */
class SpawnSignals
{
public:
  SpawnSignals()
  {
    posix_spawnattr_init(&m_Attributes);
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    posix_spawnattr_setsigmask(&m_Attributes, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&m_Attributes, &signals);
    posix_spawnattr_setflags(&m_Attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSignals() { posix_spawnattr_destroy(&m_Attributes); }
  SpawnSignals(const SpawnSignals &) = delete;
  SpawnSignals &
  operator=(const SpawnSignals &) = delete;

  const posix_spawnattr_t *
  Get() const
  {
    return &m_Attributes;
  }

private:
  posix_spawnattr_t m_Attributes;
};

/** A part of this library. */
const char anchor = 0;

template <typename TResource> // an enumeration in glibc, a number elsewhere
void
SetLimit(TResource resource, rlim_t value)
{
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY || value < limit.rlim_max ? value : limit.rlim_max;
  setrlimit(resource, &limit);
}
} // namespace

// posix_spawn instead of Boost.Process, which forks: ITK's threader joins the threads of its pool before each fork, so
// no other thread could use the pool, and the child could inherit its locks.
ChildProcess::ChildProcess(const std::string &              program,
                           const std::vector<std::string> & arguments,
                           const std::vector<int> &         descriptors)
{
  std::vector<char *> words{ const_cast<char *>(program.c_str()) };
  for (const std::string & argument : arguments)
  {
    words.push_back(const_cast<char *>(argument.c_str()));
  }
  words.push_back(nullptr);
  const SpawnActions actions(descriptors);
  const SpawnSignals signals;
  pid_t              child = -1;
  const int          reason = posix_spawn(&child, program.c_str(), actions.Get(), signals.Get(), words.data(), environ);
  if (reason != 0)
  {
    throw std::runtime_error("cannot start the program \"" + program + "\": " + std::strerror(reason));
  }
  m_Number = child;
}

ChildProcess::~ChildProcess() { this->Kill(); }

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
ChildProcess::Kill()
{
  if (this->IsRunning())
  {
    kill(m_Number, SIGKILL);
    this->Wait();
  }
}

int
ProcessNumber()
{
  return getpid();
}

bool
EndWithParent(int parent)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  return getppid() == parent;
}

void
SilenceThisProcess()
{
  SetLimit(RLIMIT_CORE, 0);
#if defined(__SANITIZE_ADDRESS__)
  __sanitizer_set_report_fd(reinterpret_cast<void *>(static_cast<std::intptr_t>(dup(STDERR_FILENO))));
#endif
  const int nowhere = open("/dev/null", O_RDWR);
  if (nowhere >= 0)
  {
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  if (nowhere > STDERR_FILENO)
  {
    close(nowhere);
  }
}

MemoryLimit::MemoryLimit()
{
  // Pages: total size, resident, shared, text, unused, data and stack. All remain 0 if the file does not exist.
  unsigned long pages[6] = {};
  std::ifstream status("/proc/self/statm");
  for (unsigned long & number : pages)
  {
    status >> number;
  }
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  m_TotalBytes = pages[0] * page;
  m_DataBytes = pages[5] * page;
}

void
MemoryLimit::Set(std::size_t privateBytes, std::size_t sharedBytes) const
{
  SetLimit(RLIMIT_DATA, m_DataBytes + privateBytes);
#if defined(__SANITIZE_ADDRESS__) // the sanitizer has reserved terabytes of address space
  (void)sharedBytes;
#else
  SetLimit(RLIMIT_AS, m_TotalBytes + privateBytes + sharedBytes);
#endif
}

void
LimitComputingTime(unsigned int seconds)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  // The system's limit counts from the start of the process.
  SetLimit(RLIMIT_CPU, static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1 + seconds);
}

bool
WasOutOfComputingTime(const ChildProcess::End & end)
{
  return end.isSignal && (end.number == SIGXCPU || end.number == SIGKILL);
}

std::string
FolderOfThisLibrary()
{
  const auto address = reinterpret_cast<std::uintptr_t>(&anchor);
#ifdef __linux__
  // dladdr() returns the name of a program as typed, which may be relative to the folder where it was started.
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    std::uintptr_t begin = 0;
    std::uintptr_t end = 0;
    char           dash = 0;
    std::istringstream(line) >> std::hex >> begin >> dash >> end;
    const std::size_t path = line.find('/');
    if (begin <= address && address < end && path != std::string::npos)
    {
      return std::filesystem::path(line.substr(path)).parent_path().string();
    }
  }
#endif
  Dl_info info{};
  return dladdr(&anchor, &info) != 0 ? std::filesystem::absolute(info.dli_fname).parent_path().string() : std::string();
}
} // namespace shapeton
