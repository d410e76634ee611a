#ifndef shapetonGraphFamilies_h
#define shapetonGraphFamilies_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \name Graphs with known genus and embeddings, for tests, examples and benchmarks.
 * They throw std::invalid_argument if a count is negative or below the stated minimum, or for more than 2^31 - 1
 * nodes. \ingroup GraphModel */
///@{
GraphModel_EXPORT Graph
CompleteGraph(int nodes);
GraphModel_EXPORT Graph
CompleteBipartiteGraph(int left, int right);
/** 2^dimension nodes; nodes that differ in one bit are neighbors. */
GraphModel_EXPORT Graph
HypercubeGraph(int dimension);
GraphModel_EXPORT Graph
PathGraph(int nodes);
/** nodes >= 1; a single node has a loop, two nodes a double edge. */
GraphModel_EXPORT Graph
CycleGraph(int nodes);
/** A cycle of `spokes` >= 1 nodes around the last node. */
GraphModel_EXPORT Graph
WheelGraph(int spokes);
/** Generalized Petersen graph, n >= 1, 0 <= step < n: outer cycle 0..n-1, inner node i joined with i + step; (5, 2) is
 * the Petersen graph. */
GraphModel_EXPORT Graph
GeneralizedPetersenGraph(int n, int step);
/** Columns x rows nodes; node (c, r) is r * columns + c, with edges to the right and upward. */
GraphModel_EXPORT Graph
GridGraph(int columns, int rows);
/** Grid periodic in both directions, columns >= 1, rows >= 1, embedded in the torus with columns * rows quadrilaterals;
 * with `diagonals`, twice as many triangles. */
GraphModel_EXPORT CombinatorialMap
TorusGridMap(int columns, int rows, bool diagonals = false);
///@}
} // namespace shapeton

#endif
