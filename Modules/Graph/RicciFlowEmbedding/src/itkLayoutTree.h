#ifndef itkLayoutTree_h
#define itkLayoutTree_h

#include "itkCirclePacking.h"

#include <vector>

namespace itk
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
std::vector<double>
HalfEdgeAngles(const CombinatorialMap & map, const CirclePacking & packing);
} // namespace itk

#endif
