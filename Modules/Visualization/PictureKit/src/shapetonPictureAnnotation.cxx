#include "shapetonPictureAnnotation.h"

#include "shapetonAxisTicks.h"
#include "shapetonCsvTable.h"
#include "shapetonPatientOrientation.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** The largest 1, 2 or 5 times a power of ten that is at most `value`. */
double
RoundLengthUpTo(double value)
{
  constexpr double factors[] = { 5.0, 2.0 };
  double           length = 1.0;
  while (length > value)
  {
    length /= 10;
  }
  while (length * 10 <= value)
  {
    length *= 10;
  }
  for (const double factor : factors)
  {
    if (factor * length <= value)
    {
      return factor * length;
    }
  }
  return length;
}
} // namespace

void
DrawScaleBar(Picture *        picture,
             int              left,
             int              bottom,
             int              greatestLength,
             double           millimetersPerPixel,
             const RGBColor & color)
{
  constexpr int thickness = 3;
  constexpr int textSize = 15;
  const double  length = RoundLengthUpTo(greatestLength * millimetersPerPixel);
  const int     pixels = static_cast<int>(std::lround(length / millimetersPerPixel));
  TextStyle     style{ textSize, color, false, HorizontalAnchor::Left, VerticalAnchor::Bottom };
  FillRectangle(picture, left, bottom - thickness, pixels, thickness, color);
  DrawText(picture, CsvTable::Rounded(length, 6) + " mm", left, bottom - thickness - 2, style);
}

void
DrawOrientationLetters(Picture *                       picture,
                       const itk::Vector<double, 3> &  right,
                       const itk::Vector<double, 3> &  up,
                       const OrientationLettersStyle & letters)
{
  const int  width = static_cast<int>(picture->GetBufferedRegion().GetSize(0));
  const int  height = static_cast<int>(picture->GetBufferedRegion().GetSize(1));
  const int  margin = letters.margin;
  const auto draw =
    [&](const itk::Vector<double, 3> & direction, int x, int y, HorizontalAnchor horizontal, VerticalAnchor vertical) {
      TextStyle style{ letters.size, {}, true, horizontal, vertical };
      if (letters.hasShadow)
      {
        DrawText(picture, OrientationLetters(direction), x + 1, y + 1, style);
      }
      style.color = letters.color;
      DrawText(picture, OrientationLetters(direction), x, y, style);
    };
  draw(-right, margin, height / 2, HorizontalAnchor::Left, VerticalAnchor::Center);
  draw(right, width - margin, height / 2, HorizontalAnchor::Right, VerticalAnchor::Center);
  draw(up, width / 2, 3 * margin / 4, HorizontalAnchor::Center, VerticalAnchor::Top);
  draw(-up, width / 2, height - 3 * margin / 4, HorizontalAnchor::Center, VerticalAnchor::Bottom);
}

RGBColor
ColorScale::ColorOf(double value) const
{
  static const RGBColor gray = MakeColor(150, 150, 150);
  if (!std::isfinite(value))
  {
    return gray;
  }
  return map(upper > lower ? std::clamp((value - lower) / (upper - lower), 0.0, 1.0) : 0.0);
}

std::vector<RGBColor>
ColorsOf(const double * values, std::size_t number, const ColorScale & scale)
{
  std::vector<RGBColor> colors(number);
  std::transform(values, values + number, colors.begin(), [&](double value) { return scale.ColorOf(value); });
  return colors;
}

void
DrawColorBar(Picture * picture, int left, int top, int height, const ColorScale & scale, const RGBColor & color)
{
  constexpr int barWidth = 16;
  constexpr int leastDistance = 46;
  constexpr int textSize = 14;
  constexpr int lengthOfTick = 5;
  const double  range = std::max(scale.upper - scale.lower, 1e-300);
  for (int y = 0; y < height; ++y)
  {
    FillRectangle(picture, left, top + y, barWidth, 1, scale.map(1.0 - y / std::max(height - 1.0, 1.0)));
  }
  DrawRectangle(picture, left - 1, top - 1, barWidth + 2, height + 2, color);
  TextStyle    style{ textSize, color, false, HorizontalAnchor::Left, VerticalAnchor::Center };
  const double shown = scale.shownPerValue;
  for (const double value : RoundTicks(shown * scale.lower, shown * scale.upper, height / leastDistance))
  {
    const int y = top + static_cast<int>(std::lround((scale.upper - value / shown) / range * (height - 1.0)));
    FillRectangle(picture, left + barWidth, y, lengthOfTick, 1, color);
    DrawText(picture, CsvTable::Rounded(value, 6), left + barWidth + 9, y, style);
  }
  style = FitText(scale.title, style, height);
  style.upwards = true;
  style.horizontal = HorizontalAnchor::Right;
  DrawText(picture, scale.title, left + colorBarWidth - 10, top + height / 2, style);
}

int
DrawLegend(Picture *                        picture,
           const std::vector<LegendEntry> & legend,
           int                              left,
           int                              top,
           int                              bottom,
           const RGBColor &                 color)
{
  constexpr int lineHeight = 22;
  constexpr int swatch = 15;
  constexpr int textSize = 15;
  const int     room = std::max((bottom - top) / lineHeight, 1);
  const int     number = static_cast<int>(legend.size());
  const int     shown = number > room ? room - 1 : number;
  TextStyle     style{ textSize, color, false, HorizontalAnchor::Left, VerticalAnchor::Center };
  for (int i = 0; i < shown; ++i)
  {
    const int y = top + i * lineHeight;
    FillRectangle(picture, left, y, swatch, swatch, legend[i].color);
    DrawRectangle(picture, left, y, swatch, swatch, color);
    const int textLeft = left + swatch + 8;
    const int width = static_cast<int>(picture->GetBufferedRegion().GetSize(0)) - textLeft;
    DrawText(picture, legend[i].text, textLeft, y + swatch / 2, FitText(legend[i].text, style, width));
  }
  if (shown < number)
  {
    DrawText(
      picture, "and " + std::to_string(number - shown) + " more", left, top + shown * lineHeight + swatch / 2, style);
  }
  return std::min(number, room) * lineHeight;
}
} // namespace shapeton
