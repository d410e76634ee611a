#include "shapetonJson.h"
#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
std::string
PlaceInText(const std::string & text, std::size_t byte)
{
  const std::size_t position = std::min(byte, text.size() + 1) - std::min<std::size_t>(byte, 1);
  const auto        lines = std::count(text.begin(), text.begin() + position, '\n');
  const auto        lineEnd = position == 0 ? std::string::npos : text.rfind('\n', position - 1);
  const std::size_t column = lineEnd == std::string::npos ? position + 1 : position - lineEnd;
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column);
}

void
WriteJson(const Json & document, const std::string & path)
{
  WriteFileBytes(path, document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

Json
RoundedJson(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return nullptr;
  }
  const double scale = value == 0.0 ? 1.0 : std::pow(10.0, digits - 1.0 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

Json
ReadJson(const std::string & path)
{
  const std::string text = ReadFileBytes(path);
  try
  {
    return Json::parse(text);
  }
  catch (const Json::parse_error & error)
  {
    throw InputError("\"" + path + "\" is not valid JSON at " + PlaceInText(text, error.byte) +
                     "; correct the file there");
  }
  catch (const Json::out_of_range &) // e.g. 1e999
  {
    throw InputError("\"" + path + "\" contains a number that is too large; correct the file");
  }
}

Json
ProvenanceToJson(const Provenance & provenance)
{
  Json document = Json::object();
  for (const auto & [name, value] : provenance)
  {
    document[name] = value;
  }
  return document;
}
} // namespace shapeton
