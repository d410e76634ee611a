#include "shapetonModuleHelp.h"
#include "shapetonOperatingSystem.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <sstream>

namespace shapeton
{
namespace
{
using Parameter = ModuleDescription::Parameter;

constexpr std::size_t TextColumn = 30; // of the descriptions of options

/** The text in lines of the given width; `column` is the current one, and lines after the first start at `indent`. */
std::string
Wrapped(const std::string & text, std::size_t column, std::size_t indent, std::size_t width)
{
  std::string        wrapped;
  std::istringstream words(text);
  bool               isFirst = true; // of its line
  for (std::string word; words >> word; isFirst = false)
  {
    if (!isFirst && column + 1 + word.size() > width)
    {
      wrapped += '\n' + std::string(indent, ' ');
      column = indent;
      isFirst = true;
    }
    wrapped += (isFirst ? "" : " ") + word;
    column += word.size() + (isFirst ? 0 : 1);
  }
  return wrapped + '\n';
}

std::string
Entry(const std::string & left, const std::string & text, std::size_t width)
{
  std::string start = "  " + left;
  if (start.size() + 2 > TextColumn)
  {
    start += '\n' + std::string(TextColumn, ' ');
  }
  else
  {
    start.resize(TextColumn, ' ');
  }
  return start + Wrapped(text, TextColumn, TextColumn, width);
}

/** What the value of a parameter is. */
std::string
KindOf(const Parameter & parameter)
{
  if (parameter.IsPoint())
  {
    return "x,y,z";
  }
  if (parameter.IsNumeric())
  {
    return (parameter.IsInteger() ? "integer" : "number") + std::string(parameter.IsVector() ? ",..." : "");
  }
  if (parameter.IsPath())
  {
    return parameter.tag == "image"        ? "volume"
           : parameter.tag == "geometry"   ? "surface"
           : parameter.tag == "directory"  ? "folder"
           : !parameter.extensions.empty() ? "file"
                                           : "path";
  }
  if (!parameter.elements.empty())
  {
    return "word";
  }
  return parameter.defaultValue == "auto" ? "number|auto" : "text";
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
  return parameter.tag == "boolean" ? left : left + " <" + KindOf(parameter) + '>';
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
  return usage + " [options]";
}

std::string
OptionsOf(const ModuleDescription & module, std::size_t width)
{
  std::string text, group;
  for (const auto & parameter : module.parameters)
  {
    if (parameter.longflag.empty() && parameter.flag.empty()) // a positional argument or a return value
    {
      continue;
    }
    text += parameter.group == group ? "" : '\n' + parameter.group + ":\n";
    group = parameter.group;
    text += Entry(LeftSideOf(parameter), DescriptionOf(parameter), width);
  }
  return text;
}
} // namespace

std::string
HelpText(const ModuleDescription & module, const std::string & program)
{
  constexpr std::size_t least = 60, most = 120, usual = 80; // columns
  const std::size_t     width = TerminalColumns() > 0 ? std::clamp(TerminalColumns(), least, most) : usual;
  const auto            entry = [width](const auto & left, const auto & text) { return Entry(left, text, width); };

  std::string text = module.title + ' ' + module.version + '\n' + Wrapped(Printable(module.description), 0, 0, width) +
                     '\n' + Wrapped(UsageOf(module, program), 0, std::string("Usage: ").size(), width) + '\n';
  for (const auto * parameter : module.Positionals())
  {
    text += entry(LeftSideOf(*parameter), DescriptionOf(*parameter));
  }
  text += OptionsOf(module, width) + "\nAll tools:\n";
  text += entry("--quiet", "Print no progress.");
  text += entry("--version", "Print the version.");
  text += entry("-h, --help", "Print this text.");
  text += entry("--xml", "Print the description of the tool for 3D Slicer.");
  text += entry("--echo", "Print the values of the parameters.");
  text += entry("--returnparameterfile <file>", "Write the return values as lines name = value.");
  text += entry("--processinformationaddress <address>", "Passed by module hosts; no effect in a separate process.");
  text += '\n' + Wrapped("Exit status: 0 done, 2 wrong usage, 3 unsuitable input, 1 any other failure.", 0, 0, width);
  return module.documentationUrl.empty() ? text : text + "Documentation: " + module.documentationUrl + '\n';
}
} // namespace shapeton
