#include "shapetonChildTool.h"

#include "shapetonExceptions.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#  include <sys/prctl.h>
#endif

namespace shapeton
{
namespace
{
/** A pipe whose child end is inherited only by the child. */
struct Pipe
{
  Pipe()
  {
    if (pipe2(ends, O_CLOEXEC) != 0) // atomically: another thread may start a tool concurrently
    {
      throw OutputError(std::string("cannot open a pipe (") + std::strerror(errno) + "); close other programs");
    }
  }
  Pipe(const Pipe &) = delete;
  Pipe &
  operator=(const Pipe &) = delete;
  ~Pipe()
  {
    this->Close(0);
    this->Close(1);
  }
  void
  Close(int end)
  {
    if (ends[end] >= 0)
    {
      close(ends[end]);
      ends[end] = -1;
    }
  }
  int ends[2];
};

std::string
Unescaped(std::string text)
{
  const std::pair<const char *, const char *> entities[] = { { "&lt;", "<" }, { "&gt;", ">" }, { "&amp;", "&" } };
  for (const auto & [entity, character] : entities)
  {
    for (std::size_t at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
    {
      text.replace(at, std::strlen(entity), character);
    }
  }
  return text;
}

/** Parses a tool's stdout, line by line. */
class ProgressReader
{
public:
  ProgressReader(ChildOutcome & outcome, const Progress & progress) : m_Outcome(outcome), m_Progress(progress) {}

  void
  Add(const char * bytes, std::size_t number)
  {
    m_Rest.append(bytes, number);
    for (std::size_t end = m_Rest.find('\n'); end != std::string::npos; end = m_Rest.find('\n'))
    {
      this->ReadLine(m_Rest.substr(0, end));
      m_Rest.erase(0, end + 1);
    }
  }

private:
  /** Whether the line is the element with this tag; if so, returns its content. */
  static bool
  IsElement(const std::string & line, const std::string & tag, std::string & content)
  {
    const std::string begin = '<' + tag + '>';
    const std::string end = "</" + tag + '>';
    const bool        isElement = line.size() >= begin.size() + end.size() && line.rfind(begin, 0) == 0 &&
                           line.compare(line.size() - end.size(), end.size(), end) == 0;
    content = isElement ? Unescaped(line.substr(begin.size(), line.size() - begin.size() - end.size())) : "";
    return isElement;
  }

  void
  ReadLine(const std::string & line)
  {
    std::string content;
    if (line == "<filter-start>" || line == "<filter-end>")
    {
      m_IsInBlock = true; // names and comments of a step of the tool
    }
    else if (line == "</filter-start>" || line == "</filter-end>")
    {
      m_IsInBlock = false;
    }
    else if (IsElement(line, "filter-name", content))
    {
      m_Step = content;
    }
    else if (IsElement(line, "filter-progress", content))
    {
      this->Report(content);
    }
    else if (IsElement(line, "filter-comment", content) && !m_IsInBlock)
    {
      m_Outcome.warnings.push_back(content);
    }
    else if (line.rfind("<filter-", 0) != 0)
    {
      m_Outcome.text += line + '\n';
    }
  }

  void
  Report(const std::string & number)
  {
    double share = 0.0;
    std::from_chars(number.data(), number.data() + number.size(), share);
    m_Progress(m_Step, share);
  }

  ChildOutcome &   m_Outcome;
  const Progress & m_Progress;
  std::string      m_Rest;
  std::string      m_Step;
  bool             m_IsInBlock{ false };
};

/** Runs in the child, which shares the memory of the parent until exec(): system calls only. */
[[noreturn]] void
BecomeTool(char * const * arguments, int out, int err, pid_t parent)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) // the parent died before that call
  {
    _exit(1);
  }
#endif
  const int none = open("/dev/null", O_RDONLY);
  dup2(none, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execv(arguments[0], arguments);
  _exit(127);
}

pid_t
Start(const std::string & program, const std::vector<std::string> & arguments, const Pipe & out, const Pipe & err)
{
  if (access(program.c_str(), X_OK) != 0)
  {
    throw OutputError("the program \"" + program + "\" is missing or cannot be run; install all tools in one folder");
  }
  std::vector<char *> words{ const_cast<char *>(program.c_str()) };
  for (const std::string & argument : arguments)
  {
    words.push_back(const_cast<char *>(argument.c_str()));
  }
  words.push_back(nullptr);
  const pid_t parent = getpid();
  // fork() would join the threads of ITK's pool, which another thread may be using.
  const pid_t child = vfork();
  if (child < 0)
  {
    throw OutputError(std::string("cannot start another process (") + std::strerror(errno) + "); close other programs");
  }
  if (child == 0)
  {
    BecomeTool(words.data(), out.ends[1], err.ends[1], parent); // NOLINT(clang-analyzer-unix.Vfork): see there
  }
  return child;
}

/** Reads both pipes until the child closes them. */
void
ReadPipes(const Pipe & out, const Pipe & err, ProgressReader & reader, std::string & errors)
{
  pollfd polled[2] = { { out.ends[0], POLLIN, 0 }, { err.ends[0], POLLIN, 0 } };
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
      if (number > 0 && &pipe == &polled[0])
      {
        reader.Add(buffer, static_cast<std::size_t>(number));
      }
      else if (number > 0)
      {
        errors.append(buffer, static_cast<std::size_t>(number));
      }
      else if (number == 0 || (number == -1 && errno != EINTR))
      {
        pipe.fd = -1;
      }
    }
  }
}

/** The last line, without the prefix "Tool: ". */
std::string
MessageIn(std::string errors, const std::string & program)
{
  while (!errors.empty() && errors.back() == '\n')
  {
    errors.pop_back();
  }
  const std::string line = errors.substr(errors.rfind('\n') + 1); // npos + 1 is 0
  const std::string name = program.substr(program.rfind('/') + 1) + ": ";
  return line.rfind(name, 0) == 0 ? line.substr(name.size()) : line;
}
} // namespace

ChildOutcome
RunChildTool(const std::string & program, const std::vector<std::string> & arguments, const Progress & progress)
{
  Pipe           out;
  Pipe           err;
  ChildOutcome   outcome;
  ProgressReader reader(outcome, progress);
  std::string    errors;
  const pid_t    child = Start(program, arguments, out, err);
  out.Close(1);
  err.Close(1);
  ReadPipes(out, err, reader, errors);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {}
  outcome.message = MessageIn(errors, program);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
  if (WIFSIGNALED(status))
  {
    outcome.message = "ended by signal " + std::to_string(WTERMSIG(status)) +
                      (WTERMSIG(status) == SIGKILL ? "; perhaps memory ran out" : "");
  }
  return outcome;
}
} // namespace shapeton
