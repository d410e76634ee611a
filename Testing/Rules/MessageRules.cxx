#include "MessageRules.h"
#include "SourceTree.h"
#include "XMLDocument.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

namespace fs = std::filesystem;

namespace rules
{
namespace
{
using Words = std::set<std::string>;

const Words BuiltIn{ "help", "version", "xml", "quiet", "returnparameterfile" };

/** Values in messages that a tool rejects but never prints. `component` = -1 is omitted if
 * SurfaceReadOptions::takesOneComponent is set; the test SurfaceReader.ASurfaceThatIsNotManifoldIsCutIntoComponents and
 * those of Testing/Advice check this. */
const std::set<std::pair<std::string, std::string>> Conditional{ { "component", "-1" } };

// ---- texts of a source ----

struct Literal
{
  int         line;
  std::string text;
};

/** The string literals of a C++ source; adjacent ones are joined. Comments are skipped. Raw strings are not supported,
 * because they do not contain messages. */
std::vector<Literal>
LiteralsOf(const std::string & source)
{
  std::vector<Literal> literals;
  int                  line = 1;
  bool                 continues = false; // only blanks and comments since the last string
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    if (source.compare(i, 2, "//") == 0)
    {
      i = std::min(source.find('\n', i), source.size());
    }
    else if (source.compare(i, 2, "/*") == 0)
    {
      const std::size_t end = std::min(source.find("*/", i + 2), source.size());
      line += static_cast<int>(std::count(source.begin() + i, source.begin() + end, '\n'));
      i = std::min(end + 1, source.size());
    }
    else if (source[i] == '\'' && i + 2 < source.size() && (source[i + 1] == '\\' || source[i + 2] == '\''))
    {
      i += source[i + 1] == '\\' ? 3 : 2;
      continues = false;
    }
    else if (source[i] == '"')
    {
      if (!continues)
      {
        literals.push_back({ line, {} });
      }
      for (++i; i < source.size() && source[i] != '"'; ++i)
      {
        i += source[i] == '\\' ? 1 : 0;
        literals.back().text += source.substr(i, 1);
      }
      continues = true;
    }
    else
    {
      continues = continues && std::isspace(static_cast<unsigned char>(source[i])) != 0;
    }
    line += i < source.size() && source[i] == '\n' ? 1 : 0;
  }
  return literals;
}

/** An option named in a text, with the text that follows it. */
struct Mention
{
  std::string tool; ///< another tool that has the option
  std::string name;
  std::string value;
  bool        isStated{ false }; ///< the value follows "="; otherwise it is the next word, which may not be a value
};

std::vector<Mention>
MentionsOf(const std::string & text)
{
  static const std::regex mention(
    R"re((?:(\w+) \()?(?:--([A-Za-z]\w*)(?:[ =]([^\s,;:)"]+))?|the parameter "(\w+)"(?: = ([^\s,;)"]+))?))re");
  std::vector<Mention> mentions;
  for (std::sregex_iterator match(text.begin(), text.end(), mention), end; match != end; ++match)
  {
    const bool isParameter = (*match)[4].matched;
    mentions.push_back({ (*match)[1], (*match)[isParameter ? 4 : 2], (*match)[isParameter ? 5 : 3], isParameter });
  }
  return mentions;
}

// ---- tools ----

struct Tool
{
  std::map<std::string, XMLElement> parameters;
  Words                             modules; ///< linked, also transitively
};

void
AddParameters(const XMLElement & element, Tool & tool)
{
  for (const XMLElement & child : element.children)
  {
    if (child.Find("name") && child.name != "parameters")
    {
      tool.parameters[child.TextOf("name")] = child;
    }
    AddParameters(child, tool);
  }
}

/** Returns the words in the parentheses after `call`. */
std::vector<std::string>
ArgumentsOf(const std::string & text, const std::string & call)
{
  const std::size_t        begin = text.find(call);
  std::vector<std::string> words;
  if (begin == std::string::npos)
  {
    return words;
  }
  const std::string       inside = text.substr(begin + call.size(), text.find(')', begin) - begin - call.size());
  static const std::regex word(R"(\w+)");
  for (std::sregex_iterator match(inside.begin(), inside.end(), word), end; match != end; ++match)
  {
    words.push_back(match->str());
  }
  return words;
}

class Messages
{
public:
  explicit Messages(const fs::path & root) : m_Root(root), m_Files(RepositoryFiles(root)) {}

  Faults
  Check()
  {
    for (const fs::path & file : m_Files)
    {
      if (file.filename() == "itk-module.cmake")
      {
        m_Dependencies[file.parent_path().filename().string()] = ArgumentsOf(ReadText(file), "itk_module(");
      }
    }
    for (const fs::path & file : m_Files)
    {
      if (file.extension() == ".xml" && file.stem() == file.parent_path().filename() &&
          this->GroupOf(file) == "Applications")
      {
        this->ReadTool(file);
      }
    }
    for (const fs::path & file : m_Files)
    {
      const bool isTest = Shown(file, m_Root).find("/test/") != std::string::npos;
      if (IsSource(file) && !isTest && (this->GroupOf(file) == "Applications" || this->GroupOf(file) == "Modules"))
      {
        this->CheckFile(file);
      }
    }
    return m_Faults;
  }

private:
  std::string
  GroupOf(const fs::path & file) const
  {
    return file.lexically_relative(m_Root).begin()->string();
  }

  void
  ReadTool(const fs::path & xml)
  {
    Tool & tool = m_Tools[xml.stem().string()];
    AddParameters(ParseXML(ReadText(xml)), tool);
    for (const std::string & module : ArgumentsOf(ReadText(xml.parent_path() / "CMakeLists.txt"), "shapeton_add_tool("))
    {
      this->AddModule(module, tool);
    }
  }

  void
  AddModule(const std::string & module, Tool & tool)
  {
    const auto dependencies = m_Dependencies.find(module);
    if (dependencies != m_Dependencies.end() && tool.modules.insert(module).second)
    {
      for (const std::string & other : dependencies->second)
      {
        this->AddModule(other, tool);
      }
    }
  }

  /** Whether a tool may print messages of a file. */
  bool
  MaySay(const std::string & name, const Tool & tool, const fs::path & file) const
  {
    const std::string shown = Shown(file, m_Root);
    if (shown.rfind("Applications/", 0) == 0)
    {
      return shown.rfind("Applications/" + name + "/", 0) == 0;
    }
    return tool.modules.count(file.parent_path().parent_path().filename().string()) > 0;
  }

  void
  CheckFile(const fs::path & file)
  {
    for (const Literal & literal : LiteralsOf(ReadText(file)))
    {
      for (const Mention & mention : MentionsOf(literal.text))
      {
        const bool isOption = GroupOf(file) == "Applications" || Shown(file, m_Root).rfind("Modules/Tools/", 0) == 0;
        if (!BuiltIn.count(mention.name) && (isOption || mention.isStated))
        {
          this->CheckMention(file, literal.line, mention);
        }
      }
    }
  }

  void
  CheckMention(const fs::path & file, int line, const Mention & mention)
  {
    const bool isOfOther = m_Tools.count(mention.tool) > 0;
    bool       isDeclared = false;
    for (const auto & [name, tool] : m_Tools)
    {
      const auto parameter = tool.parameters.find(mention.name);
      if (parameter != tool.parameters.end() && (isOfOther ? name == mention.tool : this->MaySay(name, tool, file)))
      {
        isDeclared = true;
        this->CheckValue(file, line, mention, name, parameter->second);
      }
    }
    if (!isDeclared)
    {
      m_Faults.push_back({ Shown(file, m_Root),
                           line,
                           "names the option --" + mention.name + ", which " +
                             (isOfOther ? mention.tool + " does not declare" : "no tool that may print it declares") });
    }
  }

  void
  CheckValue(const fs::path &    file,
             int                 line,
             const Mention &     mention,
             const std::string & tool,
             const XMLElement &  parameter)
  {
    const std::string & value = mention.value;
    if (value.empty() || Conditional.count({ mention.name, value }))
    {
      return;
    }
    if (const XMLElement * const constraints = parameter.Find("constraints"))
    {
      char *       end = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      const auto   isBeyond = [&](const char * bound, double sign) {
        const std::string text = constraints->TextOf(bound);
        return !text.empty() && sign * number > sign * std::strtod(text.c_str(), nullptr);
      };
      if (end != value.c_str() && (isBeyond("minimum", -1.0) || isBeyond("maximum", 1.0)))
      {
        this->AddFault(file, line, mention, tool);
      }
    }
    static const Words verbs{ "needs", "says", "is", "takes", "and", "belongs", "has", "or" };
    if (parameter.name == "string-enumeration" && !verbs.count(value) &&
        std::none_of(parameter.children.begin(), parameter.children.end(), [&](const XMLElement & child) {
          return child.name == "element" && child.text == value;
        }))
    {
      this->AddFault(file, line, mention, tool);
    }
  }

  void
  AddFault(const fs::path & file, int line, const Mention & mention, const std::string & tool)
  {
    m_Faults.push_back(
      { Shown(file, m_Root), line, "names --" + mention.name + " " + mention.value + ", which " + tool + " rejects" });
  }

  fs::path                                        m_Root;
  std::vector<fs::path>                           m_Files;
  std::map<std::string, std::vector<std::string>> m_Dependencies;
  std::map<std::string, Tool>                     m_Tools;
  Faults                                          m_Faults;
};

void
FindPattern(const std::string & text,
            const std::regex &  pattern,
            int                 line,
            const std::string & file,
            const std::string & fault,
            Faults &            faults)
{
  std::smatch match;
  if (std::regex_search(text, match, pattern))
  {
    faults.push_back({ file, line, fault + match.str() });
  }
}
} // namespace

Faults
CheckWording(const fs::path & root)
{
  const std::regex genitive(R"((/\*\*|//[/!]?<?|^ *\*) Of [a-z])");
  const std::regex negation(R"(\b(is|are) (no|none)\b)");
  const std::regex existence(R"(\bthere (is|are) no\b)");
  const std::regex metaphor(R"(\b(told|wanders?|hangs? on|belongs? beside)\b)");
  const std::regex british(
    R"((centre|colour|neighbour|behaviour|favour|caec|haemo|grey|[lm]etres?\b|(label|model)l(ed|ing)\b|cancell(ed|ing)|calibre|)"
    R"(licence|programmes?\b|analys(e|ed|ing)\b|(normal|factor|quant|equal|initial|optim|minim|maxim|vector|raster|)"
    R"(linear|recogn|general|parameter|visual|summar|character|symmetr)is(e|ed|es|ing|ation)\b))",
    std::regex::ECMAScript | std::regex::icase);
  const Words pages{ ".md", ".xml", ".py", ".mjs", ".js", ".cmake", ".sh", ".txt", ".json" };
  Faults      faults;
  for (const fs::path & file : RepositoryFiles(root))
  {
    const bool isPage = pages.count(file.extension().string()) > 0;
    if ((!IsSource(file) && !isPage) || file.stem().string().rfind("MessageRules", 0) == 0)
    {
      continue;
    }
    const std::string text = ReadText(file);
    const std::string shown = Shown(file, root);
    int               line = 0;
    for (const std::string & one : Lines(text))
    {
      FindPattern(one, metaphor, ++line, shown, "is not plain English: ", faults);
      FindPattern(one, british, line, shown, "is not American spelling: ", faults);
      if (!isPage)
      {
        FindPattern(one, genitive, line, shown, "begins a comment with a bare genitive: ", faults);
      }
    }
    if (!isPage)
    {
      for (const Literal & literal : LiteralsOf(text))
      {
        const std::string rest = std::regex_replace(literal.text, existence, "");
        FindPattern(rest, negation, literal.line, shown, "says what is not by: ", faults);
      }
    }
  }
  return faults;
}

Faults
CheckMessages(const fs::path & root)
{
  return Messages(root).Check();
}
} // namespace rules
