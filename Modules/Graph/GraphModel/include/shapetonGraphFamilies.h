#ifndef shapetonGraphFamilies_h
#define shapetonGraphFamilies_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \name Graphs whose genus and embeddings are known: for tests, examples and benchmarks. They throw
 * std::invalid_argument for counts below 0, or below what is said, and for more than 2^31 - 1 nodes.
 * \ingroup GraphModel */
///@{
GraphModel_EXPORT Graph
CompleteGraph(int nodes);
GraphModel_EXPORT Graph
CompleteBipartiteGraph(int left, int right);
/** 2^dimension nodes; those that differ in one bit are neighbours. */
GraphModel_EXPORT Graph
HypercubeGraph(int dimension);
GraphModel_EXPORT Graph
PathGraph(int nodes);
/** nodes >= 1: one node has a loop, two have a double edge. */
GraphModel_EXPORT Graph
CycleGraph(int nodes);
/** A cycle of `spokes` nodes, at least 1, around the last node. */
GraphModel_EXPORT Graph
WheelGraph(int spokes);
/** The generalised Petersen graph, n >= 1, 0 <= step < n: outer cycle 0..n-1, inner i joined with i + step; (5, 2) is
 * Petersen's. */
GraphModel_EXPORT Graph
GeneralizedPetersenGraph(int n, int step);
/** Columns x rows nodes, node (c, r) is r * columns + c, edges to the right and upwards. */
GraphModel_EXPORT Graph
GridGraph(int columns, int rows);
/** The grid that closes in both directions, columns >= 1, rows >= 1, drawn on the torus with columns * rows
 * quadrilaterals; with `diagonals`, twice as many triangles. */
GraphModel_EXPORT CombinatorialMap
TorusGridMap(int columns, int rows, bool diagonals = false);
///@}
} // namespace shapeton

#endif
