#include "shapetonSmoothedRows.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
std::vector<double>
GaussianWeights(double deviation)
{
  const int           reach = static_cast<int>(std::ceil(4.0 * deviation));
  std::vector<double> kernel;
  double              sum = 0.0;
  for (int k = -reach; k <= reach; ++k)
  {
    kernel.push_back(std::exp(-0.5 * k * k / (deviation * deviation)));
    sum += kernel.back();
  }
  for (double & weight : kernel)
  {
    weight /= sum;
  }
  return kernel;
}

std::vector<double>
SmoothedRows(const std::vector<double> & values, int rows, double deviation)
{
  const std::vector<double> kernel = GaussianWeights(deviation);
  const int                 reach = static_cast<int>(kernel.size()) / 2;
  const std::size_t         around = values.size() / rows;
  std::vector<double>       result(values.size(), 0.0);
  for (int row = 0; row < rows; ++row)
  {
    for (int k = -reach; k <= reach; ++k)
    {
      const int other = std::clamp(row + k, 0, rows - 1);
      for (std::size_t i = 0; i < around; ++i)
      {
        result[row * around + i] += kernel[k + reach] * values[other * around + i];
      }
    }
  }
  return result;
}
} // namespace shapeton
