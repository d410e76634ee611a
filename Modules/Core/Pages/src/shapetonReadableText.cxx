#include "shapetonReadableText.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace shapeton
{
namespace
{
constexpr const char * const narrowSpace = "\u202F"; // non-breaking
constexpr int                mostPlacesLeft = 15;    // decimal places; numbers with more have an exponent
constexpr int                mostPlacesRight = 6;    // decimal places; numbers with more have an exponent

bool
IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/** The parts of -12.5e+03. */
struct Decimal
{
  std::string sign;
  std::string whole;
  std::string fraction;
  int         exponent{ 0 };
};

std::string
TakeDigits(const std::string & text, std::size_t & at)
{
  const std::size_t begin = at;
  while (at < text.size() && IsDigit(text[at]))
  {
    ++at;
  }
  return text.substr(begin, at - begin);
}

/** 3 for "e+03"; 0 without consuming text for exponents that CsvTable does not write, such as the beginning of a
 * hash. */
int
TakeExponent(const std::string & text, std::size_t & at)
{
  constexpr std::size_t mostDigits = 3; // maximum exponent digits of a double
  if (at + 1 >= text.size() || text[at] != 'e' || (text[at + 1] != '-' && text[at + 1] != '+'))
  {
    return 0;
  }
  std::size_t       end = at + 2;
  const std::string digits = TakeDigits(text, end);
  if (digits.empty() || digits.size() > mostDigits)
  {
    return 0;
  }
  const bool isNegative = text[at + 1] == '-';
  at = end;
  return (isNegative ? -1 : 1) * std::stoi(digits);
}

/** Parses a number at a position and advances the position past it. Leading zeros indicate a name. */
std::optional<Decimal>
TakeDecimal(const std::string & text, std::size_t & at)
{
  Decimal     decimal;
  std::size_t end = at;
  if (end < text.size() && text[end] == '-')
  {
    decimal.sign = text[end++];
  }
  decimal.whole = TakeDigits(text, end);
  if (decimal.whole.empty() || (decimal.whole.size() > 1 && decimal.whole[0] == '0'))
  {
    return std::nullopt;
  }
  if (end + 1 < text.size() && text[end] == '.' && IsDigit(text[end + 1]))
  {
    ++end;
    decimal.fraction = TakeDigits(text, end);
  }
  decimal.exponent = TakeExponent(text, end);
  at = end;
  return decimal;
}

std::string
TextOf(const Decimal & decimal)
{
  return decimal.sign + decimal.whole + (decimal.fraction.empty() ? "" : "." + decimal.fraction);
}

std::string
Superscript(int number)
{
  static const std::array<const char *, 10> digits{ "\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079" };
  std::string                               text;
  for (const char c : std::to_string(number))
  {
    text += c == '-' ? "\u207B" : digits[c - '0'];
  }
  return text;
}

/** Shifts the decimal point by the exponent, digit by digit, to avoid rounding. */
Decimal
Expanded(Decimal decimal)
{
  for (; decimal.exponent > 0; --decimal.exponent)
  {
    decimal.whole += decimal.fraction.empty() ? '0' : decimal.fraction.front();
    decimal.fraction.erase(0, 1);
  }
  for (; decimal.exponent < 0; ++decimal.exponent)
  {
    decimal.fraction.insert(0, 1, decimal.whole.back());
    decimal.whole.pop_back();
    decimal.whole = decimal.whole.empty() ? "0" : decimal.whole;
  }
  decimal.whole.erase(0, std::min(decimal.whole.find_first_not_of('0'), decimal.whole.size() - 1));
  return decimal;
}

std::string
PlainText(const Decimal & decimal, bool isGrouped)
{
  if (decimal.exponent > mostPlacesLeft || -decimal.exponent > mostPlacesRight)
  {
    return TextOf(decimal) + " \u00D7 10" + Superscript(decimal.exponent);
  }
  Decimal    plain = Expanded(decimal);
  const auto digits = static_cast<int>(plain.whole.size());
  for (int place = isGrouped ? digits - 3 : 0; place > 0; place -= 3)
  {
    plain.whole.insert(place, narrowSpace);
  }
  return TextOf(plain);
}

/** Parses the name of a unit at a position; longer names with the same prefix come first. */
std::string
UnitAt(const std::string & text, std::size_t at)
{
  static const char * const units[] = { "mm^3", "mm^2", "mm", "cm^3", "cm^2",   "cm",     "ml",    "m",
                                        "%",    "HU",   "s",  "h",    "voxels", "visits", "faces", "steps" };
  for (const std::string unit : units)
  {
    const std::size_t end = at + unit.size();
    const bool        isWhole = end >= text.size() || !std::isalnum(static_cast<unsigned char>(text[end]));
    if (isWhole && text.compare(at, unit.size(), unit) == 0 && (end >= text.size() || text[end] != '^'))
    {
      return unit;
    }
  }
  return "";
}

/** Whether a number that is not part of a name may start after this position. */
bool
IsBegin(const std::string & text, std::size_t at)
{
  return at == 0 || std::string(" \t\n([=").find(text[at - 1]) != std::string::npos;
}

/** Whether a number ends here: punctuation must be followed by a blank or the end. */
bool
IsEnd(const std::string & text, std::size_t at)
{
  const std::size_t behind = std::min(text.find_first_not_of(",;:.)]", at), text.size());
  return behind == text.size() || std::string(" \t\n").find(text[behind]) != std::string::npos;
}

std::string
WithSuperscripts(std::string text)
{
  for (const auto & [plain, readable] : { std::pair("m^2", "m\u00B2"), std::pair("m^3", "m\u00B3") })
  {
    for (std::size_t at = text.find(plain); at != std::string::npos; at = text.find(plain, at))
    {
      text.replace(at, 3, readable);
    }
  }
  return text;
}

/** Removes the blanks that separate thousands, as in 246 908. */
std::string
WithoutGroups(const std::string & text)
{
  const auto isDigitAt = [&](std::size_t place) { return place < text.size() && IsDigit(text[place]); };
  const auto isSeparator = [&](std::size_t at) {
    return text[at] == ' ' && at > 0 && isDigitAt(at - 1) && isDigitAt(at + 1) && isDigitAt(at + 2) &&
           isDigitAt(at + 3) && !isDigitAt(at + 4);
  };
  std::string ungrouped;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    if (!isSeparator(at))
    {
      ungrouped += text[at];
    }
  }
  return ungrouped;
}
} // namespace

std::string
PlainNumber(const std::string & number)
{
  std::size_t at = 0;
  const auto  decimal = TakeDecimal(number, at);
  return decimal && at == number.size() ? PlainText(*decimal, false) : number;
}

std::optional<Quantity>
QuantityOf(const std::string & text)
{
  const std::string ungrouped = WithoutGroups(text);
  std::size_t       at = 0;
  if (!TakeDecimal(ungrouped, at))
  {
    return std::nullopt;
  }
  Quantity quantity{ ungrouped.substr(0, at), "" };
  if (at == ungrouped.size())
  {
    return quantity;
  }
  quantity.unit = UnitAt(ungrouped, at + 1);
  const bool isAll = ungrouped[at] == ' ' && at + 1 + quantity.unit.size() == ungrouped.size();
  return isAll && !quantity.unit.empty() ? std::optional<Quantity>(quantity) : std::nullopt;
}

std::string
ReadableQuantity(const Quantity & quantity)
{
  std::size_t at = 0;
  const auto  decimal = TakeDecimal(quantity.number, at);
  return (decimal ? PlainText(*decimal, true) : quantity.number) +
         (quantity.unit.empty() ? "" : " " + WithSuperscripts(quantity.unit));
}

std::string
ReadableText(const std::string & text)
{
  std::string readable;
  for (std::size_t at = 0; at < text.size();)
  {
    std::size_t end = at;
    const auto  decimal = IsBegin(text, at) ? TakeDecimal(text, end) : std::nullopt;
    if (!decimal || !IsEnd(text, end))
    {
      readable += text[at++];
      continue;
    }
    const bool hasUnit = end < text.size() && text[end] == ' ' && !UnitAt(text, end + 1).empty();
    readable += PlainText(*decimal, hasUnit);
    at = end;
  }
  return WithSuperscripts(readable);
}
} // namespace shapeton
