#include "ParameterRules.h"

#include <cctype>

namespace rules
{
namespace
{
const Names ParameterElements{ "name",    "flag",  "longflag", "label",       "description", "default",
                               "channel", "index", "element",  "constraints", "reference" };
const Names ConstraintElements{ "minimum", "maximum", "step" };
/** Options that shapeton::CommandLine or Slicer adds to every tool. */
const Names ReservedNames{
  "help",      "version",    "xml", "quiet", "echo", "returnparameterfile", "processinformationaddress",
  "serialize", "deserialize"
};

/** Data that Slicer passes as files made from nodes of its scene. */
const Names NodeKinds{ "image", "geometry", "transform", "table", "measurement", "pointfile" };

void
CheckNames(const XMLElement & parameter, XMLFaults & faults)
{
  const std::string name = parameter.TextOf("name");
  const std::string longflag = parameter.TextOf("longflag");
  const std::string flag = parameter.TextOf("flag");
  if (!IsCamelCase(name))
  {
    faults.Add(parameter.line,
               NameOf(parameter) + ": <name> must be camelCase: letters and digits, a small letter first");
  }
  if (parameter.Find("longflag") && longflag != name)
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <longflag> \"" + longflag + "\" differs from <name>");
  }
  if (ReservedNames.count(name))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": the name is reserved");
  }
  if (parameter.Find("flag") && (flag.size() != 1 || !std::isalpha(static_cast<unsigned char>(flag[0])) || flag == "h"))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <flag> \"" + flag + "\" must be one letter other than h");
  }
  if (parameter.Find("flag") && !parameter.Find("longflag"))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": a <flag> needs a <longflag>");
  }
}

void
CheckChannel(const XMLElement & parameter, XMLFaults & faults)
{
  const std::string channel = parameter.TextOf("channel");
  if (parameter.Find("channel") && channel != "input" && channel != "output")
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <channel> is \"" + channel + "\", not one of input, output");
  }
  const bool isData = NodeKinds.count(parameter.name) || parameter.name == "file" || parameter.name == "directory";
  if (isData && !parameter.Find("channel"))
  {
    faults.Add(parameter.line, NameOf(parameter) + " lacks <channel>");
  }
  if (parameter.Find("longflag") || parameter.Find("flag") || parameter.Find("index"))
  {
    return;
  }
  if (channel != "output" || !IsSimple(parameter.name))
  {
    faults.Add(parameter.line,
               NameOf(parameter) + " needs a <longflag> or an <index>; only a return value, a simple " +
                 "type with the channel output, has neither");
  }
}

void
CheckIndex(const XMLElement & parameter, XMLFaults & faults)
{
  if (!parameter.Find("index"))
  {
    return;
  }
  if (parameter.Find("flag") || parameter.Find("longflag"))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <index> excludes <flag> and <longflag>");
  }
  if (parameter.name == "point" || parameter.name == "region" || parameter.name == "boolean")
  {
    faults.Add(parameter.line, NameOf(parameter) + " cannot be positional");
  }
  if (ToNumber(parameter.TextOf("index"), "integer").value_or(-1) < 0)
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <index> must be a non-negative integer");
  }
}

void
CheckConstraints(const XMLElement & parameter, XMLFaults & faults)
{
  const XMLElement * constraints = parameter.Find("constraints");
  if (!constraints)
  {
    return;
  }
  if (!IsNumeric(parameter.name) || IsEnumeration(parameter.name))
  {
    faults.Add(constraints->line, NameOf(parameter) + " cannot have <constraints>");
    return;
  }
  faults.CheckAttributes(*constraints, {});
  faults.CheckChildren(*constraints, ConstraintElements, {});
  for (const XMLElement & limit : constraints->children)
  {
    if (!ToNumber(limit.text, parameter.name))
    {
      faults.Add(limit.line,
                 NameOf(parameter) + ": <" + limit.name + "> \"" + limit.text + "\" is not a number of the type");
    }
  }
  const auto minimum = LimitOf(parameter, "minimum");
  const auto maximum = LimitOf(parameter, "maximum");
  if (minimum && maximum && *minimum > *maximum)
  {
    faults.Add(constraints->line, NameOf(parameter) + ": <minimum> is greater than <maximum>");
  }
  if (constraints->Find("step") && LimitOf(parameter, "step").value_or(1) <= 0)
  {
    faults.Add(constraints->line, NameOf(parameter) + ": <step> must be greater than 0");
  }
}

void
CheckElements(const XMLElement & parameter, XMLFaults & faults)
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
      faults.Add(child.line, NameOf(parameter) + ": <element> \"" + child.text + "\" appears twice");
    }
    if (IsNumeric(parameter.name) && !ToNumber(child.text, parameter.name))
    {
      faults.Add(child.line, NameOf(parameter) + ": <element> \"" + child.text + "\" is not a number of the type");
    }
  }
  if (IsEnumeration(parameter.name) != (count > 0))
  {
    faults.Add(parameter.line,
               NameOf(parameter) + (count ? " is not an enumeration but has <element>" : " lacks <element>"));
  }
  const std::string value = parameter.TextOf("default");
  if (count && parameter.Find("default") && !values.count(value))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <default> \"" + value + "\" is not one of its elements");
  }
}

void
CheckDefaultNumber(const XMLElement & parameter, const std::string & text, XMLFaults & faults)
{
  const auto value = ToNumber(text, parameter.name);
  if (!value)
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <default> \"" + text + "\" is not a number of the type");
    return;
  }
  const auto minimum = LimitOf(parameter, "minimum");
  const auto maximum = LimitOf(parameter, "maximum");
  if ((minimum && *value < *minimum) || (maximum && *value > *maximum))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": <default> " + text + " is outside its constraints");
  }
}

void
CheckDefault(const XMLElement & parameter, XMLFaults & faults)
{
  const bool        isGiven = !parameter.TextOf("default").empty();
  const std::string value = parameter.TextOf("default");
  if (parameter.name == "boolean" && isGiven && value != "false")
  {
    faults.Add(parameter.line, NameOf(parameter) + ": the <default> of a boolean must be false");
  }
  if (isGiven && NodeKinds.count(parameter.name))
  {
    faults.Add(parameter.line,
               NameOf(parameter) + " cannot have a <default>: Slicer would use it as the name of a node");
  }
  if (isGiven && parameter.Find("index"))
  {
    faults.Add(parameter.line, NameOf(parameter) + ": a positional argument is required and cannot have a <default>");
  }
  // Slicer always passes a scalar option, with an empty value if it has no default.
  const bool isAlwaysPassed = (IsNumeric(parameter.name) && !IsVector(parameter.name)) || IsEnumeration(parameter.name);
  if (!isGiven && isAlwaysPassed && parameter.Find("longflag"))
  {
    faults.Add(parameter.line, NameOf(parameter) + " lacks <default>");
  }
  if (isGiven && IsNumeric(parameter.name) && !IsEnumeration(parameter.name))
  {
    for (const std::string & part : IsVector(parameter.name) ? Split(value) : std::vector<std::string>{ value })
    {
      CheckDefaultNumber(parameter, part, faults);
    }
  }
}

void
CheckFileExtensions(const XMLElement & parameter, XMLFaults & faults)
{
  for (const std::string & extension : Split(parameter.Attribute("fileExtensions")))
  {
    if (extension.size() < 2 || extension[0] != '.')
    {
      faults.Add(parameter.line, NameOf(parameter) + ": file extension \"" + extension + "\" must begin with a period");
    }
  }
}
} // namespace

std::optional<double>
LimitOf(const XMLElement & parameter, const std::string & limit)
{
  const XMLElement * constraints = parameter.Find("constraints");
  return constraints ? ToNumber(constraints->TextOf(limit), parameter.name) : std::nullopt;
}

void
CheckParameter(const XMLElement & parameter, XMLFaults & faults)
{
  faults.CheckAttributes(parameter, ParameterKinds().at(parameter.name));
  faults.CheckChildren(parameter, ParameterElements, { "element", "reference" });
  faults.RequireText(parameter, "label");
  faults.RequireSentence(parameter);
  CheckNames(parameter, faults);
  CheckChannel(parameter, faults);
  CheckIndex(parameter, faults);
  CheckConstraints(parameter, faults);
  CheckElements(parameter, faults);
  CheckDefault(parameter, faults);
  CheckFileExtensions(parameter, faults);
}
} // namespace rules
