#ifndef shapetonStageFolder_h
#define shapetonStageFolder_h

#include <string>
#include <utility>
#include <vector>

namespace shapeton
{
/** Names of files and their SHA-256, in alphabetical order. */
using FileHashes = std::vector<std::pair<std::string, std::string>>;

/** Whether equal runs need not write equal bytes to a file of this name. */
bool
IsRecordOfOneRun(const std::string & name);

/** Of the files below a folder; empty where there is none. Throws OutputError. */
FileHashes
HashesOfFolder(const std::string & folder);

/** Makes a folder that is empty. Throws OutputError. */
void
MakeEmptyFolder(const std::string & folder);

/** Removes a folder with all it holds. Throws OutputError. */
void
RemoveFolder(const std::string & folder);

/** Moves all files below `from` to the same places below `to` and removes `from`; before that removes the files `old`
 * below `to`, and folders that become empty. Throws OutputError. */
void
ReplaceFiles(const std::string & from, const std::string & to, const FileHashes & old);
} // namespace shapeton

#endif
