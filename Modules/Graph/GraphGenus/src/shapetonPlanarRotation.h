#ifndef shapetonPlanarRotation_h
#define shapetonPlanarRotation_h

#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** Puts a half-edge that has no place yet into the order around its node, after another one. */
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

/** The half-edge after each one in a planar embedding; empty when the graph has edges and is not planar. */
std::vector<int>
PlanarNextAround(const Graph & graph);
} // namespace shapeton

#endif
