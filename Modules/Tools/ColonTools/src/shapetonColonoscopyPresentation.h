#ifndef shapetonColonoscopyPresentation_h
#define shapetonColonoscopyPresentation_h

#include "shapetonRemarks.h"
#include "shapetonCommandLine.h"
#include "shapetonStagedRun.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Inputs of the report on a series. */
struct ColonoscopyPresentation
{
  std::string              folder;
  std::vector<StageResult> stages;
  Remarks                  warnings;
  Provenance               provenance;
  /** Error message of the failed stage; "" if there was none. */
  std::string failure;
  /** Whether this is the second series of a run. */
  bool isSecond{ false };
};

/** Writes report.html and the files for Slicer; rewrites them if a stage or one of these files has changed. */
void
Present(CommandLine & commandLine, const ColonoscopyPresentation & presentation);
} // namespace shapeton

#endif
