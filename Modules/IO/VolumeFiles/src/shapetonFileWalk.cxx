#include "shapetonFileWalk.h"

#include "shapetonExceptions.h"
#include "shapetonFileErrors.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace shapeton
{
namespace
{
namespace fs = std::filesystem;
using FileIdentity = std::pair<dev_t, ino_t>;

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
  if (access(path.c_str(), R_OK) != 0)
  {
    ThrowUnsuitable(path, std::string("cannot be read: ") + std::strerror(errno));
  }
}
} // namespace

std::vector<std::string>
ListFiles(const std::string & path)
{
  struct stat status;
  if (stat(path.c_str(), &status) != 0)
  {
    ThrowUnsuitable(path, errno == ENOENT ? "does not exist" : std::string("cannot be read: ") + std::strerror(errno));
  }
  if (!S_ISDIR(status.st_mode) && !S_ISREG(status.st_mode))
  {
    ThrowUnsuitable(path, "neither a file nor a folder");
  }
  std::vector<std::string> files;
  std::vector<std::string> waiting{ path };
  std::set<FileIdentity>   seen;
  while (!waiting.empty())
  {
    const std::string next = waiting.back();
    waiting.pop_back();
    const bool isFound = stat(next.c_str(), &status) == 0; // a dangling link is skipped
    if (!isFound || !seen.emplace(status.st_dev, status.st_ino).second)
    {
      continue;
    }
    if (S_ISDIR(status.st_mode))
    {
      const auto names = ListFolder(next);
      waiting.insert(waiting.end(), names.rbegin(), names.rend());
    }
    else if (S_ISREG(status.st_mode))
    {
      CheckReadable(next);
      files.push_back(next);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}
} // namespace shapeton
