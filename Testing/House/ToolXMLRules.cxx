#include "ToolXMLRules.h"
#include "XMLDocument.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace house
{
namespace
{
using Names = std::set<std::string>;
/** Attribute to its values; an empty set allows any value. */
using Attributes = std::map<std::string, Names>;

const Names Booleans{ "false", "true" };
const Names CoordinateSystems{ "ijk", "lps", "ras" };

/** What Slicer's parser reads of each kind of parameter. An attribute it ignores is a mistake as well. */
const std::map<std::string, Attributes> &
ParameterKinds()
{
  static const Attributes                        scalar{ { "hidden", Booleans }, { "multiple", Booleans } };
  static const Attributes                        hidden{ { "hidden", Booleans } };
  static const std::map<std::string, Attributes> kinds{
    { "integer", scalar },
    { "float", scalar },
    { "double", scalar },
    { "string", scalar },
    { "boolean", hidden },
    { "integer-vector", {} },
    { "float-vector", {} },
    { "double-vector", {} },
    { "string-vector", {} },
    { "integer-enumeration", hidden },
    { "float-enumeration", hidden },
    { "double-enumeration", hidden },
    { "string-enumeration", hidden },
    { "point", { { "multiple", Booleans }, { "coordinateSystem", CoordinateSystems } } },
    { "region", { { "multiple", Booleans }, { "coordinateSystem", CoordinateSystems } } },
    { "pointfile",
      { { "multiple", Booleans },
        { "type", { "any", "point", "line", "angle", "curve", "closedcurve" } },
        { "fileExtensions", {} },
        { "coordinateSystem", CoordinateSystems } } },
    { "file", { { "multiple", Booleans }, { "fileExtensions", {} } } },
    { "directory", { { "multiple", Booleans } } },
    { "transform",
      { { "multiple", Booleans },
        { "type", { "linear", "nonlinear", "bspline" } },
        { "fileExtensions", {} },
        { "reference", {} } } },
    { "image",
      { { "multiple", Booleans },
        { "type",
          { "any",
            "scalar",
            "label",
            "tensor",
            "diffusion-weighted",
            "vector",
            "signal",
            "multichannel",
            "dynamic-contrast-enhanced" } },
        { "fileExtensions", {} },
        { "hidden", Booleans },
        { "reference", {} } } },
    { "geometry",
      { { "multiple", Booleans },
        { "aggregate", Booleans },
        { "type", { "fiberbundle", "model" } },
        { "fileExtensions", {} },
        { "reference", {} } } },
    { "table",
      { { "multiple", Booleans },
        { "type", { "color" } },
        { "fileExtensions", {} },
        { "hidden", Booleans },
        { "reference", {} } } },
    { "measurement",
      { { "multiple", Booleans },
        { "type", {} },
        { "fileExtensions", {} },
        { "hidden", Booleans },
        { "reference", {} } } }
  };
  return kinds;
}

const Names HeadElements{ "category",    "title",    "description",      "version", "documentation-url", "license",
                          "contributor", "location", "acknowledgements", "index",   "parameters" };
const Names RequiredHeadElements{ "category", "title", "version", "license", "contributor" };
const Names ParameterElements{ "name",    "flag",  "longflag", "label",       "description", "default",
                               "channel", "index", "element",  "constraints", "reference" };
const Names ConstraintElements{ "minimum", "maximum", "step" };
/** Options that itk::CommandLine or Slicer gives every tool. */
const Names ReservedNames{
  "help",      "version",    "xml", "quiet", "echo", "returnparameterfile", "processinformationaddress",
  "serialize", "deserialize"
};
/** Data that Slicer hands over as files made from nodes of its scene. */
const Names NodeKinds{ "image", "geometry", "transform", "table", "measurement", "pointfile" };

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/** "double-vector" to "double". */
std::string
ElementKind(const std::string & kind)
{
  return kind.substr(0, kind.find('-'));
}

bool
IsNumeric(const std::string & kind)
{
  const std::string element = ElementKind(kind);
  return element == "integer" || element == "float" || element == "double";
}

bool
IsVector(const std::string & kind)
{
  return EndsWith(kind, "-vector");
}

bool
IsEnumeration(const std::string & kind)
{
  return EndsWith(kind, "-enumeration");
}

bool
IsSimple(const std::string & kind)
{
  return IsNumeric(kind) || ElementKind(kind) == "string" || kind == "boolean";
}

bool
IsIdentifier(const std::string & text)
{
  const auto isWord = [](unsigned char c) { return c == '_' || (c < 128 && std::isalnum(c)); };
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), isWord);
}

bool
IsCamelCase(const std::string & text)
{
  return IsIdentifier(text) && std::islower(static_cast<unsigned char>(text[0])) && text.find('_') == std::string::npos;
}

/** The whole text as a number of that kind. */
std::optional<double>
ToNumber(const std::string & text, const std::string & kind)
{
  const char * const end = text.data() + text.size();
  if (ElementKind(kind) == "integer")
  {
    int        value = 0;
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end ? std::optional<double>(value) : std::nullopt;
  }
  double     value = 0.0;
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional<double>(value) : std::nullopt;
}

std::vector<std::string>
Split(const std::string & text)
{
  std::vector<std::string> parts;
  std::istringstream       stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  if (!text.empty() && text.back() == ',')
  {
    parts.emplace_back();
  }
  return parts;
}

std::string
Join(const Names & names)
{
  std::string text;
  for (const std::string & name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

class Checker
{
public:
  Checker(std::string file, std::string version) : m_File(std::move(file)), m_Version(std::move(version)) {}

  Faults
  Check(const std::string & xml)
  {
    if (xml.compare(0, 6, "<?xml ") != 0)
    {
      this->Add(1, "must begin with <?xml version=\"1.0\" encoding=\"utf-8\"?>");
    }
    try
    {
      const XMLElement root = ParseXML(xml);
      this->CheckExecutable(root);
    }
    catch (const XMLError & error)
    {
      this->Add(error.line, "is not well-formed: " + error.message);
    }
    return m_Faults;
  }

private:
  void
  Add(int line, const std::string & message)
  {
    m_Faults.push_back({ m_File, line, message });
  }

  void
  CheckExecutable(const XMLElement & root)
  {
    if (root.name != "executable")
    {
      this->Add(root.line, "the root element must be <executable>, not <" + root.name + ">");
      return;
    }
    this->CheckAttributes(root, {});
    this->CheckChildren(root, HeadElements, { "parameters" });
    for (const std::string & name : RequiredHeadElements)
    {
      this->RequireText(root, name);
    }
    this->RequireSentence(root);
    this->RequireValue(root, "version", m_Version);
    this->RequireValue(root, "license", "Apache-2.0");
    for (const XMLElement & child : root.children)
    {
      if (child.name == "parameters")
      {
        this->CheckGroup(child);
      }
    }
    this->CheckUniqueness();
    this->CheckPositions();
    this->CheckReferences();
    this->CheckThreads(root);
    this->CheckVolumeOptions(root);
    this->CheckSurfaceOptions(root);
  }

  void
  CheckGroup(const XMLElement & group)
  {
    this->CheckAttributes(group, { { "advanced", Booleans } });
    this->RequireText(group, "label");
    this->RequireSentence(group);
    Names kinds{ "label", "description" };
    for (const auto & kind : ParameterKinds())
    {
      kinds.insert(kind.first);
    }
    Names repeatable = kinds;
    repeatable.erase("label");
    repeatable.erase("description");
    this->CheckChildren(group, kinds, repeatable);
    const auto before = m_Parameters.size();
    for (const XMLElement & child : group.children)
    {
      if (repeatable.count(child.name))
      {
        m_Parameters.push_back(&child);
        this->CheckParameter(child);
      }
    }
    if (m_Parameters.size() == before)
    {
      this->Add(group.line, "<parameters> holds no parameter");
    }
  }

  void
  CheckParameter(const XMLElement & parameter)
  {
    this->CheckAttributes(parameter, ParameterKinds().at(parameter.name));
    this->CheckChildren(parameter, ParameterElements, { "element", "reference" });
    this->RequireText(parameter, "label");
    this->RequireSentence(parameter);
    this->CheckNames(parameter);
    this->CheckChannel(parameter);
    this->CheckIndex(parameter);
    this->CheckConstraints(parameter);
    this->CheckElements(parameter);
    this->CheckDefault(parameter);
    this->CheckFileExtensions(parameter);
  }

  void
  CheckAttributes(const XMLElement & element, const Attributes & allowed)
  {
    for (const auto & [name, value] : element.attributes)
    {
      const auto known = allowed.find(name);
      if (known == allowed.end())
      {
        this->Add(element.line, "<" + element.name + "> has no attribute \"" + name + "\"");
      }
      else if (!known->second.empty() && !known->second.count(value))
      {
        this->Add(element.line,
                  "attribute \"" + name + "\" of <" + element.name + "> is \"" + value + "\", none of " +
                    Join(known->second));
      }
    }
  }

  /** Only known children, each once unless it is repeatable, and no text between them. */
  void
  CheckChildren(const XMLElement & element, const Names & allowed, const Names & repeatable)
  {
    if (!element.text.empty())
    {
      this->Add(element.line, "<" + element.name + "> holds stray text \"" + element.text + "\"");
    }
    Names seen;
    for (const XMLElement & child : element.children)
    {
      if (!allowed.count(child.name))
      {
        this->Add(child.line, "<" + child.name + "> is not allowed in <" + element.name + ">");
      }
      else if (!seen.insert(child.name).second && !repeatable.count(child.name))
      {
        this->Add(child.line, "<" + child.name + "> appears twice in <" + element.name + ">");
      }
      const bool isLeaf =
        !ParameterKinds().count(child.name) && child.name != "parameters" && child.name != "constraints";
      if (isLeaf && !child.children.empty())
      {
        this->Add(child.line, "<" + child.name + "> holds elements where only text belongs");
      }
      if (isLeaf && child.name != "reference")
      {
        this->CheckAttributes(child, {}); // itk::CommandLine reads no alias of a flag
      }
    }
  }

  void
  RequireText(const XMLElement & element, const std::string & child)
  {
    if (element.TextOf(child).empty())
    {
      this->Add(element.line, this->NameOf(element) + " lacks <" + child + ">");
    }
  }

  void
  RequireSentence(const XMLElement & element)
  {
    this->RequireText(element, "description");
    const std::string text = element.TextOf("description");
    if (!text.empty() && text.back() != '.')
    {
      this->Add(element.line, "the <description> of " + this->NameOf(element) + " must end with a full stop");
    }
  }

  void
  RequireValue(const XMLElement & element, const std::string & child, const std::string & value)
  {
    const std::string text = element.TextOf(child);
    if (!text.empty() && text != value)
    {
      this->Add(element.Find(child)->line, "<" + child + "> is \"" + text + "\", must be \"" + value + "\"");
    }
  }

  static std::string
  NameOf(const XMLElement & element)
  {
    const std::string name = element.TextOf("name");
    return name.empty() ? "<" + element.name + ">" : "<" + element.name + "> " + name;
  }

  void
  CheckNames(const XMLElement & parameter)
  {
    const std::string name = parameter.TextOf("name");
    const std::string longflag = parameter.TextOf("longflag");
    const std::string flag = parameter.TextOf("flag");
    if (!IsCamelCase(name))
    {
      this->Add(parameter.line,
                NameOf(parameter) + ": <name> must be camelCase: letters and digits, a small letter first");
    }
    if (parameter.Find("longflag") && longflag != name)
    {
      this->Add(parameter.line, NameOf(parameter) + ": <longflag> \"" + longflag + "\" differs from <name>");
    }
    if (ReservedNames.count(name))
    {
      this->Add(parameter.line, NameOf(parameter) + ": the name is reserved");
    }
    if (parameter.Find("flag") &&
        (flag.size() != 1 || !std::isalpha(static_cast<unsigned char>(flag[0])) || flag == "h"))
    {
      this->Add(parameter.line, NameOf(parameter) + ": <flag> \"" + flag + "\" must be one letter other than h");
    }
    if (parameter.Find("flag") && !parameter.Find("longflag"))
    {
      this->Add(parameter.line, NameOf(parameter) + ": a <flag> needs a <longflag>");
    }
  }

  void
  CheckChannel(const XMLElement & parameter)
  {
    const std::string channel = parameter.TextOf("channel");
    if (parameter.Find("channel") && channel != "input" && channel != "output")
    {
      this->Add(parameter.line, NameOf(parameter) + ": <channel> is \"" + channel + "\", none of input, output");
    }
    const bool isData = NodeKinds.count(parameter.name) || parameter.name == "file" || parameter.name == "directory";
    if (isData && !parameter.Find("channel"))
    {
      this->Add(parameter.line, NameOf(parameter) + " lacks <channel>");
    }
    if (parameter.Find("longflag") || parameter.Find("flag") || parameter.Find("index"))
    {
      return;
    }
    if (channel != "output" || !IsSimple(parameter.name))
    {
      this->Add(parameter.line,
                NameOf(parameter) + " needs a <longflag> or an <index>; only a return value, a simple " +
                  "type with the channel output, has neither");
    }
  }

  void
  CheckIndex(const XMLElement & parameter)
  {
    if (!parameter.Find("index"))
    {
      return;
    }
    if (parameter.Find("flag") || parameter.Find("longflag"))
    {
      this->Add(parameter.line, NameOf(parameter) + ": <index> excludes <flag> and <longflag>");
    }
    if (parameter.name == "point" || parameter.name == "region" || parameter.name == "boolean")
    {
      this->Add(parameter.line, NameOf(parameter) + " cannot be positional");
    }
    if (ToNumber(parameter.TextOf("index"), "integer").value_or(-1) < 0)
    {
      this->Add(parameter.line, NameOf(parameter) + ": <index> must be an integer from 0 on");
    }
  }

  void
  CheckConstraints(const XMLElement & parameter)
  {
    const XMLElement * constraints = parameter.Find("constraints");
    if (!constraints)
    {
      return;
    }
    if (!IsNumeric(parameter.name) || IsEnumeration(parameter.name))
    {
      this->Add(constraints->line, NameOf(parameter) + " cannot have <constraints>");
      return;
    }
    this->CheckAttributes(*constraints, {});
    this->CheckChildren(*constraints, ConstraintElements, {});
    for (const XMLElement & limit : constraints->children)
    {
      if (!ToNumber(limit.text, parameter.name))
      {
        this->Add(limit.line,
                  NameOf(parameter) + ": <" + limit.name + "> \"" + limit.text + "\" is no number of the type");
      }
    }
    const auto minimum = this->LimitOf(parameter, "minimum");
    const auto maximum = this->LimitOf(parameter, "maximum");
    if (minimum && maximum && *minimum > *maximum)
    {
      this->Add(constraints->line, NameOf(parameter) + ": <minimum> is greater than <maximum>");
    }
    if (constraints->Find("step") && this->LimitOf(parameter, "step").value_or(1) <= 0)
    {
      this->Add(constraints->line, NameOf(parameter) + ": <step> must be greater than 0");
    }
  }

  static std::optional<double>
  LimitOf(const XMLElement & parameter, const std::string & limit)
  {
    const XMLElement * constraints = parameter.Find("constraints");
    return constraints ? ToNumber(constraints->TextOf(limit), parameter.name) : std::nullopt;
  }

  void
  CheckElements(const XMLElement & parameter)
  {
    std::size_t count = 0;
    Names       values;
    for (const XMLElement & child : parameter.children)
    {
      if (child.name != "element")
      {
        continue;
      }
      ++count;
      if (!values.insert(child.text).second)
      {
        this->Add(child.line, NameOf(parameter) + ": <element> \"" + child.text + "\" appears twice");
      }
      if (IsNumeric(parameter.name) && !ToNumber(child.text, parameter.name))
      {
        this->Add(child.line, NameOf(parameter) + ": <element> \"" + child.text + "\" is no number of the type");
      }
    }
    if (IsEnumeration(parameter.name) != (count > 0))
    {
      this->Add(parameter.line,
                NameOf(parameter) + (count ? " is no enumeration but has <element>" : " lacks <element>"));
    }
    const std::string value = parameter.TextOf("default");
    if (count && parameter.Find("default") && !values.count(value))
    {
      this->Add(parameter.line, NameOf(parameter) + ": <default> \"" + value + "\" is none of its elements");
    }
  }

  void
  CheckDefault(const XMLElement & parameter)
  {
    const bool        isGiven = !parameter.TextOf("default").empty();
    const std::string value = parameter.TextOf("default");
    if (parameter.name == "boolean" && isGiven && value != "false")
    {
      this->Add(parameter.line, NameOf(parameter) + ": the <default> of a boolean must be false");
    }
    if (isGiven && NodeKinds.count(parameter.name))
    {
      this->Add(parameter.line, NameOf(parameter) + " cannot have a <default>: Slicer takes it for the name of a node");
    }
    if (isGiven && parameter.Find("index"))
    {
      this->Add(parameter.line, NameOf(parameter) + ": a positional argument is never left out and has no <default>");
    }
    // Slicer always passes a scalar option, with an empty value where it has no default.
    const bool isAlwaysPassed =
      (IsNumeric(parameter.name) && !IsVector(parameter.name)) || IsEnumeration(parameter.name);
    if (!isGiven && isAlwaysPassed && parameter.Find("longflag"))
    {
      this->Add(parameter.line, NameOf(parameter) + " lacks <default>");
    }
    if (isGiven && IsNumeric(parameter.name) && !IsEnumeration(parameter.name))
    {
      for (const std::string & part : IsVector(parameter.name) ? Split(value) : std::vector<std::string>{ value })
      {
        this->CheckDefaultNumber(parameter, part);
      }
    }
  }

  void
  CheckDefaultNumber(const XMLElement & parameter, const std::string & text)
  {
    const auto value = ToNumber(text, parameter.name);
    if (!value)
    {
      this->Add(parameter.line, NameOf(parameter) + ": <default> \"" + text + "\" is no number of the type");
      return;
    }
    const auto minimum = this->LimitOf(parameter, "minimum");
    const auto maximum = this->LimitOf(parameter, "maximum");
    if ((minimum && *value < *minimum) || (maximum && *value > *maximum))
    {
      this->Add(parameter.line, NameOf(parameter) + ": <default> " + text + " lies outside its constraints");
    }
  }

  void
  CheckFileExtensions(const XMLElement & parameter)
  {
    for (const std::string & extension : Split(parameter.Attribute("fileExtensions")))
    {
      if (extension.size() < 2 || extension[0] != '.')
      {
        this->Add(parameter.line,
                  NameOf(parameter) + ": file extension \"" + extension + "\" must begin with a full stop");
      }
    }
  }

  void
  CheckUniqueness()
  {
    Names names;
    Names flags;
    for (const XMLElement * parameter : m_Parameters)
    {
      if (!names.insert(parameter->TextOf("name")).second)
      {
        this->Add(parameter->line, NameOf(*parameter) + ": the name is taken");
      }
      if (parameter->Find("flag") && !flags.insert(parameter->TextOf("flag")).second)
      {
        this->Add(parameter->line, NameOf(*parameter) + ": <flag> " + parameter->TextOf("flag") + " is taken");
      }
    }
  }

  /** Indices run from 0 without gaps; only the last positional argument may take several values. */
  void
  CheckPositions()
  {
    std::map<int, const XMLElement *> positions;
    for (const XMLElement * parameter : m_Parameters)
    {
      if (!parameter->Find("index"))
      {
        continue;
      }
      const int index = static_cast<int>(ToNumber(parameter->TextOf("index"), "integer").value_or(-1));
      if (!positions.emplace(index, parameter).second)
      {
        this->Add(parameter->line, NameOf(*parameter) + ": <index> " + std::to_string(index) + " is taken");
      }
    }
    int expected = 0;
    for (const auto & [index, parameter] : positions)
    {
      if (index != expected++)
      {
        this->Add(parameter->line, NameOf(*parameter) + ": the indices must run from 0 without a gap");
        return;
      }
      if (parameter->Attribute("multiple") == "true" && expected != static_cast<int>(positions.size()))
      {
        this->Add(parameter->line, NameOf(*parameter) + ": only the last positional argument may be multiple");
      }
    }
  }

  void
  CheckReferences()
  {
    Names names;
    for (const XMLElement * parameter : m_Parameters)
    {
      names.insert(parameter->TextOf("name"));
    }
    const auto check = [&](const XMLElement & place, const std::string & name) {
      if (!name.empty() && !names.count(name))
      {
        this->Add(place.line, "the reference to \"" + name + "\" names no parameter");
      }
    };
    for (const XMLElement * parameter : m_Parameters)
    {
      check(*parameter, parameter->Attribute("reference"));
      for (const XMLElement & child : parameter->children)
      {
        if (child.name == "reference")
        {
          this->CheckAttributes(child, { { "role", {} }, { "parameter", {} } });
          check(child, child.Attribute("parameter"));
        }
      }
    }
  }

  const XMLElement *
  FindParameter(const std::string & name) const
  {
    const auto found = std::find_if(m_Parameters.begin(), m_Parameters.end(), [&](const XMLElement * parameter) {
      return parameter->TextOf("name") == name;
    });
    return found == m_Parameters.end() ? nullptr : *found;
  }

  void
  CheckThreads(const XMLElement & root)
  {
    const XMLElement * threads = this->FindParameter("threads");
    if (!threads)
    {
      this->Add(root.line, "the option threads is missing");
    }
    else if (threads->name != "integer" || threads->TextOf("default") != "0" || !threads->Find("longflag") ||
             this->LimitOf(*threads, "minimum") != 0.0)
    {
      this->Add(threads->line, "threads must be an <integer> option with the default 0 and the minimum 0");
    }
  }

  /** A tool that takes a volume gives its user the choice of the series and the repairs. */
  void
  CheckVolumeOptions(const XMLElement & root)
  {
    this->CheckInputOptions(root,
                            "image",
                            "volume",
                            { { "seriesUID", "string" },
                              { "resampleGaps", "boolean" },
                              { "deshear", "boolean" },
                              { "dropDuplicates", "boolean" } });
  }

  /** A tool that takes a surface gives its user the choice of part, component and unit. */
  void
  CheckSurfaceOptions(const XMLElement & root)
  {
    this->CheckInputOptions(root,
                            "geometry",
                            "surface",
                            { { "part", "string" }, { "component", "integer" }, { "unit", "string-enumeration" } });
  }

  /** A tool that has an input of this kind, or one of these options, has all of them. */
  void
  CheckInputOptions(const XMLElement &                         root,
                    const std::string &                        element,
                    const std::string &                        what,
                    const std::map<std::string, std::string> & options)
  {
    const auto takesIt = [&](const XMLElement * parameter) {
      return options.count(parameter->TextOf("name")) ||
             (parameter->name == element && parameter->TextOf("channel") == "input");
    };
    if (std::none_of(m_Parameters.begin(), m_Parameters.end(), takesIt))
    {
      return;
    }
    for (const auto & [name, kind] : options)
    {
      const XMLElement * parameter = this->FindParameter(name);
      if (!parameter)
      {
        this->Add(root.line, "a tool that takes a " + what + " must have the option " + name);
      }
      else if (parameter->name != kind || !parameter->Find("longflag"))
      {
        this->Add(parameter->line, name + " must be a <" + kind + "> option");
      }
    }
  }

  std::string                     m_File;
  std::string                     m_Version;
  std::vector<const XMLElement *> m_Parameters;
  Faults                          m_Faults;
};
} // namespace

Faults
CheckToolXML(const std::string & xml, const std::string & file, const std::string & version)
{
  return Checker(file, version).Check(xml);
}
} // namespace house
