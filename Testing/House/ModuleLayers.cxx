#include "ModuleLayers.h"
#include "SourceTree.h"

#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace house
{
namespace
{
using Names = std::vector<std::string>;

struct Module
{
  fs::path                     folder;
  std::string                  name;
  std::size_t                  position{ 0 };
  std::map<std::string, Names> dependencies; ///< by kind: DEPENDS, PRIVATE_DEPENDS, ...
};

std::string
WithoutComments(const std::string & cmake)
{
  return std::regex_replace(cmake, std::regex("#[^\n]*"), "");
}

Names
Words(const std::string & text)
{
  std::istringstream stream(text);
  return { std::istream_iterator<std::string>(stream), {} };
}

/** The words between `opening` and the next closing parenthesis. */
Names
ArgumentsOf(const std::string & cmake, const std::string & opening)
{
  const auto start = cmake.find(opening);
  if (start == std::string::npos)
  {
    return {};
  }
  const auto first = start + opening.size();
  return Words(cmake.substr(first, cmake.find(')', first) - first));
}

/** The header that a line includes, or nothing. */
std::string
IncludeOf(const std::string & line)
{
  static const std::regex include(R"re(^\s*#\s*include\s*["<]([^">]+)[">].*)re");
  std::smatch             match;
  return std::regex_match(line, match, include) ? match[1].str() : std::string();
}

const std::map<std::string, Names> &
KindsVisibleIn()
{
  static const std::map<std::string, Names> kinds{
    { "include", { "DEPENDS", "COMPILE_DEPENDS" } },
    { "src", { "DEPENDS", "COMPILE_DEPENDS", "PRIVATE_DEPENDS" } },
    { "test", { "DEPENDS", "COMPILE_DEPENDS", "PRIVATE_DEPENDS", "TEST_DEPENDS" } }
  };
  return kinds;
}

class Layers
{
public:
  explicit Layers(fs::path root) : m_Root(std::move(root)) {}

  Faults
  Check()
  {
    this->ReadList();
    this->CheckFolders();
    for (auto & entry : m_Modules)
    {
      this->ReadModule(entry.second);
    }
    for (const auto & entry : m_Modules)
    {
      this->CheckDependencies(entry.second);
      this->CheckIncludes(entry.second);
    }
    return m_Faults;
  }

private:
  void
  Add(const fs::path & file, int line, const std::string & message)
  {
    m_Faults.push_back({ Shown(file, m_Root), line, message });
  }

  void
  ReadList()
  {
    const fs::path list = m_Root / "CMake" / "Modules.cmake";
    for (const std::string & entry : ArgumentsOf(WithoutComments(ReadText(list)), "set(Shapeton_MODULES"))
    {
      Module module;
      module.folder = m_Root / "Modules" / entry;
      module.name = module.folder.filename().string();
      module.position = m_Modules.size();
      if (!m_Modules.emplace(module.name, module).second)
      {
        this->Add(list, 0, "names the module " + module.name + " twice");
      }
      if (!fs::exists(module.folder / "itk-module.cmake"))
      {
        this->Add(list, 0, "names the module " + entry + ", which has no itk-module.cmake");
      }
    }
    if (m_Modules.empty())
    {
      this->Add(list, 0, "names no module");
    }
  }

  void
  CheckFolders()
  {
    for (const fs::path & file : RepositoryFiles(m_Root / "Modules"))
    {
      if (file.filename() != "itk-module.cmake")
      {
        continue;
      }
      const auto module = m_Modules.find(file.parent_path().filename().string());
      if (module == m_Modules.end() || module->second.folder != file.parent_path())
      {
        this->Add(file, 0, "is no module of CMake/Modules.cmake");
      }
    }
  }

  void
  ReadModule(Module & module)
  {
    const fs::path file = module.folder / "itk-module.cmake";
    if (!fs::exists(file))
    {
      return;
    }
    const Names arguments = ArgumentsOf(WithoutComments(ReadText(file)), "itk_module(");
    if (arguments.empty() || arguments[0] != module.name)
    {
      this->Add(file, 0, "must declare itk_module(" + module.name + ")");
    }
    static const std::set<std::string> keywords{ "DEPENDS",      "COMPILE_DEPENDS", "PRIVATE_DEPENDS",
                                                 "TEST_DEPENDS", "ENABLE_SHARED",   "EXCLUDE_FROM_DEFAULT",
                                                 "DESCRIPTION",  "FACTORY_NAMES" };
    std::string                        kind;
    for (const std::string & argument : arguments)
    {
      if (keywords.count(argument))
      {
        kind = argument;
      }
      else
      {
        module.dependencies[kind].push_back(argument);
      }
    }
    this->ReadHeaders(module);
  }

  void
  ReadHeaders(const Module & module)
  {
    this->AddHeader(module, module.folder / "itk-module.cmake", module.name + "Export.h");
    if (!fs::exists(module.folder / "include"))
    {
      return;
    }
    for (const fs::path & header : RepositoryFiles(module.folder / "include"))
    {
      this->AddHeader(module, header, header.filename().string());
    }
  }

  void
  AddHeader(const Module & module, const fs::path & file, const std::string & name)
  {
    const auto [owner, isNew] = m_Owners.emplace(name, module.name);
    if (!isNew)
    {
      this->Add(file, 0, "the header name " + name + " is taken by the module " + owner->second);
    }
  }

  void
  CheckDependencies(const Module & module)
  {
    for (const auto & [kind, names] : module.dependencies)
    {
      if (kind.find("DEPENDS") == std::string::npos)
      {
        continue;
      }
      for (const std::string & name : names)
      {
        const auto dependency = m_Modules.find(name);
        if (dependency == m_Modules.end() && name.compare(0, 3, "ITK") != 0)
        {
          this->Add(module.folder / "itk-module.cmake", 0, kind + " names " + name + ", which is no module");
        }
        else if (dependency != m_Modules.end() && dependency->second.position >= module.position)
        {
          this->Add(module.folder / "itk-module.cmake", 0, kind + " names " + name + ", which is no earlier module");
        }
      }
    }
  }

  /** The modules whose headers a file in `part` of a module may include. */
  std::set<std::string>
  ReachableFrom(const Module & module, const std::string & part) const
  {
    std::set<std::string> reached{ module.name };
    Names                 open;
    const auto            follow = [&](const Module & from, const std::string & seenIn) {
      for (const std::string & kind : KindsVisibleIn().at(seenIn))
      {
        const auto names = from.dependencies.find(kind);
        if (names != from.dependencies.end())
        {
          open.insert(open.end(), names->second.begin(), names->second.end());
        }
      }
    };
    follow(module, part);
    while (!open.empty())
    {
      const std::string name = open.back();
      open.pop_back();
      const auto found = m_Modules.find(name);
      if (found != m_Modules.end() && reached.insert(name).second)
      {
        follow(found->second, "include");
      }
    }
    return reached;
  }

  void
  CheckIncludes(const Module & module)
  {
    for (const auto & entry : KindsVisibleIn())
    {
      const fs::path folder = module.folder / entry.first;
      if (!fs::exists(folder))
      {
        continue;
      }
      const std::set<std::string> reachable = this->ReachableFrom(module, entry.first);
      for (const fs::path & file : RepositoryFiles(folder))
      {
        if (IsSource(file))
        {
          this->CheckFile(module, file, reachable);
        }
      }
    }
  }

  void
  CheckFile(const Module & module, const fs::path & file, const std::set<std::string> & reachable)
  {
    int line = 0;
    for (const std::string & text : Lines(ReadText(file)))
    {
      ++line;
      const std::string header = IncludeOf(text);
      if (header.find("..") != std::string::npos)
      {
        this->Add(file, line, "includes " + header + ", which leaves its folder");
      }
      const auto owner = m_Owners.find(fs::path(header).filename().string());
      if (header.empty() || owner == m_Owners.end() || reachable.count(owner->second))
      {
        continue;
      }
      const bool isLater = m_Modules.at(owner->second).position > module.position;
      this->Add(file,
                line,
                "includes " + header + " of " + owner->second +
                  (isLater ? ", a later module" : ", which its itk-module.cmake does not name"));
    }
  }

  fs::path                           m_Root;
  std::map<std::string, Module>      m_Modules;
  std::map<std::string, std::string> m_Owners; ///< header name to module name
  Faults                             m_Faults;
};
} // namespace

Faults
CheckModuleLayers(const fs::path & root)
{
  return Layers(root).Check();
}
} // namespace house
