#ifndef shapetonStageFolder_h
#define shapetonStageFolder_h

#include "shapetonStageRecord.h"

#include <string>

namespace shapeton
{
/** Whether a file of this name may differ between identical runs. */
bool
IsRecordOfOneRun(const std::string & name);

/** Hashes of the files below a folder; empty if it does not exist. Throws OutputError. */
FileHashes
HashesOfFolder(const std::string & folder);

/** Creates an empty folder. Throws OutputError. */
void
MakeEmptyFolder(const std::string & folder);

/** Removes a folder and its contents. Throws OutputError. */
void
RemoveFolder(const std::string & folder);

/** Removes the files `old` below `to`, and folders that become empty. Then moves all files below `from` to the same
 * relative paths below `to` and removes `from`. Throws OutputError. */
void
ReplaceFiles(const std::string & from, const std::string & to, const FileHashes & old);
} // namespace shapeton

#endif
