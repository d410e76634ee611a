#ifndef shapetonStripPainter_h
#define shapetonStripPainter_h

#include "shapetonFlatColonAxis.h"
#include "shapetonParallelFor.h"
#include "shapetonPicture.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** Red, green, blue; linear light, 0 to 1 and above. */
using LinearColor = Eigen::Vector3f;

/** Where no face lies. */
constexpr unsigned char uncoveredGrey = 96;

/** sRGB, by IEC 61966-2-1. */
inline LinearColor
ToLinear(const RGBColor & color)
{
  LinearColor linear;
  for (int k = 0; k < 3; ++k)
  {
    const float value = color[k] / 255.0F;
    linear[k] = value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
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
    const float coded = value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F;
    color[k] = static_cast<unsigned char>(std::lround(255.0F * coded));
  }
  return color;
}

/** The light on a piece of wall with this normal: how bright its own colour is, and white that is added. */
struct FlatLight
{
  FlatLight(const FlatColonFrame & frame, const Eigen::Vector3d & inwardNormal)
  {
    const Eigen::Vector3d normal(
      inwardNormal.dot(frame.right), inwardNormal.dot(frame.down), inwardNormal.dot(frame.towards));
    // To the light: from the left and a little from above; halfway between that and the eye.
    static const Eigen::Vector3d toLight = Eigen::Vector3d(-0.62, -0.22, 0.75).normalized();
    static const Eigen::Vector3d halfway = (toLight + Eigen::Vector3d::UnitZ()).normalized();
    constexpr double             ambient = 0.10;
    constexpr double             diffuse = 0.80;
    constexpr double             fromEye = 0.12;
    constexpr double             wrap = 0.7; // light reaches around the edge, so that sides in shadow keep their shape
    constexpr float              specular = 0.10F;
    const double                 towardsLight = std::max(0.0, (normal.dot(toLight) + wrap) / (1.0 + wrap));
    const auto                   towardsHalfway = static_cast<float>(std::max(0.0, normal.dot(halfway)));
    brightness = static_cast<float>(ambient + diffuse * towardsLight + fromEye * std::max(0.0, normal.z()));
    highlight = specular * std::pow(towardsHalfway, 24.0F);
  }

  float brightness;
  float highlight;
};

/** A strip whose pixels are colorOf(sample, column); grey where no face lies. */
template <typename TColorOf>
Picture::Pointer
PaintStrip(const FlatColonGrid & grid, const TColorOf & colorOf)
{
  constexpr int bandColumns = 32;
  const auto picture = NewPicture(grid.Columns(), grid.Rows(), MakeColor(uncoveredGrey, uncoveredGrey, uncoveredGrey));
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
