#include "ModuleLayers.h"
#include "SourceTree.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace rules
{
namespace
{
using Names = std::vector<std::string>;

struct Module
{
  fs::path                     folder;
  std::string                  name;
  std::size_t                  position{ 0 };
  std::map<std::string, Names> dependencies; ///< keys: DEPENDS, PRIVATE_DEPENDS, ...
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

/** Returns the words between `opening` and the next closing parenthesis. */
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

/** Returns the header that a line includes, or an empty string. */
std::string
IncludeOf(const std::string & line)
{
  static const std::regex include(R"re(^\s*#\s*include\s*["<]([^">]+)[">].*)re");
  std::smatch             match;
  return std::regex_match(line, match, include) ? match[1].str() : std::string();
}

/** Groups of modules; each may use the groups before it. */
const Names Groups{
  "Core", "Mesh", "IO", "Filtering", "Phantom", "Graph", "Colon", "Bridge", "Visualization", "Tools"
};

/** Headers of ITK modules that modules must declare; ITKCommon is used everywhere. */
const std::map<std::string, std::string> HeadersOfItk{
  { "ITKConnectedComponents", "itkConnectedComponent\\w+\\.h" },
  { "ITKDistanceMap", "itk\\w+DistanceMap\\w+\\.h" },
  { "ITKExpat", "(itk_)?expat\\.h" },
  { "ITKGDCM", "gdcm\\w+\\.h" },
  { "ITKGoogleTest", ".*" },
  { "ITKIOGDCM", "itkGDCM\\w+\\.h" },
  { "ITKIOImageBase", "itkImage(IOBase|FileReader|FileWriter|SeriesReader)\\.h" },
  { "ITKIOMeta", "itkMetaImageIO\\.h" },
  { "ITKIONIFTI", "itkNiftiImageIO\\.h" },
  { "ITKIONRRD", "itkNrrdImageIO\\.h" },
  { "ITKIOPNG", "itkPNGImageIO\\.h" },
  { "ITKImageFunction", "itk\\w+ImageFunction\\.h" },
  { "ITKImageGrid", "itk(ChangeInformation|RegionOfInterest)ImageFilter\\.h" },
  { "ITKImageSources", "itkGenerateImageSource\\.h" },
  { "ITKMesh", "itk(Mesh|MeshSource|\\w+MeshFilter)\\.h" },
  { "ITKQuadEdgeMesh", "itkQuadEdge\\w+\\.h" },
  { "ITKSmoothing", "itk\\w+GaussianImageFilter\\.h" },
  { "ITKZLIB", "(itk_)?zlib\\.h" }
};

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
      this->CheckUses(entry.second);
      this->CheckIncludes(entry.second);
    }
    return m_Faults;
  }

  std::string
  Describe()
  {
    this->ReadList();
    std::set<std::string> headers;
    std::size_t           arrows = 0;
    std::string           lines;
    for (auto & entry : m_Modules)
    {
      this->ReadModule(entry.second);
    }
    for (const Module & module : this->InOrder())
    {
      const Names ours = this->OwnDependencies(module);
      arrows += ours.size();
      lines += module.folder.lexically_relative(m_Root / "Modules").generic_string() + ':';
      for (const std::string & name : ours)
      {
        lines += ' ' + name;
      }
      lines += '\n';
    }
    return lines + std::to_string(m_Modules.size()) + " modules, " + std::to_string(arrows) + " arrows, " +
           this->CountHeaders();
  }

private:
  std::vector<Module>
  InOrder() const
  {
    std::vector<Module> modules(m_Modules.size());
    for (const auto & entry : m_Modules)
    {
      modules[entry.second.position] = entry.second;
    }
    return modules;
  }

  Names
  OwnDependencies(const Module & module) const
  {
    Names ours;
    for (const char * const kind : { "DEPENDS", "PRIVATE_DEPENDS" })
    {
      const auto names = module.dependencies.find(kind);
      for (const std::string & name : names == module.dependencies.end() ? Names() : names->second)
      {
        if (m_Modules.count(name))
        {
          ours.push_back(name);
        }
      }
    }
    return ours;
  }

  /** Numbers of public headers, and of those included outside of their module. */
  std::string
  CountHeaders() const
  {
    std::set<std::string> used;
    for (const char * const folder : { "Modules", "Applications", "Testing", "Examples" })
    {
      for (const fs::path & file :
           fs::exists(m_Root / folder) ? RepositoryFiles(m_Root / folder) : std::vector<fs::path>())
      {
        for (const std::string & text : IsSource(file) ? Lines(ReadText(file)) : std::vector<std::string>())
        {
          const std::string header = fs::path(IncludeOf(text)).filename().string();
          const auto        owner = m_Owners.find(header);
          if (owner != m_Owners.end() && Shown(file, m_Modules.at(owner->second).folder).compare(0, 2, "..") == 0)
          {
            used.insert(header);
          }
        }
      }
    }
    const auto isPublic = [](const std::string & name) {
      return name.size() > 2 && name.compare(name.size() - 2, 2, ".h") == 0 &&
             name.find("Export.h") == std::string::npos;
    };
    std::size_t headers = 0;
    std::size_t usedHeaders = 0;
    for (const auto & entry : m_Owners)
    {
      headers += isPublic(entry.first);
      usedHeaders += isPublic(entry.first) && used.count(entry.first);
    }
    return std::to_string(headers) + " public headers, " + std::to_string(usedHeaders) + " used outside their module\n";
  }

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
      this->CheckGroup(list, module);
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
      this->Add(list, 0, "does not list any module");
    }
  }

  void
  CheckGroup(const fs::path & list, const Module & module)
  {
    const std::string name = module.folder.parent_path().filename().string();
    const auto        group = std::find(Groups.begin(), Groups.end(), name);
    if (group == Groups.end())
    {
      this->Add(list, 0, "names the module " + module.name + " in the unknown group " + name);
      return;
    }
    if (group - Groups.begin() < m_Group)
    {
      this->Add(list, 0, "names the module " + module.name + " of " + name + " after a module of " + Groups[m_Group]);
    }
    m_Group = std::max(m_Group, group - Groups.begin());
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
        this->Add(file, 0, "is not listed in CMake/Modules.cmake");
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
    const std::string text = WithoutComments(ReadText(file));
    this->CheckDeclaration(file, text);
    const Names arguments = ArgumentsOf(text, "itk_module(");
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

  /** Checks the requirements of ITK's build for remote modules. */
  void
  CheckDeclaration(const fs::path & file, const std::string & text)
  {
    if (text.find("EXCLUDE_FROM_DEFAULT") == std::string::npos)
    {
      this->Add(file, 0, "must set EXCLUDE_FROM_DEFAULT, so that ITK does not build the module by default");
    }
    if (text.find(';') != std::string::npos)
    {
      this->Add(file, 0, "contains a semicolon, which ITK takes for an argument separator");
    }
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
    for (const fs::path & header :
         fs::exists(module.folder / "test") ? RepositoryFiles(module.folder / "test") : std::vector<fs::path>())
    {
      if (header.extension() == ".h")
      {
        m_TestHeaders.emplace(header.filename().string(), header);
      }
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
          this->Add(module.folder / "itk-module.cmake", 0, kind + " names " + name + ", which is not a module");
        }
        else if (dependency != m_Modules.end() && dependency->second.position >= module.position)
        {
          this->Add(
            module.folder / "itk-module.cmake", 0, kind + " names " + name + ", which is not an earlier module");
        }
      }
    }
  }

  /** Headers included by the files of a part of a module, including those reached through shared test headers and
   * through sources that tests include. */
  std::set<std::string>
  IncludedIn(const Module & module, const std::string & part) const
  {
    std::set<std::string> headers;
    const fs::path        folder = module.folder / part;
    for (const fs::path & file : fs::exists(folder) ? RepositoryFiles(folder) : std::vector<fs::path>())
    {
      if (IsSource(file))
      {
        this->AddIncludesOf(file, part == "test" ? module.folder / "src" : fs::path(), headers);
      }
    }
    return headers;
  }

  void
  AddIncludesOf(const fs::path & file, const fs::path & source, std::set<std::string> & headers) const
  {
    for (const std::string & text : Lines(ReadText(file)))
    {
      const std::string header = fs::path(IncludeOf(text)).filename().string();
      const auto        shared = m_TestHeaders.find(header);
      if (header.empty() || !headers.insert(header).second)
      {
        continue;
      }
      if (shared != m_TestHeaders.end())
      {
        this->AddIncludesOf(shared->second, source, headers);
      }
      else if (!source.empty() && fs::exists(source / header))
      {
        this->AddIncludesOf(source / header, source, headers);
      }
    }
  }

  bool
  IsUsed(const std::string & dependency, const std::set<std::string> & headers) const
  {
    if (dependency.compare(0, 3, "ITK") != 0)
    {
      return std::any_of(headers.begin(), headers.end(), [&](const std::string & header) {
        const auto owner = m_Owners.find(header);
        const auto test = m_TestHeaders.find(header);
        return (owner != m_Owners.end() && owner->second == dependency) ||
               (test != m_TestHeaders.end() && test->second.parent_path().parent_path().filename() == dependency);
      });
    }
    const auto       known = HeadersOfItk.find(dependency);
    const std::regex pattern(known == HeadersOfItk.end() ? "(itk[A-Z]|gtest).*" : known->second);
    return std::any_of(
      headers.begin(), headers.end(), [&](const std::string & h) { return std::regex_match(h, pattern); });
  }

  void
  CheckUses(const Module & module)
  {
    const std::map<std::string, std::string> parts{ { "DEPENDS", "include" },
                                                    { "PRIVATE_DEPENDS", "src" },
                                                    { "TEST_DEPENDS", "test" } };
    for (const auto & [kind, part] : parts)
    {
      const auto names = module.dependencies.find(kind);
      if (names == module.dependencies.end())
      {
        continue;
      }
      const std::set<std::string> headers = this->IncludedIn(module, part);
      for (const std::string & name : names->second)
      {
        if (!this->IsUsed(name, headers))
        {
          this->Add(
            module.folder / "itk-module.cmake", 0, kind + " names " + name + ", which no file in " + part + " uses");
        }
      }
    }
  }

  /** Modules whose headers a file in `part` of a module may include. */
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
  std::map<std::string, std::string> m_Owners;      ///< header name to module name
  std::map<std::string, fs::path>    m_TestHeaders; ///< shared test headers
  std::ptrdiff_t                     m_Group{ 0 };  ///< group of the last module
  Faults                             m_Faults;
};
} // namespace

Faults
CheckModuleLayers(const fs::path & root)
{
  return Layers(root).Check();
}

std::string
DescribeModuleGraph(const fs::path & root)
{
  return Layers(root).Describe();
}

Faults
CheckLibraryTexts(const fs::path & root)
{
  static const std::regex entersItk("^\\s*namespace itk\\b.*");
  static const std::regex namesOption("\"([^\"\\\\]|\\\\.)*--[a-zA-Z]([^\"\\\\]|\\\\.)*\"");
  Faults                  faults;
  for (const fs::path & file : RepositoryFiles(root / "Modules"))
  {
    const std::string shown = Shown(file, root);
    const bool isLibrary = shown.compare(0, 14, "Modules/Tools/") != 0 && shown.find("/test/") == std::string::npos;
    int        line = 0;
    for (const std::string & text : IsSource(file) ? Lines(ReadText(file)) : std::vector<std::string>())
    {
      ++line;
      if (std::regex_match(text, entersItk))
      {
        faults.push_back({ shown, line, "opens the namespace itk; use shapeton" });
      }
      if (isLibrary && std::regex_search(text, namesOption))
      {
        faults.push_back({ shown, line, "names an option; name the parameter, for example: the parameter \\\"p\\\"" });
      }
    }
  }
  return faults;
}
} // namespace rules
