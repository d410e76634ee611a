#include "shapetonTextScanner.h"
#include "shapetonSurfaceFormats.h"

#include <algorithm>
#include <charconv>

namespace shapeton
{
namespace
{
constexpr std::size_t LongestQuotation = 40; // characters in a message; chosen

bool
IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
} // namespace

TextScanner::TextScanner(const std::string & text,
                         const std::string & path,
                         char                comment,
                         std::size_t         begin,
                         int                 line,
                         char                continuation)
  : m_Text(text), m_Path(path), m_Comment(comment), m_Continuation(continuation), m_Place(begin), m_Line(line)
{}

/** Start of the next line if a line is continued at `place`, else 0. */
std::size_t
TextScanner::EndOfContinuation(std::size_t place) const
{
  if (!m_Continuation || m_Text[place] != m_Continuation)
  {
    return 0;
  }
  std::size_t end = place + 1;
  while (end < m_Text.size() && IsBlank(m_Text[end])) // also the CR of CR LF
  {
    ++end;
  }
  const bool isAtEnd = end == m_Text.size();
  return isAtEnd || m_Text[end] == '\n' ? end + (isAtEnd ? 0 : 1) : 0;
}

std::string_view
TextScanner::WordOfLine()
{
  while (m_Place < m_Text.size())
  {
    const std::size_t end = this->EndOfContinuation(m_Place);
    if (end == 0 && !IsBlank(m_Text[m_Place]))
    {
      break;
    }
    m_Line += end > 0 ? 1 : 0;
    m_Place = end > 0 ? end : m_Place + 1;
  }
  if (m_Comment && m_Place < m_Text.size() && m_Text[m_Place] == m_Comment)
  {
    m_Place = std::min(m_Text.find('\n', m_Place), m_Text.size());
  }
  const std::size_t begin = m_Place;
  while (m_Place < m_Text.size() && !IsBlank(m_Text[m_Place]) && m_Text[m_Place] != '\n' &&
         this->EndOfContinuation(m_Place) == 0)
  {
    ++m_Place;
  }
  return std::string_view(m_Text).substr(begin, m_Place - begin);
}

bool
TextScanner::NextLine()
{
  for (;;)
  {
    while (m_Continuation && !this->WordOfLine().empty()) // the logical line may end several lines below
    {}
    m_Place = std::min(m_Text.find('\n', m_Place), m_Text.size());
    if (m_Place == m_Text.size())
    {
      return false;
    }
    ++m_Place;
    ++m_Line;
    const std::size_t begin = m_Place;
    const int         line = m_Line;
    if (!this->WordOfLine().empty())
    {
      m_Place = begin;
      m_Line = line;
      return true;
    }
  }
}

std::string_view
TextScanner::Word()
{
  std::string_view word = this->WordOfLine();
  while (word.empty() && this->NextLine())
  {
    word = this->WordOfLine();
  }
  return word;
}

std::string_view
TextScanner::WordFor(const char * what, bool onLaterLines)
{
  std::string_view word = onLaterLines ? this->Word() : this->WordOfLine();
  if (word.empty())
  {
    this->Refuse(std::string(m_Place == m_Text.size() ? "the file ends" : "the line ends") + " where " + what +
                 " should be");
  }
  if (word[0] == '+')
  {
    word.remove_prefix(1);
  }
  return word;
}

double
TextScanner::Number(const char * what, bool onLaterLines)
{
  const std::string_view word = this->WordFor(what, onLaterLines);
  double                 value = 0.0;
  const auto             result = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool             isTiny = result.ec == std::errc::result_out_of_range && // underflow to 0; others are too large
                      (word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos);
  if ((result.ec != std::errc() && !isTiny) || result.ptr != word.data() + word.size())
  {
    this->Refuse("\"" + std::string(word.substr(0, LongestQuotation)) + "\" is not a number for " + what);
  }
  return value;
}

std::int64_t
TextScanner::Integer(const char * what, bool onLaterLines)
{
  const std::string_view word = this->WordFor(what, onLaterLines);
  std::int64_t           value = 0;
  const auto             result = std::from_chars(word.data(), word.data() + word.size(), value);
  if (result.ec != std::errc() || result.ptr != word.data() + word.size())
  {
    this->Refuse("\"" + std::string(word.substr(0, LongestQuotation)) + "\" is not an integer for " + what);
  }
  return value;
}

void
TextScanner::Refuse(const std::string & fault) const
{
  RefuseSurface(m_Path, "line " + std::to_string(m_Line) + ": " + fault, "correct the file there");
}
} // namespace shapeton
