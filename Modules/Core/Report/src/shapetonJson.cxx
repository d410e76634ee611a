#include "shapetonJson.h"
#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace shapeton
{
namespace
{
/** Parses a document; programs disagree on which of two entries with the same key counts, so a repeated key is refused.
 */
Json
ParseWithUniqueKeys(const std::string & text, const std::string & path)
{
  std::vector<std::set<std::string>> keys; // of the open objects
  return Json::parse(text, [&](int, Json::parse_event_t event, Json & value) {
    if (event == Json::parse_event_t::object_start)
    {
      keys.emplace_back();
    }
    else if (event == Json::parse_event_t::object_end)
    {
      keys.pop_back();
    }
    else if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
    {
      throw InputError("\"" + path + "\": the entry \"" + value.get<std::string>() +
                       "\" is repeated; remove one of the two");
    }
    return true;
  });
}
} // namespace

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
    return ParseWithUniqueKeys(text, path);
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
