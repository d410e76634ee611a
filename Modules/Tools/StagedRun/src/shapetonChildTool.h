#ifndef shapetonChildTool_h
#define shapetonChildTool_h

#include "shapetonRemarks.h"
#include "shapetonProgress.h"

#include <string>
#include <vector>

namespace shapeton
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
  Remarks warnings;
};

/** Runs a tool with an shapeton::CommandLine and reads the progress that it writes for 3D Slicer: its step in its
 * words, and the share of its work. The child gets SIGTERM when this process dies. Throws OutputError where it cannot
 * be started. */
ChildOutcome
RunChildTool(const std::string & program, const std::vector<std::string> & arguments, const Progress & progress = {});
} // namespace shapeton

#endif
