#ifndef shapetonColonoscopyPresentation_h
#define shapetonColonoscopyPresentation_h

#include "shapetonRemarks.h"
#include "shapetonCommandLine.h"
#include "shapetonStagedRun.h"

#include <string>
#include <vector>

namespace shapeton
{
/** What the report of a series is made of. */
struct ColonoscopyPresentation
{
  std::string              folder;
  std::vector<StageResult> stages;
  Remarks                  warnings;
  Provenance               provenance;
  /** "" where all is well. */
  std::string failure;
};

/** Writes report.html and the files for Slicer; again when a stage or one of these files has changed. */
void
Present(CommandLine & commandLine, const ColonoscopyPresentation & presentation);
} // namespace shapeton

#endif
