#ifndef shapetonTestReports_h
#define shapetonTestReports_h

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>

namespace basetest
{
/** How often a part occurs in a text. */
inline std::size_t
CountOf(const std::string & text, const std::string & part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

/** The names in a folder. */
inline std::set<std::string>
FilesIn(const std::string & folder)
{
  std::set<std::string> names;
  for (const auto & entry : std::filesystem::directory_iterator(folder))
  {
    names.insert(entry.path().filename().string());
  }
  return names;
}
} // namespace basetest

#endif
