#include "shapetonContainedProcess.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#  include <sys/prctl.h>
#endif
#if defined(__SANITIZE_ADDRESS__)
#  include <sanitizer/common_interface_defs.h>
#endif

namespace shapeton
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr char Done = 'D';
constexpr char Failed = 'F';
constexpr char OutOfMemory = 'M';

/** Held during each fork: ITK's threader joins the threads of its pool before a fork and restarts them afterwards;
 * two concurrent forks crash or hang. Also held while a channel has open ends that other children must not inherit. */
std::mutex forkMutex;

// A response is a header or an error message; pixels are in shared memory.
constexpr std::uint64_t MaximumMessageBytes = 256u << 20;

#ifdef MSG_NOSIGNAL
constexpr int SendFlags = MSG_NOSIGNAL;
#else
constexpr int SendFlags = 0;
#endif

bool
SendAll(int channel, const char * data, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t sent = send(channel, data, size, SendFlags);
    if (sent < 0 && errno == EINTR)
    {
      continue;
    }
    if (sent <= 0)
    {
      return false;
    }
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool
SendMessage(int channel, char kind, const std::string & text)
{
  const std::uint64_t size = text.size();
  char                head[1 + sizeof(size)];
  head[0] = kind;
  std::memcpy(head + 1, &size, sizeof(size));
  return SendAll(channel, head, sizeof(head)) && SendAll(channel, text.data(), text.size());
}

enum class Transfer
{
  complete,
  ended,
  outOfTime
};

Transfer
ReceiveAll(int channel, char * data, std::size_t size, Clock::time_point deadline)
{
  while (size > 0)
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0)
    {
      return Transfer::outOfTime;
    }
    pollfd    wanted{ channel, POLLIN, 0 };
    const int ready = poll(&wanted, 1, static_cast<int>(left < 1000 ? left : 1000));
    if (ready == 0 || (ready < 0 && errno == EINTR))
    {
      continue;
    }
    const ssize_t got = recv(channel, data, size, 0);
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      return Transfer::ended;
    }
    data += got;
    size -= static_cast<std::size_t>(got);
  }
  return Transfer::complete;
}

template <typename TResource> // an enumeration in glibc, a number elsewhere
void
SetLimit(TResource resource, rlim_t value)
{
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY || value < limit.rlim_max ? value : limit.rlim_max;
  setrlimit(resource, &limit);
}

/** Limits the memory that the process may allocate in addition to inherited memory. */
void
LimitMemory(std::size_t bytes)
{
  // Pages: total size, resident, shared, text, unused, data and stack. All remain 0 if the file does not exist.
  unsigned long pages[6] = {};
  std::ifstream status("/proc/self/statm");
  for (unsigned long & number : pages)
  {
    status >> number;
  }
  const auto page = static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  SetLimit(RLIMIT_DATA, pages[5] * page + bytes);
#if !defined(__SANITIZE_ADDRESS__) // the sanitizer has reserved terabytes of address space
  SetLimit(RLIMIT_AS, pages[0] * page + bytes);
#endif
}

/** Sets the CPU time limit of the next request; the system's limit counts from the start of the process. */
void
LimitComputingTime(unsigned int seconds)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  SetLimit(RLIMIT_CPU, static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1 + seconds);
}

/** Discards output printed by the libraries. */
void
SilenceStandardStreams()
{
#if defined(__SANITIZE_ADDRESS__)
  __sanitizer_set_report_fd(reinterpret_cast<void *>(static_cast<std::intptr_t>(dup(STDERR_FILENO))));
#endif
  const int nowhere = open("/dev/null", O_RDWR);
  if (nowhere >= 0)
  {
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
}

std::string
InMegabytes(std::size_t bytes)
{
  return std::to_string(bytes >> 20) + " MB";
}
} // namespace

ContainedProcess::ContainedProcess(Service service, std::size_t sharedBytes, const Limits & limits)
  : m_Service(std::move(service)), m_SharedBytes(sharedBytes), m_Limits(limits)
{
  if (m_SharedBytes > 0)
  {
    void * const memory = mmap(nullptr, m_SharedBytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
    {
      throw std::bad_alloc();
    }
    m_Shared = static_cast<char *>(memory);
  }
  try
  {
    this->Start();
  }
  catch (...)
  {
    if (m_Shared)
    {
      munmap(m_Shared, m_SharedBytes);
    }
    throw;
  }
}

ContainedProcess::~ContainedProcess()
{
  this->Stop();
  if (m_Shared)
  {
    munmap(m_Shared, m_SharedBytes);
  }
}

void
ContainedProcess::Start()
{
  std::unique_lock lock(forkMutex);
  int              channels[2];
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, channels) != 0)
  {
    throw std::runtime_error(std::string("cannot start the process that reads files: ") + std::strerror(errno));
  }
  const pid_t parent = getpid();
  m_Child = fork();
  if (m_Child < 0)
  {
    const int reason = errno;
    close(channels[0]);
    close(channels[1]);
    throw std::runtime_error(std::string("cannot start the process that reads files: ") + std::strerror(reason));
  }
  if (m_Child == 0)
  {
    lock.unlock(); // the child's copy
    close(channels[0]);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent)
    {
      _exit(0); // the parent died before the line above
    }
    this->Serve(channels[1]);
  }
  close(channels[1]);
  fcntl(channels[0], F_SETFD, FD_CLOEXEC);
  m_Channel = channels[0];
}

void
ContainedProcess::Stop()
{
  if (m_Child < 0)
  {
    return;
  }
  kill(m_Child, SIGKILL);
  while (waitpid(m_Child, nullptr, 0) < 0 && errno == EINTR)
  {}
  close(m_Channel);
  m_Child = -1;
  m_Channel = -1;
}

void
ContainedProcess::Serve(int channel) const
{
  for (const int number : { SIGTERM, SIGHUP, SIGABRT, SIGSEGV, SIGXCPU, SIGPIPE, SIGALRM })
  {
#if defined(__SANITIZE_ADDRESS__)
    if (number == SIGSEGV || number == SIGABRT)
    {
      continue; // reported by the sanitizer
    }
#endif
    signal(number, SIG_DFL);
  }
  signal(SIGINT, SIG_IGN); // the parent handles it
  SilenceStandardStreams();
  SetLimit(RLIMIT_CORE, 0);
  LimitMemory(m_Limits.memoryBytes);

  const auto never = Clock::time_point::max() - std::chrono::hours(1);
  for (;;)
  {
    char          head[1 + sizeof(std::uint64_t)];
    std::uint64_t size = 0;
    if (ReceiveAll(channel, head, sizeof(head), never) != Transfer::complete)
    {
      _exit(0);
    }
    std::memcpy(&size, head + 1, sizeof(size));
    char        kind = Done;
    std::string response;
    try
    {
      std::string request(size, '\0');
      if (ReceiveAll(channel, &request[0], request.size(), never) != Transfer::complete)
      {
        _exit(0);
      }
      LimitComputingTime(m_Limits.cpuSeconds);
      response = m_Service(request, m_Shared);
    }
    catch (const std::bad_alloc &)
    {
      kind = OutOfMemory;
    }
    catch (const std::exception & error)
    {
      kind = Failed;
      response = error.what();
    }
    catch (...)
    {
      kind = Failed;
      response = "unknown error";
    }
    if (!SendMessage(channel, kind, response))
    {
      _exit(0);
    }
  }
}

std::string
ContainedProcess::Call(const std::string & request)
{
  if (m_Child < 0)
  {
    this->Start();
  }
  if (!SendMessage(m_Channel, Done, request))
  {
    this->ReportDeath(false);
  }
  return this->Receive();
}

std::string
ContainedProcess::Receive()
{
  const auto    deadline = Clock::now() + std::chrono::seconds(m_Limits.wallSeconds);
  char          head[1 + sizeof(std::uint64_t)];
  std::uint64_t size = 0;
  Transfer      transfer = ReceiveAll(m_Channel, head, sizeof(head), deadline);
  std::string   text;
  if (transfer == Transfer::complete)
  {
    std::memcpy(&size, head + 1, sizeof(size));
    if (size > MaximumMessageBytes)
    {
      this->Stop();
      throw Failure("the file's header is larger than " + InMegabytes(MaximumMessageBytes));
    }
    text.resize(size);
    transfer = ReceiveAll(m_Channel, &text[0], text.size(), deadline);
  }
  if (transfer != Transfer::complete)
  {
    this->ReportDeath(transfer == Transfer::outOfTime);
  }
  switch (head[0])
  {
    case Done:
      return text;
    case OutOfMemory:
      this->Stop();
      throw Failure("reading it requires more than " + InMegabytes(m_Limits.memoryBytes) +
                    " of memory; the file is malformed");
    default:
      throw Failure(text);
  }
}

void
ContainedProcess::ReportDeath(bool outOfTime)
{
  if (outOfTime)
  {
    this->Stop();
    throw Failure("reading it took longer than " + std::to_string(m_Limits.wallSeconds) + " s");
  }
  int   status = 0;
  pid_t ended = -1;
  while ((ended = waitpid(m_Child, &status, 0)) < 0 && errno == EINTR)
  {}
  close(m_Channel);
  m_Child = -1;
  m_Channel = -1;
  if (ended > 0 && WIFSIGNALED(status))
  {
    if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)
    {
      throw Failure("reading it took more than " + std::to_string(m_Limits.cpuSeconds) +
                    " s of CPU time; the file is malformed");
    }
    throw Failure("the decoder crashed on it (signal " + std::to_string(WTERMSIG(status)) + "); the file is malformed");
  }
  throw Failure("the decoder failed on it; the file is malformed");
}
} // namespace shapeton
