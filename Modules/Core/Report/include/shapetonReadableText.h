#ifndef shapetonReadableText_h
#define shapetonReadableText_h

#include "ReportExport.h"

#include <optional>
#include <string>

namespace shapeton
{
/** A number as CsvTable writes it, in plain decimal notation: "2.322e+04" becomes "23220". Beyond 15 places left or
 * 6 right of the decimal point it keeps a power of ten, in superscript. Any other text stays. \ingroup Report */
Report_EXPORT std::string
              PlainNumber(const std::string & number);

/** A number that is followed by nothing, or by a blank and a unit such as mm, ml or %.
 * \ingroup Report */
struct Quantity
{
  std::string number;
  std::string unit;
};

/** Empty for a text that is something else. Digits of the number may be grouped by blanks.
 * \ingroup Report */
Report_EXPORT std::optional<Quantity>
              QuantityOf(const std::string & text);

/** For people: the number in plain notation, its thousands separated by narrow spaces where no line breaks, then the
 * unit. \ingroup Report */
Report_EXPORT std::string
              ReadableQuantity(const Quantity & quantity);

/** A text for people: its numbers in plain notation, the thousands of those with a unit separated, mm^2 in superscript.
 * Names that hold digits stay as they are. \ingroup Report */
Report_EXPORT std::string
              ReadableText(const std::string & text);
} // namespace shapeton

#endif
