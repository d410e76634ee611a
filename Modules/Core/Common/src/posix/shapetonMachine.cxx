#include "shapetonOperatingSystem.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>
#ifdef __linux__
#  include <sys/mman.h>
#endif

namespace shapeton
{
namespace
{
std::string
TextOf(const std::tm & parts, const char * format)
{
  constexpr std::size_t longest = 128;
  char                  text[longest];
  return { text, std::strftime(text, longest, format, &parts) };
}
} // namespace

std::string
PathOfThisProgram(std::error_code & error)
{
  return std::filesystem::read_symlink("/proc/self/exe", error).string();
}

std::string
UniversalTimeText(std::time_t time, const char * format)
{
  std::tm parts{};
  gmtime_r(&time, &parts);
  return TextOf(parts, format);
}

std::string
LocalTimeText(std::time_t time, const char * format)
{
  std::tm parts{};
  localtime_r(&time, &parts);
  return TextOf(parts, format);
}

namespace
{
/** A part of this library. */
const char anchor = 0;

// Several threads may discard standard error; the first one redirects, the last one restores.
std::mutex quietMutex;
int        quietUsers = 0;
int        savedStandardError = -1;
} // namespace

double
PhysicalMemory()
{
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void
RequestHugePages([[maybe_unused]] void * memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
  madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

std::string
HostName()
{
  char host[256] = {};
  gethostname(host, sizeof(host) - 1);
  return host;
}

bool
IsTerminal()
{
  return isatty(STDOUT_FILENO) != 0;
}

std::size_t
TerminalColumns()
{
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

void
OpenMissingStandardStreams()
{
  for (const int descriptor : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
    {
      open("/dev/null", O_RDWR); // open() returns the lowest free descriptor, which is this one
    }
  }
}

QuietStandardError::QuietStandardError()
{
  const std::lock_guard<std::mutex> lock(quietMutex);
  if (quietUsers++ == 0)
  {
    savedStandardError = dup(STDERR_FILENO);
    const FileDescriptor nowhere(open("/dev/null", O_WRONLY | O_CLOEXEC));
    if (savedStandardError >= 0 && nowhere.Get() >= 0)
    {
      dup2(nowhere.Get(), STDERR_FILENO);
    }
  }
}

QuietStandardError::~QuietStandardError()
{
  const std::lock_guard<std::mutex> lock(quietMutex);
  std::cerr.flush();
  std::fflush(stderr);
  if (--quietUsers == 0 && savedStandardError >= 0)
  {
    dup2(savedStandardError, STDERR_FILENO);
    close(savedStandardError);
  }
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
