#include "shapetonModuleHelp.h"
#include "shapetonPrintable.h"

#include <algorithm>

namespace shapeton
{
namespace
{
using Parameter = ModuleDescription::Parameter;

std::string
Line(std::string left, const std::string & text)
{
  constexpr std::size_t column = 40;
  left.resize(std::max(left.size() + 2, column), ' ');
  return "  " + left + text + '\n';
}

std::string
LeftSideOf(const Parameter & parameter)
{
  if (parameter.IsPositional())
  {
    return parameter.name + (parameter.multiple ? "..." : "");
  }
  std::string left = parameter.flag.empty() ? "" : '-' + parameter.flag;
  if (!parameter.longflag.empty())
  {
    left += (left.empty() ? "--" : ", --") + parameter.longflag;
  }
  return parameter.tag == "boolean" ? left : left + " <" + parameter.tag + '>';
}

std::string
RangeOf(const Parameter & parameter)
{
  if (parameter.minimum.empty() && parameter.maximum.empty())
  {
    return "";
  }
  if (parameter.maximum.empty())
  {
    return " (at least " + parameter.minimum + ')';
  }
  return parameter.minimum.empty() ? " (at most " + parameter.maximum + ')'
                                   : " (" + parameter.minimum + " to " + parameter.maximum + ')';
}

std::string
ChoicesOf(const Parameter & parameter)
{
  std::string choices;
  for (const auto & element : parameter.elements)
  {
    choices += (choices.empty() ? " (" : " | ") + element;
  }
  return choices.empty() ? "" : choices + ')';
}

std::string
DescriptionOf(const Parameter & parameter)
{
  const bool hasDefault = !parameter.defaultValue.empty() && parameter.tag != "boolean";
  return Printable(parameter.description) + ChoicesOf(parameter) + RangeOf(parameter) +
         (hasDefault ? " [" + parameter.defaultValue + ']' : "");
}

std::string
UsageOf(const ModuleDescription & module, const std::string & program)
{
  std::string usage = "Usage: " + program;
  for (const auto * parameter : module.Positionals())
  {
    usage += " <" + parameter->name + '>' + (parameter->multiple ? "..." : "");
  }
  return usage + " [options]\n";
}
} // namespace

std::string
HelpText(const ModuleDescription & module, const std::string & program)
{
  std::string text = module.title + ' ' + module.version + '\n' + Printable(module.description) + "\n\n" +
                     UsageOf(module, program) + '\n';
  for (const auto * parameter : module.Positionals())
  {
    text += Line(LeftSideOf(*parameter), DescriptionOf(*parameter));
  }
  for (const auto & parameter : module.parameters)
  {
    const bool isOption = !parameter.longflag.empty() || !parameter.flag.empty(); // else a return value
    if (isOption)
    {
      text += Line(LeftSideOf(parameter), DescriptionOf(parameter));
    }
  }
  text += Line("--quiet", "Print no progress.");
  text += Line("--returnparameterfile <file>", "Write the return values as lines name = value.");
  text += Line("--xml", "Print the description of the tool for 3D Slicer.");
  text += Line("--version", "Print the version.");
  text += Line("-h, --help", "Print this text.");
  text += "\nExit status: 0 done, 2 wrong usage, 3 unsuitable input, 1 any other failure.\n";
  return module.documentationUrl.empty() ? text : text + "Documentation: " + module.documentationUrl + '\n';
}
} // namespace shapeton
