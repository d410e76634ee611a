#ifndef shapetonTextScanner_h
#define shapetonTextScanner_h

#include <cstdint>
#include <string>
#include <string_view>

namespace shapeton
{
/** Reads words and numbers of a text, and reports error locations. Keeps references to both strings. */
class TextScanner
{
public:
  /** `comment` starts a comment until the end of the line; 0 for none. Reading starts at `begin`, which is on line
   * `line`. `continuation` at the end of a line, outside a comment, continues it on the next line; 0 for none. */
  TextScanner(const std::string & text,
              const std::string & path,
              char                comment = 0,
              std::size_t         begin = 0,
              int                 line = 1,
              char                continuation = 0);

  /** Advances to the next line that contains a word; false at the end of the text. */
  bool
  NextLine();
  /** The next word of this line; empty at its end. */
  std::string_view
  WordOfLine();
  /** The next word on this or a later line; empty at the end of the text. */
  std::string_view
  Word();

  /** The next word of this line, or with `onLaterLines` of the text, as a number in the range of a double, including
   * "nan" and "inf". `what` is used in messages. */
  double
  Number(const char * what, bool onLaterLines = false);
  std::int64_t
  Integer(const char * what, bool onLaterLines = false);

  /** Throws InputError with the line number. */
  [[noreturn]] void
  Refuse(const std::string & fault) const;

  int
  LineNumber() const
  {
    return m_Line;
  }

private:
  std::size_t
  EndOfContinuation(std::size_t place) const;
  std::string_view
  WordFor(const char * what, bool onLaterLines);

  const std::string & m_Text;
  const std::string & m_Path;
  char                m_Comment;
  char                m_Continuation;
  std::size_t         m_Place;
  int                 m_Line;
};
} // namespace shapeton

#endif
