#ifndef shapetonReadableText_h
#define shapetonReadableText_h

#include "ShapetonPagesExport.h"

#include <optional>
#include <string>

namespace shapeton
{
/** A number as written by CsvTable, in plain decimal notation: "2.322e+04" becomes "23220". With more than 15 digits
 * left or 6 digits right of the decimal point, a power of ten is kept, in superscript. Any other text is unchanged.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT std::string
                     PlainNumber(const std::string & number);

/** A number, optionally followed by a blank and a unit such as mm, ml or %.
 * \ingroup ShapetonPages */
struct Quantity
{
  std::string number;
  std::string unit;
};

/** Parses a quantity; empty for any other text. Digits of the number may be grouped by blanks.
 * \ingroup ShapetonPages */
ShapetonPages_EXPORT std::optional<Quantity>
                     QuantityOf(const std::string & text);

/** A quantity for display: the number in plain notation, its thousands separated by narrow no-break spaces, then the
 * unit. \ingroup ShapetonPages */
ShapetonPages_EXPORT std::string
                     ReadableQuantity(const Quantity & quantity);

/** Text for display: numbers in plain notation, thousands separated for those with a unit, mm^2 in superscript.
 * Names that contain digits are unchanged. \ingroup ShapetonPages */
ShapetonPages_EXPORT std::string
                     ReadableText(const std::string & text);
} // namespace shapeton

#endif
