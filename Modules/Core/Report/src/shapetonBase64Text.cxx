#include "shapetonBase64Text.h"

namespace shapeton
{
std::string
Base64(const std::string & bytes)
{
  static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string       text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto byte = [&](std::size_t k) -> unsigned {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0;
    };
    const unsigned triple = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += alphabet[triple >> 18];
    text += alphabet[triple >> 12 & 63];
    text += i + 1 < bytes.size() ? alphabet[triple >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? alphabet[triple & 63] : '=';
  }
  return text;
}
} // namespace shapeton
