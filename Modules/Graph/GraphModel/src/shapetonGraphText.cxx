#include "shapetonGraphText.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace shapeton
{
void
GraphText::Refuse(int line, const std::string & fault, const std::string & advice) const
{
  const std::string place = line > 0 ? ", line " + std::to_string(line) : "";
  throw InputError('"' + path + '"' + place + ": " + fault + "; " + advice);
}

void
GraphText::Require(bool condition, int line, std::string_view fault, std::string_view advice) const
{
  if (!condition)
  {
    this->Refuse(line, std::string(fault), std::string(advice));
  }
}

bool
LineReader::Next(std::string_view & line)
{
  if (m_Text.empty())
  {
    return false;
  }
  const std::size_t end = std::min(m_Text.find('\n'), m_Text.size());
  line = m_Text.substr(0, end);
  m_Text.remove_prefix(std::min(end + 1, m_Text.size()));
  if (!line.empty() && line.back() == '\r')
  {
    line.remove_suffix(1);
  }
  ++m_Number;
  return true;
}

std::vector<std::string_view>
Words(std::string_view line, std::string_view separators)
{
  const auto isBetween = [&](char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || separators.find(c) != std::string_view::npos;
  };
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < line.size();)
  {
    if (isBetween(line[i]))
    {
      ++i;
      continue;
    }
    const std::size_t start = i;
    while (i < line.size() && !isBetween(line[i]))
    {
      ++i;
    }
    words.push_back(line.substr(start, i - start));
  }
  return words;
}

bool
ParseInt(std::string_view word, int & value)
{
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return !word.empty() && result.ec == std::errc() && result.ptr == word.data() + word.size();
}

bool
ParseDouble(std::string_view word, double & value)
{
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return !word.empty() && result.ec == std::errc() && result.ptr == word.data() + word.size();
}

std::string
Quoted(std::string_view text)
{
  constexpr std::size_t most = 40;
  std::string           quoted = "\"";
  for (const char c : text.substr(0, most))
  {
    quoted += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return quoted + (text.size() > most ? "...\"" : "\"");
}

bool
EqualWithoutCase(std::string_view first, std::string_view second)
{
  return std::equal(first.begin(), first.end(), second.begin(), second.end(), [](unsigned char a, unsigned char b) {
    return std::tolower(a) == std::tolower(b);
  });
}
} // namespace shapeton
