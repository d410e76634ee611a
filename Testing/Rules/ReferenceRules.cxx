#include "ReferenceRules.h"
#include "SourceTree.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace rules
{
namespace
{
const std::vector<std::string> WantedEquations{ "2.4", "3.10", "5.5", "6.7", "8.5" };

/** A Doxygen comment without its opening and closing marks. */
struct DocComment
{
  int         line;
  std::string text;
};

std::vector<DocComment>
DocCommentsOf(const std::string & source)
{
  std::vector<DocComment> comments;
  std::size_t             counted = 0;
  int                     line = 1;
  for (std::size_t begin = source.find("/**"); begin != std::string::npos; begin = source.find("/**", begin))
  {
    const std::size_t end = std::min(source.find("*/", begin + 2), source.size());
    line += static_cast<int>(std::count(source.begin() + static_cast<std::ptrdiff_t>(counted),
                                        source.begin() + static_cast<std::ptrdiff_t>(begin),
                                        '\n'));
    counted = begin;
    if (end > begin + 3)
    {
      comments.push_back({ line, source.substr(begin + 3, end - begin - 3) });
    }
    begin = end;
  }
  return comments;
}

std::vector<fs::path>
SourcesOfModules(const fs::path & root)
{
  std::vector<fs::path> sources;
  if (fs::exists(root / "Modules"))
  {
    sources = RepositoryFiles(root / "Modules");
    sources.erase(std::remove_if(sources.begin(), sources.end(), [](const fs::path & file) { return !IsSource(file); }),
                  sources.end());
  }
  return sources;
}

/** Returns the words after a command, with the lines of their comments. */
std::vector<DocComment>
WordsAfter(const std::string & commands, const std::vector<DocComment> & comments)
{
  const std::regex        command("\\\\(" + commands + ")\\s+(\\w+)");
  std::vector<DocComment> words;
  for (const DocComment & comment : comments)
  {
    for (std::sregex_iterator match(comment.text.begin(), comment.text.end(), command), end; match != end; ++match)
    {
      words.push_back({ comment.line, (*match)[2].str() });
    }
  }
  return words;
}

/** Returns Modules/Group/Name of a file of a module. */
fs::path
ModuleOf(const fs::path & file, const fs::path & root)
{
  const fs::path inside = file.lexically_relative(root);
  auto           part = inside.begin();
  fs::path       module = root;
  for (int i = 0; i < 3 && part != inside.end(); ++i)
  {
    module /= *part++;
  }
  return module;
}

bool
NamesAGroupAlone(const std::string & comment)
{
  static const std::regex command(R"(\\(class|struct|ingroup|addtogroup)\s+\w+)");
  const std::string       rest = std::regex_replace(comment, command, "");
  return rest.size() < comment.size() && rest.find_first_not_of(" *\t\r\n") == std::string::npos;
}
} // namespace

Faults
CheckEquations(const fs::path & root)
{
  static const std::regex            mark(R"(\\equation\{([^}]*)\})");
  Faults                             faults;
  std::map<std::string, std::string> fileOf;
  for (const fs::path & file : SourcesOfModules(root))
  {
    for (const DocComment & comment : DocCommentsOf(ReadText(file)))
    {
      for (std::sregex_iterator match(comment.text.begin(), comment.text.end(), mark), end; match != end; ++match)
      {
        const std::string number = (*match)[1].str();
        const auto [first, isNew] = fileOf.emplace(number, Shown(file, root));
        if (!isNew)
        {
          faults.push_back(
            { Shown(file, root), comment.line, "marks equation (" + number + "), which " + first->second + " marks" });
        }
      }
    }
  }
  for (const std::string & number : WantedEquations)
  {
    if (!fileOf.count(number))
    {
      faults.push_back({ "Modules", 0, "no comment marks equation (" + number + ")" });
    }
  }
  return faults;
}

Faults
CheckComments(const fs::path & root)
{
  Faults faults;
  for (const fs::path & file : SourcesOfModules(root))
  {
    if (file.parent_path().filename() != "include")
    {
      continue;
    }
    for (const DocComment & comment : DocCommentsOf(ReadText(file)))
    {
      if (NamesAGroupAlone(comment.text))
      {
        faults.push_back({ Shown(file, root), comment.line, "a comment contains only a group" });
      }
    }
  }
  return faults;
}

Faults
CheckGroups(const fs::path & root)
{
  std::map<fs::path, std::set<std::string>> groupsOf;
  for (const fs::path & file : SourcesOfModules(root))
  {
    const fs::path          module = ModuleOf(file, root);
    std::set<std::string> & groups = groupsOf[module];
    groups.insert(module.filename().string());
    for (const DocComment & word : WordsAfter("defgroup", DocCommentsOf(ReadText(file))))
    {
      groups.insert(word.text);
    }
  }
  Faults faults;
  for (const fs::path & file : SourcesOfModules(root))
  {
    for (const DocComment & word : WordsAfter("ingroup|addtogroup", DocCommentsOf(ReadText(file))))
    {
      if (!groupsOf[ModuleOf(file, root)].count(word.text))
      {
        faults.push_back(
          { Shown(file, root), word.line, "names the group " + word.text + ", which is not a group of its module" });
      }
    }
  }
  return faults;
}
} // namespace rules
