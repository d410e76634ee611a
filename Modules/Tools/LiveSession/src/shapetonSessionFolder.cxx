#include "shapetonSessionFolder.h"

#include "shapetonExceptions.h"
#include "shapetonPrintable.h"

#include <algorithm>

namespace shapeton
{
namespace fs = std::filesystem;

SessionFolder::SessionFolder(const std::string & path)
{
  std::error_code error;
  m_Path = fs::canonical(path, error);
  if (error || !fs::is_directory(m_Path))
  {
    throw InputError("the folder " + Quoted(path) + " does not exist; create it or use another one");
  }
}

fs::path
SessionFolder::PathOf(const std::string & name) const
{
  constexpr std::size_t longest = 255;
  const auto            require = [&](bool condition, const std::string & reason) {
    RequireParameter(condition,
                     "the file name " + Quoted(name) + " " + reason + "; use a name in the session's folder");
  };
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  require(!name.empty() && name.size() <= longest, "must have 1 to 255 bytes");
  require(std::none_of(name.begin(), name.end(), isControl), "contains a control character");
  const fs::path relative(name);
  require(relative.is_relative() && relative.has_filename(), "is not relative to the folder");
  fs::path path = m_Path;
  for (const fs::path & part : relative)
  {
    require(part != "." && part != ".." && !part.empty(), "leaves the folder");
    path /= part;
    require(!fs::is_symlink(fs::symlink_status(path)), "contains a symbolic link");
  }
  return path;
}
} // namespace shapeton
