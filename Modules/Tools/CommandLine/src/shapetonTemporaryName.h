#ifndef shapetonTemporaryName_h
#define shapetonTemporaryName_h

#include <cstddef>
#include <filesystem>
#include <string>

namespace shapeton
{
/** A hidden name beside `target` with its extension, ".heat.<machine>-<process>-<number>.part.nii.gz" for
 * "heat.nii.gz". ".nii.gz" and ".mrk.json" count as one extension because writers choose the
 * format by it. */
std::filesystem::path
TemporaryNameFor(const std::filesystem::path & target, std::size_t number);

/** Whether a process of this machine that no longer exists has made a file of this temporary name. */
bool
IsLeftover(const std::string & name);
} // namespace shapeton

#endif
