#include "shapetonDepthShading.h"

namespace shapeton
{
namespace
{
/** Sums of 2 reach + 1 values around each of `number` values spaced by `stride`. */
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

/** Two box filters along each axis: a tent filter. */
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

DepthShading::DepthShading(const std::vector<SeenSample> & samples,
                           unsigned int                    width,
                           unsigned int                    height,
                           double                          millimetersPerPixel,
                           double                          strength)
  : m_Strength(static_cast<float>(strength))
{
  const int reach = std::max(static_cast<int>(std::max(width, height)) / 60, 2);
  m_DarkDepth = static_cast<float>(2.0 * reach * millimetersPerPixel); // equal to the size of the neighborhood
  if (strength <= 0.0)
  {
    return;
  }
  std::vector<double> depths(std::size_t{ width } * height, 0.0);
  std::vector<double> weights(depths.size(), 0.0);
  const std::size_t   columns = std::size_t{ width } * samplesAlongPixel;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (std::isfinite(samples[i].depth))
    {
      const std::size_t pixel = i / columns / samplesAlongPixel * width + i % columns / samplesAlongPixel;
      depths[pixel] += samples[i].depth;
      weights[pixel] += 1.0;
    }
  }
  Blur(depths, static_cast<int>(width), static_cast<int>(height), reach);
  Blur(weights, static_cast<int>(width), static_cast<int>(height), reach);
  m_MeanDepth.resize(depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    m_MeanDepth[i] = weights[i] > 0.5 ? static_cast<float>(depths[i] / weights[i]) : 0.0F;
  }
}
} // namespace shapeton
