#ifndef shapetonStageRecord_h
#define shapetonStageRecord_h

#include "ShapetonColonExaminationExport.h"
#include "shapetonRemarks.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Names of files and their SHA-256, in alphabetical order. \ingroup ShapetonColonExamination */
using FileHashes = std::vector<std::pair<std::string, std::string>>;

/** Outcome of a stage. \ingroup ShapetonColonExamination */
struct ShapetonColonExamination_EXPORT StageResult
{
  std::string name;
  std::string program;
  std::string version;
  /** Exit status of the tool: 0 on success, 1 if a signal terminated it. */
  int status{ 0 };
  /** Error message of a failed tool. */
  std::string message;
  /** Warnings of the tool, from the original run if the stage was skipped. */
  Remarks warnings;
  /** Files in the stage's folder. Records of single runs (*.run.json) are omitted because they differ from run to run.
   */
  FileHashes files;
  /** True if the stage was skipped because its earlier result is still valid. */
  bool isResumed{ false };

  bool
  Has(const std::string & file) const;
};

/** Content of a record file. \ingroup ShapetonColonExamination */
struct ShapetonColonExamination_EXPORT StageRecord
{
  std::string signature;
  /** Results of other stages that were used: their paths relative to the folder of the run, and their SHA-256. */
  FileHashes  inputs;
  StageResult result;

  /** Identity of the first positional input, "sha256:..."; "" if there is none. */
  std::string
  IdentityOfInput() const;
};

/** Path of the record of the stage that wrote this file into its folder. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::string
                                RecordPathOf(const std::string & file);

/** Empty if the record is missing or damaged; the stage is then computed again.
 * \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::optional<StageRecord>
                                ReadStageRecord(const std::string & path);

/** Writes the record atomically. Throws OutputError. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT void
WriteStageRecord(const StageRecord & record, const std::string & path);
} // namespace shapeton

#endif
