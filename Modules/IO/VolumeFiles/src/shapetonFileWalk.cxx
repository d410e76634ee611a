#include "shapetonFileWalk.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"
#include "shapetonOperatingSystem.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;

/** The entries of a folder, sorted by name for deterministic results. */
std::vector<std::string>
ListFolder(const std::string & folder)
{
  std::error_code          error;
  fs::directory_iterator   entries(folder, error);
  std::vector<std::string> names;
  while (!error && entries != fs::directory_iterator())
  {
    names.push_back(entries->path().string());
    entries.increment(error);
  }
  if (error)
  {
    ThrowUnsuitable(folder, "the folder cannot be read: " + error.message());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void
CheckReadable(const std::string & path)
{
  if (const int error = ErrorOfAccess(path, FileAccess::read))
  {
    ThrowUnsuitable(path, std::string("cannot be read: ") + std::strerror(error));
  }
}
} // namespace

std::vector<std::string>
ListFiles(const std::string & path)
{
  const FileStatus root = StatusOf(path);
  if (root.error != 0)
  {
    ThrowUnsuitable(
      path, root.error == ENOENT ? "does not exist" : std::string("cannot be read: ") + std::strerror(root.error));
  }
  if (!root.isFolder && !root.isFile)
  {
    ThrowUnsuitable(path, "neither a file nor a folder");
  }
  std::vector<std::string>                          files;
  std::vector<std::string>                          waiting{ path };
  std::set<std::pair<std::uint64_t, std::uint64_t>> seen;
  while (!waiting.empty())
  {
    const std::string next = waiting.back();
    waiting.pop_back();
    const FileStatus status = StatusOf(next);
    if (status.error != 0 || !seen.insert(status.identity).second) // a dangling link is skipped
    {
      continue;
    }
    if (status.isFolder)
    {
      const auto names = ListFolder(next);
      waiting.insert(waiting.end(), names.rbegin(), names.rend());
    }
    else if (status.isFile)
    {
      CheckReadable(next);
      files.push_back(next);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}
} // namespace shapeton
