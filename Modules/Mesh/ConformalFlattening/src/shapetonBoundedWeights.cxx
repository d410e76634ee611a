#include "shapetonBoundedWeights.h"

#include <algorithm>

namespace shapeton
{
Eigen::VectorXd
BoundedWeights(const SurfaceLaplacian & laplacian, const std::vector<int> & levels)
{
  constexpr double least = 0.05;
  Eigen::VectorXd  weights = laplacian.weights;
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const auto & [a, b] = laplacian.edges[edge];
    const int level = std::max(levels[a], levels[b]);
    if (level > 0)
    {
      const double bound = std::min(1.0, least * (1 << (level - 1)));
      double &     weight = weights[static_cast<Eigen::Index>(edge)];
      weight = std::clamp(weight, bound, 1.0 / bound);
    }
  }
  return weights;
}
} // namespace shapeton
