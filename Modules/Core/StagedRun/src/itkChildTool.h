#ifndef itkChildTool_h
#define itkChildTool_h

#include <functional>
#include <string>
#include <vector>

namespace itk
{
/** How a tool that ran as a child ended. */
struct ChildOutcome
{
  /** Exit status; 1 where a signal ended it. */
  int status{ 0 };
  /** What it wrote to stderr, without its name; where a signal ended it, that. */
  std::string message;
  /** What it wrote to stdout beside progress. */
  std::string text;
  /** Its remarks. */
  std::vector<std::string> warnings;
};

/** The step the tool is at, in its words, and its share of the work. */
using ChildProgress = std::function<void(const std::string & step, double share)>;

/** Runs a tool with an itk::CommandLine and reads the progress that it writes for 3D Slicer. The child gets SIGTERM
 * when this process dies. Throws OutputError where it cannot be started. */
ChildOutcome
RunChildTool(const std::string &              program,
             const std::vector<std::string> & arguments,
             const ChildProgress &            progress = {});
} // namespace itk

#endif
