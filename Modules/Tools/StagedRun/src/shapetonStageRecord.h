#ifndef shapetonStageRecord_h
#define shapetonStageRecord_h

#include "shapetonStageFolder.h"
#include "shapetonStagedRun.h"

#include <optional>

namespace shapeton
{
/** What the file of a record says. */
struct StageRecord
{
  std::string signature;
  /** Results of other stages that it was made from: where they lie, from the folder of the run on, and their SHA-256.
   */
  FileHashes  inputs;
  StageResult result;
};

/** Where the record of the stage is that has written this file into its folder. */
std::string
RecordPathOf(const std::string & file);

/** Nothing where there is no record, or it is damaged: then the stage is computed again. */
std::optional<StageRecord>
ReadStageRecord(const std::string & path);

/** Whole or not at all. Throws OutputError. */
void
WriteStageRecord(const StageRecord & record, const std::string & path);
} // namespace shapeton

#endif
