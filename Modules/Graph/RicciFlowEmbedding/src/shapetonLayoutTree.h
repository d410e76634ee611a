#ifndef shapetonLayoutTree_h
#define shapetonLayoutTree_h

#include "shapetonCirclePacking.h"
#include "shapetonParallelFor.h"

#include <cmath>
#include <vector>

namespace shapeton
{
/** Layout order of the nodes, each placed from an earlier neighbor. Infinite nodes are skipped. */
struct LayoutTree
{
  /** Maximum-bottleneck spanning tree from `root`: circles along it are as large as possible, which limits rounding
   * errors. */
  static LayoutTree
  OfLargestCircles(const CombinatorialMap & map, const CirclePacking & packing, int root);
  /** Shortest paths from the center of the largest circle, which minimize the spread of the lifts. */
  static LayoutTree
  OfShortestPaths(const CombinatorialMap & map, const CirclePacking & packing);

  std::vector<int> order;
  /** The half-edge that leads to each node; -1 for the root and infinite nodes. */
  std::vector<int> arrival;
};

/** Finite node with the largest circle. */
int
LargestFiniteNode(const CirclePacking & packing);

/** Counter-clockwise angle from the first half-edge of its node to each half-edge, in [0, 2 pi); not set for infinite
 * nodes. */
template <typename TReal = double>
std::vector<TReal>
HalfEdgeAngles(const CombinatorialMap & map, const CirclePacking & packing)
{
  std::vector<TReal> angles(map.HalfEdges(), TReal(0));
  ParallelForBlocks(map.Nodes(), [&](std::size_t node) {
    const TReal radius = NodeRadius<TReal>(packing, static_cast<int>(node));
    if (std::isinf(radius))
    {
      return;
    }
    const int   first = map.FirstAround(static_cast<int>(node));
    long double angle = 0.0L; // a node may have many neighbors
    int         h = first;
    do
    {
      const int face = map.Face(h);
      angles[h] = static_cast<TReal>(angle);
      angle +=
        2 * HalfKiteAngle(packing.geometry, radius, FaceRadius<TReal>(packing, face), IsHorocycle(packing, face));
      h = map.NextAround(h);
    } while (h != first);
  });
  return angles;
}
} // namespace shapeton

#endif
