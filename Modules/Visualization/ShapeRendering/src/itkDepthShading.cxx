#include "itkDepthShading.h"

#include <algorithm>

namespace itk
{
namespace
{
/** The sums of 2 reach + 1 values around each of `number` values that lie `stride` apart. */
void
SumAround(const std::vector<double> & from,
          std::vector<double> &       to,
          std::size_t                 first,
          std::size_t                 stride,
          int                         number,
          int                         reach)
{
  double sum = 0.0;
  for (int i = -reach; i < number; ++i)
  {
    if (i + reach < number)
    {
      sum += from[first + static_cast<std::size_t>(i + reach) * stride];
    }
    if (i - reach - 1 >= 0)
    {
      sum -= from[first + static_cast<std::size_t>(i - reach - 1) * stride];
    }
    if (i >= 0)
    {
      to[first + static_cast<std::size_t>(i) * stride] = sum;
    }
  }
}

/** Two box sums along each axis: a tent. */
void
Blur(std::vector<double> & values, int width, int height, int reach)
{
  std::vector<double> other(values.size());
  for (int pass = 0; pass < 2; ++pass)
  {
    for (int y = 0; y < height; ++y)
    {
      SumAround(values, other, static_cast<std::size_t>(y) * width, 1, width, reach);
    }
    for (int x = 0; x < width; ++x)
    {
      SumAround(other, values, x, width, height, reach);
    }
  }
}
} // namespace

void
ShadeByDepth(std::vector<SeenPixel> & pixels,
             unsigned int             width,
             unsigned int             height,
             double                   millimetresPerPixel,
             double                   strength)
{
  const int           reach = std::max(static_cast<int>(std::max(width, height)) / 60, 2);
  std::vector<double> depths(pixels.size());
  std::vector<double> weights(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    weights[i] = pixels[i].solid;
    depths[i] = static_cast<double>(pixels[i].solid) * pixels[i].depth;
  }
  Blur(depths, static_cast<int>(width), static_cast<int>(height), reach);
  Blur(weights, static_cast<int>(width), static_cast<int>(height), reach);
  const double dark = 2.0 * reach * millimetresPerPixel; // as deep as the surroundings reach
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    if (pixels[i].solid > 0.0F)
    {
      const double behind = pixels[i].depth - depths[i] / weights[i];
      const double share = pixels[i].solid * strength * std::clamp(behind / dark, 0.0, 1.0);
      for (float & channel : pixels[i].color)
      {
        channel *= static_cast<float>(1.0 - share);
      }
    }
  }
}
} // namespace itk
