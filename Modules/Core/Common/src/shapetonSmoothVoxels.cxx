#include "shapetonSmoothVoxels.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shapeton
{
namespace
{
/** Convolution of one line of the grid. */
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

void
SmoothVoxels(const VoxelGrid & grid, const std::array<double, 3> & sigmas, float * values)
{
  for (int a = 0; a < 3; ++a)
  {
    if (sigmas[a] == 0.0)
    {
      continue;
    }
    const auto kernel = HalfKernel(sigmas[a]);
    const int  other = a == 2 ? 1 : 2; // one thread processes a slab of lines along this axis
    const int  third = 3 - a - other;
    ParallelFor(grid.size[other], [&](std::size_t s) {
      std::vector<float> buffer;
      for (int t = 0; t < grid.size[third]; ++t)
      {
        SmoothLine(
          values + s * grid.stride[other] + t * grid.stride[third], grid.stride[a], grid.size[a], kernel, buffer);
      }
    });
  }
}
} // namespace shapeton
