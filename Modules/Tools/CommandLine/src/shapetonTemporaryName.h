#ifndef shapetonTemporaryName_h
#define shapetonTemporaryName_h

#include <cstddef>
#include <filesystem>
#include <string>

namespace shapeton
{
/** A hidden name in the folder of `target` with its extension, ".heat.<machine>-<process>-<number>.part.nii.gz" for
 * "heat.nii.gz". ".nii.gz" and ".mrk.json" count as one extension because writers choose the format by it. */
std::filesystem::path
TemporaryNameFor(const std::filesystem::path & target, std::size_t number);

/** Whether the temporary name belongs to a process of this machine that no longer exists. */
bool
IsLeftover(const std::string & name);
} // namespace shapeton

#endif
