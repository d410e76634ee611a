#ifndef shapetonGraphText_h
#define shapetonGraphText_h

#include <string>
#include <string_view>
#include <vector>

namespace shapeton
{
/** A graph file as text: the bytes, and errors with the file name. */
struct GraphText
{
  std::string path;
  std::string bytes;

  /** Throws InputError: "PATH", line N: fault; advice. Line 0 refers to the whole file. */
  [[noreturn]] void
  Refuse(int line, const std::string & fault, const std::string & advice = "correct the file there") const;

  void
  Require(bool condition, int line, std::string_view fault, std::string_view advice = "correct the file there") const;
};

/** Iterates over lines of text, without line ends (LF or CR LF). */
class LineReader
{
public:
  explicit LineReader(std::string_view text) : m_Text(text) {}

  bool
  Next(std::string_view & line);

  /** Number of the line returned by Next, from 1. */
  int
  Number() const
  {
    return m_Number;
  }

private:
  std::string_view m_Text;
  int              m_Number{ 0 };
};

/** Splits a line at blanks, tabs and characters of `separators`. */
std::vector<std::string_view>
Words(std::string_view line, std::string_view separators = {});

/** Parses `word` as a decimal integer of type int; returns false unless the whole word is one. */
bool
ParseInt(std::string_view word, int & value);

/** Parses `word` as a decimal floating-point number; returns false unless the whole word is one. */
bool
ParseDouble(std::string_view word, double & value);

/** Formats file content for a message: quoted, printable, shortened. */
std::string
Quoted(std::string_view text);

bool
EqualWithoutCase(std::string_view first, std::string_view second);
} // namespace shapeton

#endif
