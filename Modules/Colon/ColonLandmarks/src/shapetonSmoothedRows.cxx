#include "shapetonSmoothedRows.h"

#include "shapetonGaussianWeights.h"

#include <algorithm>

namespace shapeton
{
std::vector<double>
SmoothedRows(const std::vector<double> & values, int rows, double deviation)
{
  const std::vector<double> kernel = GaussianWeights(deviation, 4.0);
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
