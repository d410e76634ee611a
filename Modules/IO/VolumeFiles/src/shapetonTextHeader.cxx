#include "shapetonTextHeader.h"

#include "shapetonPrintable.h"

#include <algorithm>
#include <fstream>
#include <functional>

namespace shapeton
{
namespace
{
// Longer than any real text header.
constexpr std::size_t LongestTextHeader = 1u << 20;

TextHeader
ReadTextHeader(const std::string & path, const std::function<bool(const std::string &)> & isLast)
{
  std::ifstream stream(path, std::ios::binary);
  std::string   text(LongestTextHeader, '\0');
  stream.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  TextHeader  header;
  std::size_t start = 0;
  while (start < text.size() && !header.isComplete)
  {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    header.lines.push_back(Trimmed(text.substr(start, end - start)));
    header.isComplete = isLast(header.lines.back());
    start = end + 1;
  }
  header.bytes = std::min(start, text.size());
  return header;
}

std::vector<std::string>::const_iterator
FindLine(const std::vector<std::string> & lines, const std::string & key, char separator)
{
  return std::find_if(lines.begin(), lines.end(), [&](const std::string & line) {
    const auto position = line.find(separator);
    return position != std::string::npos && LowerCase(Trimmed(line.substr(0, position))) == key;
  });
}
} // namespace

std::string
TextHeader::ValueOf(const std::string & key, char separator) const
{
  const auto line = FindLine(lines, key, separator);
  return line == lines.end() ? std::string() : Trimmed(line->substr(line->find(separator) + 1));
}

std::vector<std::string>
TextHeader::LinesAfter(const std::string & key, char separator) const
{
  const auto line = FindLine(lines, key, separator);
  if (line == lines.end())
  {
    return {};
  }
  return { line + 1, std::find(line + 1, lines.end(), "") };
}

TextHeader
ReadNrrdHeader(const std::string & path)
{
  return ReadTextHeader(path, [](const std::string & line) { return line.empty(); });
}

TextHeader
ReadMetaHeader(const std::string & path)
{
  return ReadTextHeader(path, [](const std::string & line) {
    const TextHeader header{ { line } };
    const auto       file = LowerCase(header.ValueOf("elementdatafile", '='));
    return !file.empty() && file.compare(0, 4, "list") != 0;
  });
}
} // namespace shapeton
