#ifndef SourceTree_h
#define SourceTree_h

#include <filesystem>
#include <string>
#include <vector>

namespace rules
{
/** The files of the repository below `root`, sorted: all but what .gitignore names and git's own. */
std::vector<std::filesystem::path>
RepositoryFiles(const std::filesystem::path & root);

/** The bytes of a file; throws std::runtime_error when it cannot be read. */
std::string
ReadText(const std::filesystem::path & path);

std::vector<std::string>
Lines(const std::string & text);

/** True for C++ sources and headers. */
bool
IsSource(const std::filesystem::path & path);

/** `path` as faults show it: relative to `root`, with slashes. */
std::string
Shown(const std::filesystem::path & path, const std::filesystem::path & root);
} // namespace rules

#endif
