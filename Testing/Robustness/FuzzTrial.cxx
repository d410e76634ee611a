#include "FuzzTrial.h"

#include "shapetonExceptions.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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
  for (const char * everywhere : { "libasan", "libubsan", "libc.so", "libstdc++", "libgcc", "libm.so", "ld-linux" })
  {
    if (name.compare(0, std::string(everywhere).size(), everywhere) == 0)
    {
      return {};
    }
  }
  return name;
}

bool
IsForeign(const std::string & library)
{
  for (const char * start :
       { "libdcm", "libof", "libgdcm", "libITK", "libitk", "libopenjp2", "libcharls", "libz.", "libjpeg" })
  {
    if (library.compare(0, std::string(start).size(), start) == 0)
    {
      return true;
    }
  }
  return false;
}

/** Library at fault in a sanitizer's report: the first library of the stack that is not in every stack. */
std::string
LibraryAtFault(const std::string & log)
{
  std::istringstream stream(log);
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
  // At the memory limit, the sanitizer cannot print a stack.
  return log.find("allocator is out of memory") != std::string::npos ? MemoryLimit : "unknown";
}

std::string
FirstReport(const std::string & log)
{
  for (const char * sign : { "runtime error: ", "ERROR: AddressSanitizer: ", "ERROR: LeakSanitizer: " })
  {
    const auto place = log.find(sign);
    if (place != std::string::npos)
    {
      return log.substr(place, log.find('\n', place) - place);
    }
  }
  return {};
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
  const std::string log = TextOf(m_Log);
  const std::string report = FirstReport(log);
  const std::string library = report.empty() ? "" : LibraryAtFault(log);
  const bool        isUndefined = report.compare(0, 13, "runtime error") == 0; // only Shapeton is instrumented for this
  const int         exitStatus = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  m_Outcome.kind = FuzzOutcome::Kind::fault;
  if (m_IsOutOfTime)
  {
    m_Outcome.reason = "hang: more than " + std::to_string(m_Limit.count()) + " s";
  }
  else if (WIFSIGNALED(status))
  {
    m_Outcome.reason = "crash: signal " + std::to_string(WTERMSIG(status)) + " " + report;
  }
  else if (exitStatus == WrongException)
  {
    m_Outcome.reason = "unexpected type of error: " + log;
  }
  else if (exitStatus != Read && exitStatus != Refused)
  {
    m_Outcome.reason = "crash: exit status " + std::to_string(exitStatus) + " " + report;
  }
  else if (!report.empty() && (isUndefined || !IsForeign(library)))
  {
    m_Outcome.reason = report + " in " + library;
  }
  else if (peakKilobytes > MostKilobytes)
  {
    m_Outcome.reason = "memory: " + std::to_string(peakKilobytes / 1024) + " MB";
  }
  else
  {
    m_Outcome.kind = exitStatus == Read ? FuzzOutcome::Kind::read : FuzzOutcome::Kind::refused;
    m_Outcome.contained = library;
    std::remove(m_Path.c_str());
    std::remove(m_Log.c_str());
  }
}
