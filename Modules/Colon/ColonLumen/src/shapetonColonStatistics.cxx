#include "shapetonColonStatistics.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Mean and standard deviation of a block of voxels. */
std::array<double, 2>
MomentsOfBlock(const ColonGrid & grid, const std::vector<float> & hu, const VoxelBox & box)
{
  double sum = 0.0;
  double squares = 0.0;
  int    count = 0;
  for (int k = box.low[2]; k < box.high[2]; ++k)
  {
    for (int j = box.low[1]; j < box.high[1]; ++j)
    {
      for (int i = box.low[0]; i < box.high[0]; ++i, ++count)
      {
        const double v = hu[grid.Index(i, j, k)];
        sum += v;
        squares += v * v;
      }
    }
  }
  const double mean = sum / count;
  return { { mean, std::sqrt(std::max(0.0, squares / count - mean * mean) * count / (count - 1.0)) } };
}

/** One line through the grid, convolved. */
void
SmoothLine(float *                     line,
           std::size_t                 stride,
           int                         length,
           const std::vector<double> & kernel,
           std::vector<float> &        buffer)
{
  const int radius = static_cast<int>(kernel.size()) - 1;
  buffer.resize(length + 2 * radius);
  for (int p = -radius; p < length + radius; ++p)
  {
    buffer[p + radius] = line[std::clamp(p, 0, length - 1) * stride];
  }
  for (int p = 0; p < length; ++p)
  {
    double sum = kernel[0] * buffer[p + radius];
    for (int r = 1; r <= radius; ++r)
    {
      sum += kernel[r] * (buffer[p + radius - r] + buffer[p + radius + r]);
    }
    line[p * stride] = static_cast<float>(sum);
  }
}

std::vector<double>
HalfKernel(double sigmaInVoxels)
{
  std::vector<double> kernel;
  double              sum = 0.0;
  for (int r = 0; r <= static_cast<int>(std::ceil(3.0 * sigmaInVoxels)); ++r)
  {
    kernel.push_back(std::exp(-0.5 * r * r / (sigmaInVoxels * sigmaInVoxels)));
    sum += (r == 0 ? 1.0 : 2.0) * kernel.back();
  }
  for (auto & weight : kernel)
  {
    weight /= sum;
  }
  return kernel;
}
} // namespace

double
ModeOfTissue(const std::vector<float> & hu)
{
  constexpr int       low = -60;
  constexpr int       bins = 220;
  std::vector<double> count(bins, 0.0);
  for (std::size_t p = 0; p < hu.size(); p += 3)
  {
    const int bin = static_cast<int>(std::floor(hu[p])) - low;
    if (bin >= 0 && bin < bins)
    {
      count[bin] += 1.0;
    }
  }
  int    best = -1;
  double most = 0.0;
  for (int b = 40; b < bins - 40; ++b)
  {
    double sum = 0.0;
    for (int d = -20; d <= 20; ++d)
    {
      sum += (21 - std::abs(d)) * count[b + d];
    }
    best = sum > most ? b : best;
    most = std::max(most, sum);
  }
  return best > 40 && best < bins - 41 ? best + low + 0.5 : 40.0;
}

double
NoiseInTissue(const ColonGrid & grid, const std::vector<float> & hu, double tissue)
{
  std::array<int, 3> edge;
  for (int a = 0; a < 3; ++a)
  {
    edge[a] = std::min(grid.size[a], std::max(2, static_cast<int>(std::lround(5.0 / grid.spacing[a]))));
  }
  std::vector<std::vector<double>> ofLayer(grid.size[2] / edge[2]);
  ParallelFor(ofLayer.size(), [&](std::size_t layer) {
    const int k = static_cast<int>(layer) * edge[2];
    for (int j = 0; j + edge[1] <= grid.size[1]; j += edge[1])
    {
      for (int i = 0; i + edge[0] <= grid.size[0]; i += edge[0])
      {
        const auto m = MomentsOfBlock(grid, hu, { { { i, j, k } }, { { i + edge[0], j + edge[1], k + edge[2] } } });
        if (std::abs(m[0] - tissue) < 60.0)
        {
          ofLayer[layer].push_back(m[1]);
        }
      }
    }
  });
  std::vector<double> deviations;
  for (const auto & layer : ofLayer)
  {
    deviations.insert(deviations.end(), layer.begin(), layer.end());
  }
  if (deviations.size() < 20)
  {
    return 0.0;
  }
  const auto quartile = deviations.begin() + deviations.size() / 4;
  std::nth_element(deviations.begin(), quartile, deviations.end());
  return *quartile;
}

void
SmoothVoxels(const ColonGrid & grid, std::vector<float> & hu, double sigma)
{
  for (int a = 0; a < 3; ++a)
  {
    const auto kernel = HalfKernel(sigma / grid.spacing[a]);
    const int  other = a == 2 ? 1 : 2; // lines of one slab along this axis go to one thread
    const int  third = 3 - a - other;
    ParallelFor(grid.size[other], [&](std::size_t s) {
      std::vector<float> buffer;
      for (int t = 0; t < grid.size[third]; ++t)
      {
        SmoothLine(&hu[s * grid.stride[other] + t * grid.stride[third]], grid.stride[a], grid.size[a], kernel, buffer);
      }
    });
  }
}

double
ShareInWall(const ColonGrid & grid, double smoothing)
{
  constexpr double halfWall = 1.0;  // mm
  constexpr double usualBlur = 0.8; // mm, standard deviation of the scanner's
  const double     voxel = grid.spacing.maxCoeff();
  const double     variance = usualBlur * usualBlur + voxel * voxel / 12.0 + smoothing * smoothing;
  return std::erfc(halfWall / std::sqrt(2.0 * variance));
}
} // namespace shapeton
