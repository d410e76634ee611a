#ifndef shapetonNumberText_h
#define shapetonNumberText_h

#include <charconv>
#include <locale>
#include <sstream>
#include <string>

namespace shapeton
{
/** Formats a number for messages and listings with the given number of significant digits and a decimal point in any
 * locale.
 * \ingroup ShapetonCommon */
inline std::string
NumberText(double value, int digits = 6)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  return text.str();
}

/** The number that NumberText() writes. \ingroup ShapetonCommon */
inline double
RoundedNumber(double value, int digits)
{
  const std::string text = NumberText(value, digits);
  double            rounded = value;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}
} // namespace shapeton

#endif
