#ifndef shapetonStageRecord_h
#define shapetonStageRecord_h

#include "shapetonStagedRun.h"

#include <optional>

namespace shapeton
{
/** What the file of a record says. */
struct StageRecord
{
  std::string signature;
  StageResult result;
};

/** Nothing where there is no record, or it is damaged: then the stage is computed again. */
std::optional<StageRecord>
ReadStageRecord(const std::string & path);

/** Whole or not at all. Throws OutputError. */
void
WriteStageRecord(const StageRecord & record, const std::string & path);
} // namespace shapeton

#endif
