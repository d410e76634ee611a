#include "shapetonDotTokens.h"

#include <algorithm>
#include <cctype>

namespace shapeton
{
namespace
{
bool
IsLetter(char c)
{
  const auto byte = static_cast<unsigned char>(c);
  return std::isalpha(byte) != 0 || byte == '_' || byte >= 0x80;
}

bool
IsDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/** Length of [-]?(.[0-9]+ | [0-9]+(.[0-9]*)?), or 0 if the text does not start with a number. */
std::size_t
LengthOfNumber(std::string_view text)
{
  std::size_t i = !text.empty() && text[0] == '-' ? 1 : 0;
  std::size_t digits = 0;
  bool        hasPoint = false;
  for (; i < text.size() && (IsDigit(text[i]) || (text[i] == '.' && !hasPoint)); ++i)
  {
    digits += IsDigit(text[i]) ? 1 : 0;
    hasPoint = hasPoint || text[i] == '.';
  }
  return digits > 0 ? i : 0;
}

std::size_t
LengthOfName(std::string_view text)
{
  const auto isPart = [](char c) { return IsLetter(c) || IsDigit(c); };
  return IsLetter(text[0]) ? std::find_if_not(text.begin(), text.end(), isPart) - text.begin() : LengthOfNumber(text);
}
} // namespace

void
DotTokens::Skip(std::size_t length)
{
  const std::string_view skipped = m_Rest.substr(0, length);
  const std::size_t      end = skipped.rfind('\n');
  m_Line += static_cast<int>(std::count(skipped.begin(), skipped.end(), '\n'));
  m_IsLineStart = (m_IsLineStart || end != std::string_view::npos) && // npos + 1 is 0
                  skipped.find_first_not_of(" \t\r\v\f", end + 1) == std::string_view::npos;
  m_Rest.remove_prefix(skipped.size());
}

void
DotTokens::SkipBlanks()
{
  while (!m_Rest.empty())
  {
    if (std::isspace(static_cast<unsigned char>(m_Rest[0])) != 0)
    {
      this->Skip(1);
    }
    else if (m_Rest.substr(0, 2) == "//" || (m_IsLineStart && m_Rest[0] == '#'))
    {
      this->Skip(std::min(m_Rest.find('\n'), m_Rest.size()));
    }
    else if (m_Rest.substr(0, 2) == "/*")
    {
      const std::size_t end = m_Rest.find("*/", 2);
      m_Text.Require(end != std::string_view::npos, m_Line, "a comment is not closed");
      this->Skip(end + 2);
    }
    else
    {
      return;
    }
  }
}

DotToken
DotTokens::Next()
{
  this->SkipBlanks();
  if (m_Rest.empty())
  {
    return { DotToken::Kind::End, "the end of the file", m_Line, false };
  }
  if (m_Rest[0] == '"')
  {
    return this->QuotedText();
  }
  return m_Rest[0] == '<' ? this->Html() : this->Plain();
}

DotToken
DotTokens::Plain()
{
  const std::string_view pair = m_Rest.substr(0, 2);
  const std::size_t      name = LengthOfName(m_Rest);
  const bool             isPair = pair == "--" || pair == "->";
  const bool             isSymbol = isPair || std::string_view("{}[];,=:").find(m_Rest[0]) != std::string_view::npos;
  if (!(isSymbol || name > 0))
  {
    m_Text.Refuse(m_Line, "the character " + Quoted(m_Rest.substr(0, 1)) + " is unexpected");
  }
  const std::size_t length = isPair ? 2 : isSymbol ? 1 : name;
  DotToken          token{
    isSymbol ? DotToken::Kind::Symbol : DotToken::Kind::Name, std::string(m_Rest.substr(0, length)), m_Line, false
  };
  this->Skip(length);
  return token;
}

/** A quoted string, with others concatenated by a plus sign. */
DotToken
DotTokens::QuotedText()
{
  DotToken token{ DotToken::Kind::Name, {}, m_Line, true };
  for (bool goesOn = true; goesOn;)
  {
    std::size_t end = 1;
    for (; end < m_Rest.size() && m_Rest[end] != '"'; ++end)
    {
      const std::string_view pair = m_Rest.substr(end, 2);
      if (pair == "\\\"")
      {
        token.text += '"';
        ++end;
      }
      else if (pair == "\\\\") // kept, and does not escape a following quote
      {
        token.text += pair;
        ++end;
      }
      else if (pair == "\\\n" || m_Rest.substr(end, 3) == "\\\r\n") // a continued line
      {
        end += pair == "\\\n" ? 1 : 2;
      }
      else
      {
        token.text += m_Rest[end];
      }
    }
    m_Text.Require(end < m_Rest.size(), token.line, "a quoted string is not closed");
    this->Skip(end + 1);
    this->SkipBlanks();
    goesOn = !m_Rest.empty() && m_Rest[0] == '+';
    if (goesOn)
    {
      this->Skip(1);
      this->SkipBlanks();
      m_Text.Require(!m_Rest.empty() && m_Rest[0] == '"', m_Line, "a quoted string is expected after the plus sign");
    }
  }
  return token;
}

DotToken
DotTokens::Html()
{
  int         depth = 0;
  std::size_t end = 0;
  do
  {
    m_Text.Require(end < m_Rest.size(), m_Line, "an HTML string is not closed");
    depth += m_Rest[end] == '<' ? 1 : m_Rest[end] == '>' ? -1 : 0;
    ++end;
  } while (depth > 0);
  DotToken token{ DotToken::Kind::Name, std::string(m_Rest.substr(0, end)), m_Line, true };
  this->Skip(end);
  return token;
}
} // namespace shapeton
