#include "shapetonPrintable.h"

#include <algorithm>

namespace shapeton
{
namespace
{
unsigned char
ByteAt(const std::string & text, std::size_t position)
{
  return position < text.size() ? static_cast<unsigned char>(text[position]) : 0;
}

// The number of bytes of the character at `position`; 0 if it is malformed (RFC 3629, section 4).
std::size_t
LengthOfCharacter(const std::string & text, std::size_t position)
{
  const unsigned char first = ByteAt(text, position);
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t length = first >= 0xC2 && first < 0xE0 ? 2 : first >= 0xE0 && first < 0xF0 ? 3 : 4;
  if (first < 0xC2 || first > 0xF4)
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((ByteAt(text, position + i) & 0xC0) != 0x80)
    {
      return 0;
    }
  }
  const unsigned char second = ByteAt(text, position + 1);
  const bool          isOverlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool          isNoScalar = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return isOverlong || isNoScalar ? 0 : length;
}

// The C1 controls U+0080 to U+009F control terminals like the C0 controls.
bool
IsBlank(const std::string & text, std::size_t position)
{
  const unsigned char byte = ByteAt(text, position);
  return byte <= 0x20 || byte == 0x7F || (byte == 0xC2 && ByteAt(text, position + 1) < 0xA0);
}

// XML excludes U+FFFE and U+FFFF.
bool
IsNoCharacter(const std::string & text, std::size_t position)
{
  return text.compare(position, 3, "\xEF\xBF\xBE") == 0 || text.compare(position, 3, "\xEF\xBF\xBF") == 0;
}
} // namespace

std::string
Printable(const std::string & text)
{
  std::string printable;
  bool        isBlankDue = false;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t length = LengthOfCharacter(text, i);
    if (length > 0 && IsBlank(text, i))
    {
      isBlankDue = !printable.empty();
      i += length;
      continue;
    }
    printable += isBlankDue ? " " : "";
    isBlankDue = false;
    printable += length == 0 || IsNoCharacter(text, i) ? "?" : text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return printable;
}

std::string
Quoted(const std::string & text)
{
  constexpr std::size_t limit = 100;
  return '"' + (text.size() <= limit ? text : text.substr(0, limit) + "...") + '"';
}

std::string
Trimmed(const std::string & text)
{
  const std::string blanks(" \0\t\r\n", 5);
  const auto        first = text.find_first_not_of(blanks);
  const auto        last = text.find_last_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

std::string
LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::string
WithoutTrailingSlashes(std::string path)
{
  while (path.size() > 1 && path.back() == '/')
  {
    path.pop_back();
  }
  return path;
}
} // namespace shapeton
