#ifndef shapetonLayoutTree_h
#define shapetonLayoutTree_h

#include "shapetonCirclePacking.h"
#include "shapetonParallelFor.h"

#include <cmath>
#include <vector>

namespace shapeton
{
/** The order in which the nodes are laid out, each one from a neighbour that has been before. Infinite nodes are left
 * out. */
struct LayoutTree
{
  /** A spanning tree along which the circles stay as large as can be, so that rounding errors do: of maximum
   * bottleneck, from `root`. */
  static LayoutTree
  OfLargestCircles(const CombinatorialMap & map, const CirclePacking & packing, int root);
  /** The shortest paths from the centre of the largest circle: the least spread of the lifts. */
  static LayoutTree
  OfShortestPaths(const CombinatorialMap & map, const CirclePacking & packing);

  std::vector<int> order;
  /** The half-edge that leads to each node; -1 for the root and infinite nodes. */
  std::vector<int> arrival;
};

/** The largest circle of a node that is not infinite. */
int
LargestFiniteNode(const CirclePacking & packing);

/** The angle from the first half-edge of its node to each half-edge, counter-clockwise, in [0, 2 pi); not for infinite
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
    long double angle = 0.0L; // a node may have many neighbours
    int         h = first;
    do
    {
      const int face = map.Face(h);
      angles[h] = static_cast<TReal>(angle);
      angle +=
        2.0L * HalfKiteAngle(packing.geometry, radius, FaceRadius<TReal>(packing, face), IsHorocycle(packing, face));
      h = map.NextAround(h);
    } while (h != first);
  });
  return angles;
}
} // namespace shapeton

#endif
