#ifndef shapetonToolProcess_h
#define shapetonToolProcess_h

#include "shapetonCommandLine.h"
#include "shapetonTestFolder.h"

#include <filesystem>
#include <functional>
#include <locale>
#include <string>
#include <vector>

namespace tooltest
{
/** Outcome of a process. */
struct Outcome
{
  int         status{ -1 }; ///< exit status, or the negative number of the signal that ended it
  std::string out;
  std::string err;
};

/** Runs `work` in a forked process; its return value is the exit status. */
Outcome
InProcess(const std::function<int()> & work);

/** RunProcess() with a pseudo-terminal with this number of columns as stdout; 0: unknown width. */
Outcome
OnTerminal(const std::function<int()> & work, unsigned short columns);

/** A module description with a parameter of every kind; see shapetonToolProcess.cxx. */
extern const char * const Xml;

using Words = std::vector<std::string>;
using Body = shapeton::CommandLine::Body;

/** CommandLine::Run in this process, as the program `path`. */
int
RunHere(const Words &       arguments,
        const Body &        body,
        const char *        xml = Xml,
        const std::string & path = "/opt/bin/TestTool");

/** CommandLine::Run in a separate process. */
Outcome
RunTool(const Words & arguments, const Body & body, const char * xml = Xml);

/** RunTool() with "in.nrrd" and "out.nrrd" as positional arguments before `options`. */
Outcome
RunWithOptions(const Words & options, const Body & body);

using basetest::Scratch;

void
WriteText(const std::string & path, const std::string & text);
std::string
ReadText(const std::string & path);

/** The names in a folder, including hidden ones, in alphabetical order. */
Words
NamesIn(const std::string & folder = ".");

/** Numbers as some countries write them: 1.234,5. */
struct Comma : std::numpunct<char>
{
  char
  do_decimal_point() const override
  {
    return ',';
  }
  std::string
  do_grouping() const override
  {
    return "\3";
  }
};

/** Drops root privileges, which permit writing everywhere. */
void
BecomeNobody();
} // namespace tooltest

#endif
