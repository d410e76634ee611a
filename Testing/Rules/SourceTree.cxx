#include "SourceTree.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace rules
{
namespace
{
bool
IsIgnored(const fs::path & entry, const fs::path & root)
{
  const std::string name = entry.filename().string();
  const bool        atTop = entry.parent_path() == root;
  return name == ".git" || name == ".cache" || name == "compile_commands.json" ||
         (atTop && (name.compare(0, 5, "build") == 0 || name == "demo-output"));
}
} // namespace

std::vector<fs::path>
RepositoryFiles(const fs::path & root)
{
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(root), end; entry != end; ++entry)
  {
    if (IsIgnored(entry->path(), root))
    {
      entry.disable_recursion_pending();
    }
    else if (entry->is_regular_file())
    {
      files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string
ReadText(const fs::path & path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error(path.string() + " cannot be read");
  }
  return { std::istreambuf_iterator<char>(stream), {} };
}

std::vector<std::string>
Lines(const std::string & text)
{
  std::vector<std::string> lines;
  std::istringstream       stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    lines.push_back(line);
  }
  return lines;
}

bool
IsSource(const fs::path & path)
{
  const std::string extension = path.extension().string();
  return extension == ".h" || extension == ".hxx" || extension == ".cxx";
}

std::string
Shown(const fs::path & path, const fs::path & root)
{
  return path.lexically_relative(root).generic_string();
}
} // namespace rules
