#include "shapetonParameterValue.h"
#include "shapetonPrintable.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using Parameter = ModuleDescription::Parameter;

[[noreturn]] void
Refuse(const Parameter & parameter, const std::string & reason)
{
  throw ParameterError(parameter.Display() + ": " + reason);
}

std::string
Joined(const std::vector<std::string> & texts, const std::string & separator)
{
  std::string all;
  for (const auto & text : texts)
  {
    all += (all.empty() ? "" : separator) + text;
  }
  return all;
}

void
CheckEnumeration(const Parameter & parameter, const std::string & value)
{
  const auto & elements = parameter.elements;
  if (elements.empty() || std::find(elements.begin(), elements.end(), value) != elements.end())
  {
    return;
  }
  Refuse(parameter, Quoted(value) + " is not one of " + Joined(elements, ", "));
}

/** A file is written in the format that its parameter declares. Volumes have more formats, see RequireVolumeName(). */
void
CheckExtension(const Parameter & parameter, const std::string & path)
{
  const auto & extensions = parameter.extensions;
  const bool   isFree = parameter.channel != "output" || extensions.empty() ||
                      std::find(extensions.begin(), extensions.end(), ".nrrd") != extensions.end();
  const auto ends = [name = LowerCase(path)](const std::string & extension) {
    return name.size() > extension.size() &&
           name.compare(name.size() - extension.size(), extension.size(), extension) == 0;
  };
  if (!isFree && std::none_of(extensions.begin(), extensions.end(), ends))
  {
    Refuse(parameter, Quoted(path) + " does not end with " + Joined(extensions, " or "));
  }
}

void
CheckNumber(const Parameter & parameter, const std::string & text)
{
  const double value = ParseNumber(parameter, text);
  if (!parameter.minimum.empty() && value < ParseNumber(parameter, parameter.minimum))
  {
    Refuse(parameter, text + " is less than the minimum " + parameter.minimum);
  }
  if (!parameter.maximum.empty() && value > ParseNumber(parameter, parameter.maximum))
  {
    Refuse(parameter, text + " is more than the maximum " + parameter.maximum);
  }
}

std::vector<std::string>
NumbersOf(const Parameter & parameter, const std::string & value)
{
  return parameter.IsVector() ? SplitAtCommas(value) : std::vector<std::string>{ value };
}

std::string
CanonicalNumber(const Parameter & parameter, const std::string & text)
{
  const double value = ParseNumber(parameter, text) + 0.0; // -0 becomes 0
  if (parameter.IsInteger())
  {
    return std::to_string(static_cast<int>(value));
  }
  char       shortest[32];
  const auto end = std::to_chars(shortest, shortest + sizeof(shortest), value);
  return std::string(shortest, end.ptr);
}
} // namespace

std::vector<std::string>
SplitAtCommas(const std::string & text)
{
  std::vector<std::string> parts;
  for (std::size_t start = 0; !text.empty() && start <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

double
ParseNumber(const Parameter & parameter, const std::string & text)
{
  const bool         hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char * const end = text.data() + text.size();
  double             value = 0.0;
  const auto         result = std::from_chars(text.data() + (hasPlus ? 1 : 0), end, value);
  if (result.ec == std::errc::result_out_of_range)
  {
    Refuse(parameter, Quoted(text) + " is too large or too small for a number");
  }
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
  {
    Refuse(parameter, Quoted(text) + " is not a number");
  }
  if (parameter.IsInteger() && (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()))
  {
    Refuse(parameter, Quoted(text) + " is not a whole number below 2^31");
  }
  return value;
}

void
CheckValue(const Parameter & parameter, const std::string & value)
{
  if (value.empty() && (parameter.IsPath() || parameter.IsNumeric()))
  {
    Refuse(parameter, parameter.IsPath() ? "the name is empty" : "the value is empty; give a number");
  }
  CheckEnumeration(parameter, value);
  CheckExtension(parameter, value);
  if (!parameter.IsNumeric())
  {
    return;
  }
  const auto numbers = NumbersOf(parameter, value);
  if (parameter.IsPoint() && numbers.size() != 3)
  {
    Refuse(parameter, Quoted(value) + " is not a point; use three coordinates, LPS in mm, for example -12.5,40,310");
  }
  for (const auto & number : numbers)
  {
    CheckNumber(parameter, number);
  }
}

std::string
CanonicalValue(const Parameter & parameter, const std::string & value)
{
  if (!parameter.IsNumeric())
  {
    return value;
  }
  std::string canonical;
  for (const auto & number : NumbersOf(parameter, value))
  {
    canonical += (canonical.empty() ? "" : ",") + CanonicalNumber(parameter, number);
  }
  return canonical;
}
} // namespace shapeton
