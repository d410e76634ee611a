#include "shapetonDicomText.h"

#include "shapetonExceptions.h"
#include "shapetonPrintable.h"
#include "shapetonSha256.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace shapeton
{
std::string
DicomDecimal(double value)
{
  if (!std::isfinite(value))
  {
    throw InputError("a number that is not finite cannot be written as a DICOM Decimal String");
  }
  value = value == 0.0 ? 0.0 : value; // avoids "-0"
  for (int digits = 16; digits > 0; --digits)
  {
    constexpr std::size_t    enough = 40; // for 16 digits, sign, point and exponent
    std::array<char, enough> text{};
    const auto               end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    if (end - text.data() <= 16)
    {
      return std::string(text.data(), end);
    }
  }
  throw InputError("a number cannot be written as a DICOM Decimal String");
}

std::string
JoinDicomValues(const std::vector<std::string> & values)
{
  std::string joined;
  for (const auto & value : values)
  {
    joined += (joined.empty() ? "" : "\\") + value;
  }
  return joined;
}

std::vector<std::string>
SplitDicomValues(const std::string & text)
{
  std::vector<std::string> values;
  for (std::size_t start = 0; start <= text.size() && !text.empty();)
  {
    const std::size_t stop = std::min(text.find('\\', start), text.size());
    values.push_back(Trimmed(text.substr(start, stop - start)));
    start = stop + 1;
  }
  return values;
}

std::string
MakeDicomUID(const std::string & text)
{
  const std::string           digits = Sha256OfBytes(text);
  std::array<unsigned int, 4> words{}; // most significant first
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    words[i] = static_cast<unsigned int>(std::stoul(digits.substr(8 * i, 8), nullptr, 16));
  }
  words[1] = (words[1] & 0xFFFF0FFFU) | 0x00008000U; // version 8
  words[2] = (words[2] & 0x3FFFFFFFU) | 0x80000000U; // variant of RFC 9562
  std::string decimal;
  while (std::any_of(words.begin(), words.end(), [](unsigned int word) { return word != 0; }))
  {
    std::uint64_t remainder = 0;
    for (auto & word : words)
    {
      const std::uint64_t dividend = (remainder << 32) | word;
      word = static_cast<unsigned int>(dividend / 10);
      remainder = dividend % 10;
    }
    decimal.insert(decimal.begin(), static_cast<char>('0' + remainder));
  }
  return "2.25." + decimal;
}

std::string
ConcatenateTexts(const std::vector<std::string> & texts)
{
  std::string all;
  for (const auto & text : texts)
  {
    all += std::to_string(text.size()) + ':' + text;
  }
  return all;
}
} // namespace shapeton
