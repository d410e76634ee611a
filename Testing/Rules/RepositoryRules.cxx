#include "RepositoryRules.h"
#include "SourceTree.h"

#include <cctype>
#include <cstdint>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace rules
{
namespace
{
constexpr std::uintmax_t LargestFile = 1000000;
constexpr std::size_t    LongestTool = 150;

struct Link
{
  int         line;
  std::string target;
};

/** Returns the links and pictures of a Markdown file, outside of code. */
std::vector<Link>
LinksOf(const std::string & markdown)
{
  static const std::regex code("`[^`]*`");
  static const std::regex link(R"re(\]\(\s*<?([^)>\s]+)|^\s*\[[^\]]+\]:\s*(\S+)|(?:src|href)="([^"]+)")re");
  std::vector<Link>       links;
  int                     number = 0;
  bool                    inBlock = false;
  for (const std::string & line : Lines(markdown))
  {
    ++number;
    if (line.find("```") != std::string::npos)
    {
      inBlock = !inBlock;
    }
    if (inBlock)
    {
      continue;
    }
    const std::string text = std::regex_replace(line, code, "");
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match)
    {
      links.push_back({ number, (*match)[1].str() + (*match)[2].str() + (*match)[3].str() });
    }
  }
  return links;
}

bool
IsOfTheWeb(const std::string & target)
{
  static const std::regex scheme("[A-Za-z][A-Za-z0-9+.-]*:.*");
  return std::regex_match(target, scheme);
}

/** Returns the anchor that a Markdown viewer generates for a heading. */
std::string
AnchorOf(const std::string & heading)
{
  std::string anchor;
  for (const unsigned char c : heading)
  {
    if (c == ' ')
    {
      anchor += '-';
    }
    else if (std::isalnum(c) || c == '-' || c == '_' || c >= 128)
    {
      anchor += static_cast<char>(std::tolower(c));
    }
  }
  return anchor;
}

std::set<std::string>
AnchorsOf(const std::string & markdown)
{
  static const std::regex heading("#+ +(.*?) *#*");
  std::set<std::string>   anchors;
  for (const std::string & line : Lines(markdown))
  {
    std::smatch match;
    if (std::regex_match(line, match, heading))
    {
      anchors.insert(AnchorOf(match[1].str()));
    }
  }
  return anchors;
}

/** Returns the fault of a link, or an empty string. */
std::string
FaultOfLink(const std::string & target, const fs::path & page, const fs::path & root)
{
  const auto        mark = target.find('#');
  const std::string path = target.substr(0, mark);
  const fs::path    file = path.empty() ? page : (page.parent_path() / path).lexically_normal();
  if (Shown(file, root).compare(0, 2, "..") == 0)
  {
    return "the link " + target + " leaves the repository";
  }
  if (!fs::exists(file))
  {
    return "the link " + target + " points to a missing file";
  }
  const bool hasAnchor = mark != std::string::npos && file.extension() == ".md";
  if (hasAnchor && !AnchorsOf(ReadText(file)).count(target.substr(mark + 1)))
  {
    return "the link " + target + " points to a missing heading";
  }
  return {};
}

bool
IsMarkdown(const fs::path & path)
{
  return path.extension() == ".md";
}

/** Returns the folders of modules and tools; the repository itself also has an itk-module.cmake. */
std::vector<fs::path>
DocumentedFolders(const fs::path & root)
{
  std::vector<fs::path> folders;
  for (const fs::path & file : RepositoryFiles(root))
  {
    const fs::path folder = file.parent_path();
    const bool     isTool = folder.parent_path() == root / "Applications" && file.filename() == "CMakeLists.txt";
    if ((file.filename() == "itk-module.cmake" && folder != root) || isTool)
    {
      folders.push_back(folder);
    }
  }
  return folders;
}

void
CheckReadmes(const fs::path & root, Faults & faults)
{
  const fs::path     index = root / "Documentation" / "index.md";
  std::set<fs::path> linked;
  if (fs::exists(index))
  {
    for (const Link & link : LinksOf(ReadText(index)))
    {
      linked.insert((index.parent_path() / link.target).lexically_normal());
    }
  }
  for (const fs::path & folder : DocumentedFolders(root))
  {
    const fs::path page = folder / "README.md";
    if (!fs::exists(page))
    {
      faults.push_back({ Shown(folder, root), 0, "has no README.md" });
    }
    if (!linked.count(page))
    {
      faults.push_back({ Shown(index, root), 0, "has no link to " + Shown(page, root) });
    }
  }
}

void
CheckDataSources(const fs::path & root, Faults & faults)
{
  const fs::path folder = root / "Data";
  const fs::path page = folder / "README.md";
  if (!fs::exists(folder))
  {
    return;
  }
  const std::string text = fs::exists(page) ? ReadText(page) : std::string();
  for (const auto & entry : fs::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    if (name != "README.md" && text.find(name) == std::string::npos)
    {
      faults.push_back({ Shown(entry.path(), root), 0, "Data/README.md does not state its source and license" });
    }
  }
}

bool
IsText(const std::string & bytes)
{
  return bytes.find('\0') == std::string::npos;
}

/** Concatenated, so that this file does not match itself. */
const std::string              Slash = "/";
const std::vector<std::string> MachineFolders{ Slash + "home/",
                                               Slash + "root/",
                                               Slash + "work/",
                                               Slash + "Users/",
                                               std::string(":\\") + "Users" };
const std::vector<std::string> ForeignLicenses{ std::string("General ") + "Public License",
                                                std::string("All rights ") + "reserved",
                                                std::string("Copy") + "right (" };
/** Nested calls may deadlock; if progress throws, they return while threads are still running. */
const std::vector<std::string> OtherLoops{ std::string("MultiThreaderBase::New()") + "->Parallelize",
                                           std::string("GetMultiThreader()") + "->Parallelize" };

void
FindWords(const std::string &              text,
          const std::vector<std::string> & words,
          const std::string &              file,
          const std::string &              message,
          Faults &                         faults)
{
  int number = 0;
  for (const std::string & line : Lines(text))
  {
    ++number;
    for (const std::string & word : words)
    {
      if (line.find(word) != std::string::npos)
      {
        faults.push_back({ file, number, message + word });
      }
    }
  }
}
} // namespace

Faults
CheckLinks(const fs::path & root)
{
  Faults faults;
  for (const fs::path & page : RepositoryFiles(root))
  {
    if (!IsMarkdown(page))
    {
      continue;
    }
    for (const Link & link : LinksOf(ReadText(page)))
    {
      const std::string fault = IsOfTheWeb(link.target) ? std::string() : FaultOfLink(link.target, page, root);
      if (!fault.empty())
      {
        faults.push_back({ Shown(page, root), link.line, fault });
      }
    }
  }
  return faults;
}

Faults
CheckPages(const fs::path & root)
{
  Faults faults;
  CheckReadmes(root, faults);
  CheckDataSources(root, faults);
  return faults;
}

Faults
CheckSizes(const fs::path & root)
{
  Faults faults;
  for (const fs::path & file : RepositoryFiles(root))
  {
    if (const auto size = fs::file_size(file); size > LargestFile)
    {
      faults.push_back({ Shown(file, root), 0, "has " + std::to_string(size) + " bytes, more than 1 MB" });
    }
  }
  return faults;
}

Faults
CheckTexts(const fs::path & root)
{
  Faults faults;
  for (const fs::path & file : RepositoryFiles(root))
  {
    const std::string text = ReadText(file);
    if (!IsText(text))
    {
      continue;
    }
    FindWords(text, MachineFolders, Shown(file, root), "contains a machine-specific path: ", faults);
    if (IsSource(file))
    {
      FindWords(text, ForeignLicenses, Shown(file, root), "contains a foreign license: ", faults);
      FindWords(text, OtherLoops, Shown(file, root), "has a loop that does not use shapetonParallelFor.h: ", faults);
    }
  }
  return faults;
}

Faults
CheckTools(const fs::path & root)
{
  Faults         faults;
  const fs::path applications = root / "Applications";
  if (!fs::exists(applications))
  {
    return faults;
  }
  for (const fs::path & file : RepositoryFiles(applications))
  {
    const bool        isTool = IsSource(file) && file.parent_path().parent_path() == applications;
    const std::size_t lines = isTool ? Lines(ReadText(file)).size() : 0;
    if (lines > LongestTool)
    {
      faults.push_back(
        { Shown(file, root), 0, "has " + std::to_string(lines) + " lines, more than 150; move code to a module" });
    }
  }
  return faults;
}
} // namespace rules
