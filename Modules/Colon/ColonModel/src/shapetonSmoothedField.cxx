#include "shapetonSmoothedField.h"

#include "shapetonParallelFor.h"

#include <cmath>

namespace shapeton
{
namespace
{
std::vector<float>
KernelOf(double sigma)
{
  const auto         reach = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<float> kernel; // from the center outward
  double             sum = 0.0;
  for (int i = 0; i <= reach; ++i)
  {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    sum += (i == 0 ? 1.0 : 2.0) * kernel.back();
  }
  for (float & weight : kernel)
  {
    weight = static_cast<float>(weight / sum);
  }
  return kernel;
}

void
SmoothLine(const std::vector<float> & kernel, std::vector<float> & line, float * first, std::size_t stride)
{
  const auto length = static_cast<int>(line.size());
  for (int i = 0; i < length; ++i)
  {
    line[i] = first[i * stride];
  }
  for (int i = 0; i < length; ++i)
  {
    float sum = kernel[0] * line[i];
    for (int k = 1; k < static_cast<int>(kernel.size()); ++k)
    {
      sum += kernel[k] * (line[std::max(0, i - k)] + line[std::min(length - 1, i + k)]);
    }
    first[i * stride] = sum;
  }
}
} // namespace

std::vector<float>
SmoothedField(const VoxelGrid & grid, const std::vector<unsigned char> & values, double sigma)
{
  std::vector<float>       field(values.begin(), values.end());
  const std::vector<float> kernel = KernelOf(sigma);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int inner = axis == 0 ? 1 : 0;
    const int outer = axis == 2 ? 1 : 2;
    ParallelFor(grid.size[outer], [&](std::size_t j) {
      std::vector<float> line(grid.size[axis]);
      for (int i = 0; i < grid.size[inner]; ++i)
      {
        SmoothLine(kernel, line, &field[i * grid.stride[inner] + j * grid.stride[outer]], grid.stride[axis]);
      }
    });
  }
  return field;
}
} // namespace shapeton
