#ifndef itkNumberText_h
#define itkNumberText_h

#include <locale>
#include <sstream>
#include <string>

namespace itk
{
/** A number as messages and listings show it: so many significant digits, a decimal point in any locale.
 * \ingroup Base */
inline std::string
NumberText(double value, int digits = 6)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(digits);
  text << value;
  return text.str();
}
} // namespace itk

#endif
