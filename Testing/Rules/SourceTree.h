#ifndef SourceTree_h
#define SourceTree_h

#include <filesystem>
#include <string>
#include <vector>

namespace rules
{
/** Returns the sorted files of the repository below `root`, without git's own and those in .gitignore. */
std::vector<std::filesystem::path>
RepositoryFiles(const std::filesystem::path & root);

/** Returns the bytes of a file. Throws std::runtime_error if it cannot be read. */
std::string
ReadText(const std::filesystem::path & path);

std::vector<std::string>
Lines(const std::string & text);

/** True for C++ sources and headers. */
bool
IsSource(const std::filesystem::path & path);

/** Returns `path` relative to `root` with slashes, as shown in faults. */
std::string
Shown(const std::filesystem::path & path, const std::filesystem::path & root);
} // namespace rules

#endif
