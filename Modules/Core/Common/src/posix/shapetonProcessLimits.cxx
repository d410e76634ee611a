#include "shapetonOperatingSystem.h"

#include <cstdint>
#include <fcntl.h>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>
#if defined(__SANITIZE_ADDRESS__)
#  include <sanitizer/common_interface_defs.h>
#endif

namespace shapeton
{
namespace
{
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
  // The system counts CPU time from the start of the process.
  SetLimit(RLIMIT_CPU, static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1 + seconds);
}
} // namespace shapeton
