#ifndef shapetonBase64_h
#define shapetonBase64_h

#include <cstdint>
#include <limits>
#include <string>

namespace shapeton
{
/** Decodes base64 from `place` on to a character that is none of it, which `place` is set to, or until `wanted` bytes
 * are there. */
inline std::string
DecodeBase64(const std::string & text,
             std::size_t &       place,
             std::size_t         wanted = std::numeric_limits<std::size_t>::max())
{
  static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string              bytes;
  std::uint32_t            bits = 0;
  int                      number = 0;
  for (; place < text.size() && bytes.size() < wanted; ++place)
  {
    const std::size_t value = alphabet.find(text[place]);
    if (value == std::string::npos)
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
