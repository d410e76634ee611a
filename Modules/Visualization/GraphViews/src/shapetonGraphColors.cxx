#include "shapetonGraphPictures.h"
#include "shapetonSvgPanel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
using Channels = std::array<double, 3>;

std::string
HexColor(const Channels & color)
{
  constexpr char digits[] = "0123456789abcdef";
  constexpr int  base = 16;
  std::string    text = "#";
  for (const double channel : color)
  {
    const int byte = static_cast<int>(std::lround(std::clamp(channel, 0.0, 255.0)));
    text += digits[byte / base];
    text += digits[byte % base];
  }
  return text;
}

Channels
Mixed(const Channels & a, const Channels & b, double share)
{
  Channels mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i)
  {
    mixed[i] = a[i] + share * (b[i] - a[i]);
  }
  return mixed;
}

} // namespace

const std::vector<std::string> &
TrackColors()
{
  // As published: orange, light blue, pink; then yellow, violet, brown.
  static const std::vector<std::string> colors{ "#e69f00", "#56b4e9", "#cc79a7", "#f0e442", "#7b3fa0", "#8d6e63" };
  return colors;
}

std::vector<std::string>
DistinctColors(int count)
{
  constexpr double         golden = 0.61803398874989485; // golden ratio: consecutive hues differ strongly
  constexpr Channels       shifts{ 5.0, 3.0, 1.0 };      // of red, green and blue; a turn is 6
  std::vector<std::string> colors;
  constexpr double         brightness = 0.95;
  constexpr double         chroma = 0.55;
  for (int i = 0; i < count; ++i)
  {
    const double hue = 6.0 * std::fmod(i * golden, 1.0);
    Channels     color{};
    std::transform(shifts.begin(), shifts.end(), color.begin(), [hue](double shift) {
      const double k = std::fmod(shift + hue, 6.0);
      return 255.0 * (brightness - chroma * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
    });
    colors.push_back(HexColor(color));
  }
  return colors;
}

std::string
DivergingColor(double value, double lightness)
{
  constexpr Channels negative{ 213.0, 94.0, 0.0 };
  constexpr Channels zero{ 176.0, 176.0, 176.0 }; // still visible as a line on white
  constexpr Channels positive{ 0.0, 114.0, 178.0 };
  constexpr Channels white{ 255.0, 255.0, 255.0 };
  const double       share = std::min(std::abs(value), 1.0);
  return HexColor(Mixed(Mixed(zero, value < 0.0 ? negative : positive, share), white, lightness));
}

std::string
ColorBarMarkup(const GraphColorBar & bar, int left, int top)
{
  constexpr double width = 290.0, height = 46.0, margin = 8.0;
  constexpr double titleLine = 13.0, barTop = 18.0, barHeight = 10.0, numberLine = 41.0;
  constexpr int    steps = 32, fontSize = 11;
  const double     length = width - 2.0 * margin;
  std::string text = "<g class=\"colorBar\" transform=\"translate(" + std::to_string(left) + ' ' + std::to_string(top) +
                     ")\">\n<rect width=\"" + SvgNumber(width) + "\" height=\"" + SvgNumber(height) +
                     "\" fill=\"#ffffff\" opacity=\"0.9\"/>\n";
  for (int i = 0; i < steps; ++i)
  {
    const double middle = (2.0 * i + 1.0) / steps - 1.0;
    text += "<rect x=\"" + SvgNumber(margin + length * i / steps) + "\" y=\"" + SvgNumber(barTop) + "\" width=\"" +
            SvgNumber(length / steps + 0.5) + "\" height=\"" + SvgNumber(barHeight) + "\" fill=\"" +
            DivergingColor(middle) + "\"/>\n";
  }
  return text + SvgLabel(margin, titleLine, "start", fontSize, bar.title) +
         SvgLabel(margin, numberLine, "start", fontSize, SvgNumber(-bar.most)) +
         SvgLabel(width / 2.0, numberLine, "middle", fontSize, "0") +
         SvgLabel(width - margin, numberLine, "end", fontSize, SvgNumber(bar.most)) + "</g>\n";
}
} // namespace shapeton
