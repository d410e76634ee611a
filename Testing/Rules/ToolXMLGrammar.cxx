#include "ToolXMLGrammar.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

namespace rules
{
namespace
{
const Names CoordinateSystems{ "ijk", "lps", "ras" };

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool
IsIdentifier(const std::string & text)
{
  const auto isWord = [](unsigned char c) { return c == '_' || (c < 128 && std::isalnum(c)); };
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), isWord);
}
} // namespace

const Names Booleans{ "false", "true" };

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
IsCamelCase(const std::string & text)
{
  return IsIdentifier(text) && std::islower(static_cast<unsigned char>(text[0])) && text.find('_') == std::string::npos;
}

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
} // namespace rules
