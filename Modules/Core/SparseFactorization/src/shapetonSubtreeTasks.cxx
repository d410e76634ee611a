#include "shapetonSubtreeTasks.h"

namespace shapeton
{
namespace
{
/** Largest fraction of all work in one subtree. */
constexpr double largestPart = 1.0 / 12.0;
} // namespace

SubtreeTasks::SubtreeTasks(const Supernodes & supernodes)
{
  const int           number = supernodes.Number();
  std::vector<double> below(number, 0.0);
  for (int s = 0; s < number; ++s)
  {
    const double own = supernodes.Products(s);
    products += own;
    below[s] += own;
    if (supernodes.parent[s] != -1)
    {
      below[supernodes.parent[s]] += below[s];
    }
  }
  for (int s = 0; s < number; ++s)
  {
    const int  parent = supernodes.parent[s];
    const bool isSmall = below[s] <= largestPart * products;
    if (!isSmall)
    {
      trunk.push_back(s);
    }
    else if (parent == -1 || below[parent] > largestPart * products)
    {
      roots.push_back(s);
    }
  }
}
} // namespace shapeton
