#ifndef shapetonBase64_h
#define shapetonBase64_h

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

namespace shapeton
{
/** Decodes base64 from `place` until `wanted` bytes are decoded or a non-base64 character is found; advances `place` to
 * it. */
inline std::string
DecodeBase64(const std::string & text,
             std::size_t &       place,
             std::size_t         wanted = std::numeric_limits<std::size_t>::max())
{
  static constexpr signed char              none = -1;
  static const std::array<signed char, 256> values = [] {
    std::array<signed char, 256> table;
    table.fill(none);
    signed char value = 0;
    for (const char c : "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
    {
      table[static_cast<unsigned char>(c)] = value++;
    }
    table[0] = none; // end of the alphabet
    return table;
  }();
  std::string   bytes;
  std::uint32_t bits = 0;
  int           number = 0;
  bytes.reserve(std::min(wanted, text.size() - std::min(place, text.size())));
  for (; place < text.size() && bytes.size() < wanted; ++place)
  {
    const signed char value = values[static_cast<unsigned char>(text[place])];
    if (value == none)
    {
      break;
    }
    bits = (bits << 6 | static_cast<std::uint32_t>(value)) & 0xFFFFFF;
    number += 6;
    if (number >= 8)
    {
      number -= 8;
      bytes += static_cast<char>(bits >> number & 0xFF);
    }
  }
  return bytes;
}
} // namespace shapeton

#endif
