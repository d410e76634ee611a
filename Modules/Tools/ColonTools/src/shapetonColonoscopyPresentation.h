#ifndef shapetonColonoscopyPresentation_h
#define shapetonColonoscopyPresentation_h

#include "shapetonRemarks.h"
#include "shapetonColonoscopyQuality.h"
#include "shapetonColonoscopyResults.h"
#include "shapetonCommandLine.h"
#include "shapetonStagedRun.h"

#include <memory>
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

/** Writes the pages on a series. Files are written again if a stage or one of them has changed. */
class ColonoscopyPresenter
{
public:
  explicit ColonoscopyPresenter(CommandLine & commandLine) : m_CommandLine(commandLine) {}

  /** Writes limitations.json, which the viewer repeats, after all stages whose results it needs. */
  void
  WriteLimitations(const ColonoscopyPresentation & presentation);

  /** Writes report.html and the files for Slicer, after the last stage. */
  void
  WriteReport(const ColonoscopyPresentation & presentation);

private:
  /** Reads and measures the results unless that was done. */
  void
  Read(const ColonoscopyPresentation & presentation);

  CommandLine &                       m_CommandLine;
  std::shared_ptr<ColonoscopyResults> m_Results; ///< null: not read
  ColonoscopyQuality                  m_Quality;
};
} // namespace shapeton

#endif
