#ifndef shapetonChildTool_h
#define shapetonChildTool_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Outcome of a tool that ran as a child process. */
struct ChildOutcome
{
  /** Exit status; 1 if a signal ended it. */
  int status{ 0 };
  /** stderr without the tool's name; if a signal ended the tool, a message about the signal. */
  std::string message;
  /** stdout without the progress. */
  std::string text;
  /** Warnings of the tool. */
  Remarks warnings;
};

/** Runs a tool with a shapeton::CommandLine and reads the progress that it writes for 3D Slicer: the name of its step
 * and the fraction. The child gets SIGTERM when this process dies. Throws OutputError if it cannot be started. */
ChildOutcome
RunChildTool(const std::string & program, const std::vector<std::string> & arguments, const Progress & progress = {});
} // namespace shapeton

#endif
