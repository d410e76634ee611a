#include "shapetonBase64Text.h"

#include <array>

namespace shapeton
{
namespace
{
constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/** The six bits of each character; -1 for characters outside the alphabet. */
std::array<int, 256>
BitsOfCharacters()
{
  std::array<int, 256> bits;
  bits.fill(-1);
  for (int i = 0; i < 64; ++i)
  {
    bits[static_cast<unsigned char>(alphabet[i])] = i;
  }
  return bits;
}
} // namespace

std::string
Base64(const std::string & bytes)
{
  std::string text;
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

std::optional<std::string>
BytesOfBase64(const std::string & text)
{
  static const std::array<int, 256> bitsOf = BitsOfCharacters();
  const std::size_t                 last = text.find_last_not_of('=');
  const std::size_t                 characters = last == std::string::npos ? 0 : last + 1;
  if (text.size() % 4 != 0 || text.size() - characters > 2)
  {
    return {};
  }
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  unsigned bits = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const int six = i < characters ? bitsOf[static_cast<unsigned char>(text[i])] : 0;
    if (six < 0)
    {
      return {};
    }
    bits = bits << 6 | static_cast<unsigned>(six);
    if (i % 4 == 3)
    {
      bytes +=
        { static_cast<char>(bits >> 16 & 255), static_cast<char>(bits >> 8 & 255), static_cast<char>(bits & 255) };
    }
  }
  bytes.resize(bytes.size() - (text.size() - characters));
  return bytes;
}

bool
IsPng(const std::string & bytes)
{
  static const std::string signature = "\x89PNG\r\n\x1A\n";
  return bytes.compare(0, signature.size(), signature) == 0;
}
} // namespace shapeton
