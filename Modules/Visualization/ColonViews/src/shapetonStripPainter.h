#ifndef shapetonStripPainter_h
#define shapetonStripPainter_h

#include "shapetonFlatColonAxis.h"
#include "shapetonFlatLight.h"
#include "shapetonParallelFor.h"
#include "shapetonPicture.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** Red, green, blue; linear light, 0 to 1 and above. */
using LinearColor = Eigen::Vector3f;

/** Gray level of pixels without a face. */
constexpr unsigned char uncoveredGray = 96;

/** The curve of sRGB, by IEC 61966-2-1: a line up to `endOfLine` (coded) or `endOfLinearLine`, then a power. */
struct SrgbCurve
{
  static constexpr float endOfLine = 0.04045F;
  static constexpr float endOfLinearLine = 0.0031308F;
  static constexpr float slope = 12.92F;
  static constexpr float offset = 0.055F;
  static constexpr float scale = 1.055F;
  static constexpr float exponent = 2.4F;
};

inline LinearColor
ToLinear(const RGBColor & color)
{
  LinearColor linear;
  for (int k = 0; k < 3; ++k)
  {
    const float value = color[k] / 255.0F;
    linear[k] = value <= SrgbCurve::endOfLine
                  ? value / SrgbCurve::slope
                  : std::pow((value + SrgbCurve::offset) / SrgbCurve::scale, SrgbCurve::exponent);
  }
  return linear;
}

inline RGBColor
FromLinear(const LinearColor & linear)
{
  RGBColor color;
  for (int k = 0; k < 3; ++k)
  {
    const float value = std::clamp(linear[k], 0.0F, 1.0F);
    const float coded = value <= SrgbCurve::endOfLinearLine
                          ? SrgbCurve::slope * value
                          : SrgbCurve::scale * std::pow(value, 1.0F / SrgbCurve::exponent) - SrgbCurve::offset;
    color[k] = static_cast<unsigned char>(std::lround(255.0F * coded));
  }
  return color;
}

inline FlatAxes
AxesOf(const FlatColonFrame & frame)
{
  FlatAxes axes;
  Eigen::Map<Eigen::Vector3d>(axes.right) = frame.right;
  Eigen::Map<Eigen::Vector3d>(axes.down) = frame.down;
  Eigen::Map<Eigen::Vector3d>(axes.towards) = frame.towards;
  return axes;
}

inline FlatLight
LightOn(const FlatSample & sample, const FlatColonFrame & frame)
{
  return FlatLight::On(sample.inwardNormal.data(), AxesOf(frame));
}

/** A gray strip. */
inline Picture::Pointer
NewStrip(const FlatColonGrid & grid)
{
  return NewPicture(grid.Columns(), grid.Rows(), MakeColor(uncoveredGray, uncoveredGray, uncoveredGray));
}

/** A strip whose pixels are colorOf(sample, column); gray where there is no face. */
template <typename TColorOf>
Picture::Pointer
PaintStrip(const FlatColonGrid & grid, const TColorOf & colorOf)
{
  constexpr int    bandColumns = 32;
  const auto       picture = NewStrip(grid);
  RGBColor * const pixels = picture->GetBufferPointer();
  ParallelFor((grid.Columns() + bandColumns - 1) / bandColumns, [&](std::size_t band) {
    const int first = static_cast<int>(band) * bandColumns;
    const int last = std::min(grid.Columns(), first + bandColumns);
    for (int row = 0; row < grid.Rows(); ++row)
    {
      for (int column = first; column < last; ++column)
      {
        const FlatSample sample = grid.SampleOfPixel(column, row);
        if (sample.face >= 0)
        {
          pixels[static_cast<std::size_t>(row) * grid.Columns() + column] = colorOf(sample, column);
        }
      }
    }
  });
  return picture;
}
} // namespace shapeton

#endif
