#ifndef shapetonStageRecord_h
#define shapetonStageRecord_h

#include "shapetonStageFolder.h"
#include "shapetonStagedRun.h"

#include <optional>

namespace shapeton
{
/** Content of a record file. */
struct StageRecord
{
  std::string signature;
  /** Results of other stages that were used: their paths relative to the folder of the run, and their SHA-256. */
  FileHashes  inputs;
  StageResult result;
};

/** Path of the record of the stage that wrote this file into its folder. */
std::string
RecordPathOf(const std::string & file);

/** Empty if the record is missing or damaged; the stage is then computed again. */
std::optional<StageRecord>
ReadStageRecord(const std::string & path);

/** Writes the record atomically. Throws OutputError. */
void
WriteStageRecord(const StageRecord & record, const std::string & path);
} // namespace shapeton

#endif
