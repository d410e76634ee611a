#include "shapetonChildTool.h"

#include "shapetonExceptions.h"
#include "shapetonOperatingSystem.h"

#include <charconv>
#include <csignal>
#include <cstring>
#include <system_error>

namespace shapeton
{
namespace
{
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

ChildProcess
StartTool(const std::string & program, const std::vector<std::string> & arguments, const Pipe & out, const Pipe & err)
{
  if (ErrorOfAccess(program, FileAccess::execute) != 0)
  {
    throw OutputError("the program \"" + program + "\" is missing or cannot be run; install all tools in one folder");
  }
  try
  {
    return ChildProcess::StartTool(program, arguments, out, err);
  }
  catch (const std::system_error & error)
  {
    throw OutputError("cannot start another process (" + error.code().message() + "); close other programs");
  }
}

Pipe
OpenPipe()
{
  try
  {
    return Pipe();
  }
  catch (const std::system_error & error)
  {
    throw OutputError("cannot open a pipe (" + error.code().message() + "); close other programs");
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
  Pipe           out = OpenPipe();
  Pipe           err = OpenPipe();
  ChildOutcome   outcome;
  ProgressReader reader(outcome, progress);
  std::string    errors;
  ChildProcess   child = StartTool(program, arguments, out, err);
  out.CloseInput();
  err.CloseInput();
  ReadPipes(
    out,
    [&](const char * bytes, std::size_t size) { reader.Add(bytes, size); },
    err,
    [&](const char * bytes, std::size_t size) { errors.append(bytes, size); });
  const ChildProcess::End end = child.Wait();
  outcome.message = MessageIn(errors, program);
  outcome.status = end.isSignal ? 1 : end.number;
  if (end.isSignal)
  {
    outcome.message =
      "ended by signal " + std::to_string(end.number) + (end.number == SIGKILL ? "; perhaps memory ran out" : "");
  }
  return outcome;
}
} // namespace shapeton
