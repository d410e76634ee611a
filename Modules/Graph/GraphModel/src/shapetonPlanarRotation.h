#ifndef shapetonPlanarRotation_h
#define shapetonPlanarRotation_h

#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** Inserts a half-edge into the order around its node, after another one. */
inline void
InsertAfter(std::vector<int> & nextAround, int halfEdge, int after)
{
  nextAround[halfEdge] = nextAround[after];
  nextAround[after] = halfEdge;
}

/** Joins two orders around one node into one. */
inline void
SpliceOrders(std::vector<int> & nextAround, int one, int other)
{
  std::swap(nextAround[one], nextAround[other]);
}

/** The half-edge before another one around its node. */
int
PreviousAround(const std::vector<int> & nextAround, int halfEdge);

/** Successor of each half-edge in a planar embedding; empty if the graph has edges and is not planar. */
std::vector<int>
PlanarNextAround(const Graph & graph);
} // namespace shapeton

#endif
