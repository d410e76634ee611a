#include "FuzzTrial.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
constexpr int Read = 40;
constexpr int Refused = 41;
constexpr int WrongException = 42;

/** Placeholder for the library if a contained process has reached its memory limit. */
constexpr const char * MemoryLimit = "(limit of memory)";

// Mutants have a few thousand bytes. A sanitizer keeps freed memory for a while.
#if defined(__SANITIZE_ADDRESS__)
constexpr long MostKilobytes = 1500 * 1024;
#else
constexpr long MostKilobytes = 700 * 1024;
#endif

[[noreturn]] void
Work(const std::string & path, const std::string & log, const FuzzTrial::Reader & reader)
{
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  setpgid(0, 0); // to kill contained processes with this one
  const rlimit noCore{ 0, 0 };
  setrlimit(RLIMIT_CORE, &noCore);
  int status = WrongException;
  try
  {
    status = reader(path) ? Read : Refused;
  }
  catch (const std::exception & error)
  {
    std::fprintf(stderr, "exception: %s\n", error.what());
  }
  std::fflush(nullptr);
  _exit(status);
}

std::string
TextOf(const std::string & path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

bool
BeginsWithAny(const std::string & text, const std::vector<std::string> & starts)
{
  return std::any_of(
    starts.begin(), starts.end(), [&](const std::string & start) { return text.rfind(start, 0) == 0; });
}

/** Library of a stack frame, "(/usr/lib/libfoo.so.1+0x12)"; empty for libraries in every stack. */
std::string
LibraryOf(const std::string & frame)
{
  if (frame.find("/libsanitizer/") != std::string::npos)
  {
    return {};
  }
  const auto open = frame.rfind('(');
  const auto plus = frame.find('+', open);
  if (open == std::string::npos || plus == std::string::npos)
  {
    return frame.find(" in ") != std::string::npos ? "our sources" : "";
  }
  const std::string path = frame.substr(open + 1, plus - open - 1);
  const std::string name = path.substr(path.rfind('/') + 1);
  const bool        isEverywhere =
    BeginsWithAny(name, { "libasan", "libubsan", "libc.so", "libstdc++", "libgcc", "libm.so", "ld-linux" });
  return isEverywhere ? "" : name;
}

bool
IsForeign(const std::string & library)
{
  return BeginsWithAny(
    library, { "libdcm", "libof", "libgdcm", "libITK", "libitk", "libopenjp2", "libcharls", "libz.", "libjpeg" });
}

std::string
FirstLineOf(const std::string & text)
{
  return text.substr(0, text.find('\n'));
}

/** Library at fault in a sanitizer's report: the first library of the stack that is not in every stack. */
std::string
LibraryAtFault(const std::string & report)
{
  std::istringstream stream(report);
  for (std::string line; std::getline(stream, line);)
  {
    const auto number = line.find_first_not_of(' ');
    if (number != std::string::npos && line[number] == '#')
    {
      const std::string library = LibraryOf(line);
      if (!library.empty())
      {
        return library;
      }
    }
  }
  return "unknown";
}

/** An allocation in any library that the sanitizer refuses, where operator new would throw an exception. */
bool
IsRefusedAllocation(const std::string & report)
{
  const std::string sanitizer = "ERROR: AddressSanitizer: ";
  return BeginsWithAny(report,
                       { sanitizer + "allocator is out of memory",
                         sanitizer + "out-of-memory",
                         sanitizer + "out of memory",
                         sanitizer + "allocation-size-too-big",
                         sanitizer + "requested allocation size" });
}

/** The sanitizer reports in a log; each ends where the next one begins. */
std::vector<std::string>
ReportsIn(const std::string & log)
{
  std::set<std::size_t> places;
  for (const char * sign : { "runtime error: ", "ERROR: AddressSanitizer: ", "ERROR: LeakSanitizer: " })
  {
    for (auto place = log.find(sign); place != std::string::npos; place = log.find(sign, place + 1))
    {
      places.insert(place);
    }
  }
  std::vector<std::string> reports;
  for (auto place = places.begin(); place != places.end(); ++place)
  {
    const auto next = std::next(place);
    reports.push_back(log.substr(*place, next == places.end() ? std::string::npos : *next - *place));
  }
  return reports;
}

/** What a contained process reported, although the reader read or rejected the file. */
struct Containment
{
  /** A fault, with its library; empty if there is none. */
  std::string fault;
  /** The library that crashed, or the limit of memory; empty if there is none. */
  std::string contained;
};

Containment
ContainmentOf(const std::vector<std::string> & reports)
{
  Containment found;
  for (const std::string & report : reports)
  {
    const bool        isRefused = IsRefusedAllocation(report);
    const std::string library = isRefused ? MemoryLimit : LibraryAtFault(report);
    const bool isUndefined = BeginsWithAny(report, { "runtime error" }); // only Shapeton is instrumented for this
    if (!isRefused && (isUndefined || !IsForeign(library)))
    {
      found.fault = FirstLineOf(report) + " in " + library;
      return found;
    }
    found.contained = library;
  }
  return found;
}
} // namespace

FuzzTrial::FuzzTrial(const std::string &  path,
                     const std::string &  log,
                     const Reader &       reader,
                     std::chrono::seconds limit)
  : m_Path(path), m_Log(log), m_Start(std::chrono::steady_clock::now()), m_Limit(limit)
{
  m_Child = fork();
  if (m_Child == 0)
  {
    Work(path, log, reader);
  }
  if (m_Child < 0)
  {
    throw std::runtime_error("cannot start a process");
  }
}

bool
FuzzTrial::HasEnded()
{
  int         status = 0;
  rusage      usage{};
  const pid_t ended = wait4(m_Child, &status, WNOHANG, &usage);
  if (ended == 0)
  {
    if (std::chrono::steady_clock::now() - m_Start > m_Limit && !m_IsOutOfTime)
    {
      m_IsOutOfTime = true;
      kill(-m_Child, SIGKILL);
      kill(m_Child, SIGKILL);
    }
    return false;
  }
  this->Judge(status, usage.ru_maxrss);
  kill(-m_Child, SIGKILL);
  return true;
}

void
FuzzTrial::Judge(int status, long peakKilobytes)
{
  const auto        reports = ReportsIn(TextOf(m_Log));
  const std::string first = reports.empty() ? "" : FirstLineOf(reports.front());
  const Containment containment = ContainmentOf(reports);
  const int         exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  m_Outcome.kind = FuzzOutcome::Kind::fault;
  if (m_IsOutOfTime)
  {
    m_Outcome.reason = "hang: more than " + std::to_string(m_Limit.count()) + " s";
  }
  else if (WIFSIGNALED(status))
  {
    m_Outcome.reason = "crash: signal " + std::to_string(WTERMSIG(status)) + " " + first;
  }
  else if (exitStatus == WrongException)
  {
    m_Outcome.reason = "unexpected type of error: " + TextOf(m_Log);
  }
  else if (exitStatus != Read && exitStatus != Refused)
  {
    m_Outcome.reason = "crash: exit status " + std::to_string(exitStatus) + " " + first;
  }
  else if (!containment.fault.empty())
  {
    m_Outcome.reason = containment.fault;
  }
  else if (peakKilobytes > MostKilobytes)
  {
    m_Outcome.reason = "memory: " + std::to_string(peakKilobytes / 1024) + " MB";
  }
  else
  {
    m_Outcome.kind = exitStatus == Read ? FuzzOutcome::Kind::read : FuzzOutcome::Kind::refused;
    m_Outcome.contained = containment.contained;
    std::remove(m_Path.c_str());
    std::remove(m_Log.c_str());
  }
}
