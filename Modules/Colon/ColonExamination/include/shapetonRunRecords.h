#ifndef shapetonRunRecords_h
#define shapetonRunRecords_h

#include "ShapetonColonExaminationExport.h"
#include "shapetonRemarks.h"

#include <string>

namespace shapeton
{
/** \class RunRecords
 * \brief Reads the records in the folder of a StagedRun, for programs that use its results.
 *
 * A run that was interrupted or is still active may contain stages computed from outdated results of other stages.
 * Such results must not be combined into one examination.
 *
 * \ingroup ShapetonColonExamination */
class ShapetonColonExamination_EXPORT RunRecords
{
public:
  explicit RunRecords(const std::string & folder);

  /** Throws InputError unless the completed stage wrote this file and all results it was computed from, directly or
   * through earlier stages, are the current results of the run. */
  void
  RequireCurrent(const std::string & stage, const std::string & file) const;

  /** Checks all results of a stage without reading them. Throws InputError if the stage completed but used results that
   * no longer exist. */
  void
  RequireCurrent(const std::string & stage) const;

  /** Warnings of the tool of a stage; empty if it has no record. */
  Remarks
  WarningsOf(const std::string & stage) const;

private:
  std::string
  PathOf(const std::string & stage) const;

  std::string m_Folder;
};
} // namespace shapeton

#endif
