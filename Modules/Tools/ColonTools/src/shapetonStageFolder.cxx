#include "shapetonStageFolder.h"

#include "shapetonParallelFor.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
/** Relative names of the files below a folder, in alphabetical order. */
std::vector<std::string>
NamesBelow(const fs::path & folder)
{
  std::vector<std::string> names;
  for (const auto & entry : fs::recursive_directory_iterator(folder))
  {
    if (!entry.is_directory())
    {
      names.push_back(entry.path().lexically_relative(folder).string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

template <typename TWork>
auto
Guarded(const TWork & work)
{
  try
  {
    return work();
  }
  catch (const fs::filesystem_error & error)
  {
    throw OutputError("\"" + error.path1().string() + "\": " + error.code().message() +
                      "; check the folder and its disk");
  }
}

void
RemoveOld(const fs::path & folder, const FileHashes & old)
{
  for (const auto & [name, hash] : old)
  {
    fs::remove(folder / name);
  }
  for (const auto & [name, hash] : old)
  {
    std::error_code notEmpty;
    for (fs::path parent = (folder / name).parent_path(); parent != folder && fs::remove(parent, notEmpty);
         parent = parent.parent_path())
    {}
  }
}
} // namespace

bool
IsRecordOfOneRun(const std::string & name)
{
  const std::string end = "run.json";
  const bool        endsSo = name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  return endsSo && (name.size() == end.size() || name[name.size() - end.size() - 1] == '.');
}

FileHashes
HashesOfFolder(const std::string & folder)
{
  return Guarded([&] {
    const std::vector<std::string> names = fs::is_directory(folder) ? NamesBelow(folder) : std::vector<std::string>();
    FileHashes                     files(names.size());
    ParallelFor(names.size(), [&](std::size_t i) { files[i] = { names[i], Sha256OfFile(folder + '/' + names[i]) }; });
    return files;
  });
}

void
MakeEmptyFolder(const std::string & folder)
{
  Guarded([&] {
    fs::remove_all(folder);
    fs::create_directories(folder);
  });
}

void
RemoveFolder(const std::string & folder)
{
  Guarded([&] { fs::remove_all(folder); });
}

void
ReplaceFiles(const std::string & from, const std::string & to, const FileHashes & old)
{
  Guarded([&] {
    RemoveOld(to, old);
    for (const std::string & name : NamesBelow(from))
    {
      const fs::path target = fs::path(to) / name;
      fs::create_directories(target.parent_path());
      fs::rename(fs::path(from) / name, target);
    }
    fs::remove_all(from);
  });
}
} // namespace shapeton
