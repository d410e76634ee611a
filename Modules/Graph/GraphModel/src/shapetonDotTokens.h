#ifndef shapetonDotTokens_h
#define shapetonDotTokens_h

#include "shapetonGraphText.h"

namespace shapeton
{
/** A token of the DOT language. */
struct DotToken
{
  enum class Kind
  {
    End,
    Name,   // an identifier, number, quoted string or HTML string
    Symbol, // { } [ ] ; , = : -- ->
  };
  Kind        kind{ Kind::End };
  std::string text;
  int         line{ 0 };
  /** Whether a name is quoted; keywords are not. */
  bool isQuoted{ false };

  bool
  Is(std::string_view symbol) const
  {
    return kind == Kind::Symbol && text == symbol;
  }
  bool
  IsKeyword(std::string_view word) const
  {
    return kind == Kind::Name && !isQuoted && EqualWithoutCase(text, word);
  }
  bool
  IsName() const
  {
    return kind == Kind::Name;
  }
};

/** Tokenizer of a DOT file. Skips comments: C++ and C comments, and lines that start with # (preprocessor output). */
class DotTokens
{
public:
  explicit DotTokens(const GraphText & text) : m_Text(text), m_Rest(text.bytes) {}

  DotToken
  Next();

private:
  DotToken
  Plain();
  DotToken
  QuotedText();
  DotToken
  Html();
  void
  Skip(std::size_t length);
  void
  SkipBlanks();

  const GraphText & m_Text;
  std::string_view  m_Rest;
  int               m_Line{ 1 };
  bool              m_IsLineStart{ true }; ///< only blanks before it in its line
};
} // namespace shapeton

#endif
