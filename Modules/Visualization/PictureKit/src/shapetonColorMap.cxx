#include "shapetonColorMap.h"

#include <algorithm>
#include <array>

namespace shapeton
{
namespace
{
// Points at equal CIELAB distances along a smooth path through blue (58, 85, 216), cyan, green, yellow and red.
constexpr std::array<std::array<unsigned char, 3>, 33> heatColors{
  { { 58, 85, 216 },  { 57, 100, 221 }, { 54, 115, 227 }, { 50, 129, 231 }, { 47, 141, 232 }, { 45, 152, 231 },
    { 43, 163, 228 }, { 40, 172, 224 }, { 36, 181, 218 }, { 34, 188, 211 }, { 34, 195, 202 }, { 32, 199, 191 },
    { 32, 202, 178 }, { 40, 205, 163 }, { 56, 207, 148 }, { 73, 210, 132 }, { 88, 212, 115 }, { 103, 214, 98 },
    { 119, 215, 80 }, { 142, 217, 66 }, { 168, 219, 61 }, { 191, 219, 60 }, { 211, 217, 58 }, { 226, 210, 54 },
    { 238, 201, 51 }, { 246, 190, 48 }, { 251, 176, 46 }, { 251, 160, 45 }, { 248, 143, 44 }, { 244, 125, 44 },
    { 237, 105, 44 }, { 229, 85, 44 },  { 221, 61, 44 } }
};

// Found by search from the colors of Okabe and Ito, whose yellow and orange are only 17 apart for deutan vision.
constexpr std::array<unsigned int, 12> classColors{ 0x05bffa, 0xffeb07, 0x1538ff, 0x973f2c, 0x73ffcf, 0x0e7dfa,
                                                    0xdc760a, 0x974f79, 0xc2f78a, 0x7c3f9d, 0x0eb479, 0x11d4d6 };

struct NamedColor
{
  const char * name;
  unsigned int rgb;
};

// The CSS colors of these names.
constexpr NamedColor namedColors[] = { { "black", 0x000000 },   { "blue", 0x0000ff },      { "brown", 0xa52a2a },
                                       { "cyan", 0x00ffff },    { "gold", 0xffd700 },      { "gray", 0x808080 },
                                       { "green", 0x008000 },   { "ivory", 0xfffff0 },     { "lime", 0x00ff00 },
                                       { "magenta", 0xff00ff }, { "navy", 0x000080 },      { "olive", 0x808000 },
                                       { "orange", 0xffa500 },  { "pink", 0xffc0cb },      { "purple", 0x800080 },
                                       { "red", 0xff0000 },     { "salmon", 0xfa8072 },    { "silver", 0xc0c0c0 },
                                       { "skyblue", 0x87ceeb }, { "steelblue", 0x4682b4 }, { "tan", 0xd2b48c },
                                       { "teal", 0x008080 },    { "tomato", 0xff6347 },    { "violet", 0xee82ee },
                                       { "white", 0xffffff },   { "yellow", 0xffff00 } };

RGBColor
FromBits(unsigned int rgb)
{
  return MakeColor(static_cast<unsigned char>(rgb >> 16),
                   static_cast<unsigned char>((rgb >> 8) & 255U),
                   static_cast<unsigned char>(rgb & 255U));
}

RGBColor
HeatColorAt(std::size_t index)
{
  return MakeColor(heatColors[index][0], heatColors[index][1], heatColors[index][2]);
}

char
LowerCase(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
} // namespace

RGBColor
HeatColor(double position)
{
  const double      place = (position > 0.0 ? std::min(position, 1.0) : 0.0) * (heatColors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), heatColors.size() - 2);
  return MixColors(HeatColorAt(below), HeatColorAt(below + 1), place - static_cast<double>(below));
}

RGBColor
ClassColor(unsigned int label)
{
  return FromBits(classColors[(label - 1) % classColors.size()]);
}

std::optional<RGBColor>
ColorOf(const std::string & text)
{
  constexpr std::size_t length = 7; // #rrggbb
  std::string           name(text);
  std::transform(name.begin(), name.end(), name.begin(), LowerCase);
  if (name.size() == length && name[0] == '#' && name.find_first_not_of("0123456789abcdef", 1) == std::string::npos)
  {
    return FromBits(static_cast<unsigned int>(std::stoul(name.substr(1), nullptr, 16)));
  }
  const auto * const found =
    std::find_if(std::begin(namedColors), std::end(namedColors), [&](const NamedColor & c) { return name == c.name; });
  return found == std::end(namedColors) ? std::nullopt : std::optional<RGBColor>(FromBits(found->rgb));
}

std::string
ColorNames()
{
  std::string names;
  for (const NamedColor & color : namedColors)
  {
    names += (names.empty() ? "" : ", ") + std::string(color.name);
  }
  return names;
}

std::string
HexOf(const RGBColor & color)
{
  constexpr char digits[] = "0123456789abcdef";
  std::string    text = "#";
  for (unsigned int channel = 0; channel < 3; ++channel)
  {
    text += digits[color[channel] >> 4];
    text += digits[color[channel] & 15];
  }
  return text;
}
} // namespace shapeton
