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

SurfaceLaplacian
WithBoundedWeights(SurfaceLaplacian laplacian, const std::vector<int> & levels)
{
  if (!levels.empty())
  {
    laplacian.weights = BoundedWeights(laplacian, levels);
  }
  return laplacian;
}

void
RaiseWeightLevels(const FaceMatrix &        F,
                  const EdgeGraph &         graph,
                  const std::vector<char> & isFlipped,
                  int                       rings,
                  std::vector<int> &        levels)
{
  std::vector<char> isRaised(levels.size(), 0);
  for (Eigen::Index corner = 0; corner < F.size(); ++corner)
  {
    isRaised[F.data()[corner]] |= isFlipped[corner / 3];
  }
  Dilate(graph, isRaised, rings);
  for (std::size_t v = 0; v < levels.size(); ++v)
  {
    levels[v] = std::min(greatestWeightLevel, levels[v] + isRaised[v]);
  }
}
} // namespace shapeton
