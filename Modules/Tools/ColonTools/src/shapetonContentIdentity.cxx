#include "shapetonContentIdentity.h"

#include "shapetonParallelFor.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
/** Names in the digest, and their files. */
using NamedFiles = std::vector<std::pair<std::string, std::string>>;

bool
IsHidden(const fs::path & path)
{
  return path.filename().string().front() == '.';
}

NamedFiles
FilesBelow(const fs::path & folder)
{
  NamedFiles files;
  const auto options = fs::directory_options::follow_directory_symlink;
  for (auto entry = fs::recursive_directory_iterator(folder, options); entry != fs::recursive_directory_iterator();
       ++entry)
  {
    if (IsHidden(entry->path()))
    {
      entry.disable_recursion_pending();
    }
    else if (entry->is_regular_file())
    {
      files.emplace_back(entry->path().lexically_relative(folder).string(), entry->path().string());
    }
  }
  return files;
}

NamedFiles
FilesBeside(const fs::path & header)
{
  NamedFiles     files;
  const fs::path folder = header.has_parent_path() ? header.parent_path() : fs::path(".");
  for (const fs::directory_entry & entry : fs::directory_iterator(folder))
  {
    if (entry.is_regular_file() && entry.path().filename().string().rfind(header.stem().string() + '.', 0) == 0)
    {
      files.emplace_back(entry.path().filename().string(), entry.path().string());
    }
  }
  return files;
}

std::string
IdentityOfFiles(NamedFiles files)
{
  std::sort(files.begin(), files.end());
  std::vector<std::string> hashes(files.size());
  ParallelFor(files.size(), [&](std::size_t i) { hashes[i] = Sha256OfFile(files[i].second); });
  std::string lines;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    lines += hashes[i] + ' ' + files[i].first + '\n';
  }
  return "sha256:" + Sha256OfBytes(lines);
}
} // namespace

std::string
IdentityOf(const std::string & path)
{
  try
  {
    if (fs::is_directory(path))
    {
      return IdentityOfFiles(FilesBelow(path));
    }
    const std::string extension = fs::path(path).extension().string();
    if (extension == ".nhdr" || extension == ".mhd")
    {
      return IdentityOfFiles(FilesBeside(path));
    }
    return "sha256:" + Sha256OfFile(path);
  }
  catch (const fs::filesystem_error & error)
  {
    throw InputError("\"" + path + "\" cannot be read (" + error.code().message() + "); check its permissions");
  }
}
} // namespace shapeton
