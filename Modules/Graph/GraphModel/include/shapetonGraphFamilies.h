#ifndef shapetonGraphFamilies_h
#define shapetonGraphFamilies_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \name Graphs with known genus and embeddings, for tests, examples and benchmarks.
 * They throw ParameterError if a count is negative or below the stated minimum, or for more than 2^31 - 1
 * nodes. \ingroup ShapetonGraphModel */
///@{
ShapetonGraphModel_EXPORT Graph
CompleteGraph(int nodes);
ShapetonGraphModel_EXPORT Graph
CompleteBipartiteGraph(int left, int right);
/** 2^dimension nodes; nodes that differ in one bit are neighbors. */
ShapetonGraphModel_EXPORT Graph
HypercubeGraph(int dimension);
ShapetonGraphModel_EXPORT Graph
PathGraph(int nodes);
/** nodes >= 1; a single node has a loop, two nodes a double edge. */
ShapetonGraphModel_EXPORT Graph
CycleGraph(int nodes);
/** A cycle of `spokes` >= 1 nodes around the last node. */
ShapetonGraphModel_EXPORT Graph
WheelGraph(int spokes);
/** Generalized Petersen graph, n >= 1, 0 <= step < n: outer cycle 0..n-1, inner node i joined to i + step; (5, 2) is
 * the Petersen graph. */
ShapetonGraphModel_EXPORT Graph
GeneralizedPetersenGraph(int n, int step);
/** Columns x rows nodes; node (c, r) is r * columns + c, with edges to the right and upward. */
ShapetonGraphModel_EXPORT Graph
GridGraph(int columns, int rows);
/** A disk of the regular tiling {sides, degree}: node 0 and `rings` >= 1 rings of faces around it, where each ring
 * completes the boundary nodes of the previous one. Euclidean for {3, 6}, {4, 4} and {6, 3}, hyperbolic for larger
 * numbers; sides >= 3, degree >= 3; spherical tilings are not supported. */
ShapetonGraphModel_EXPORT Graph
RegularTilingGraph(int sides, int degree, int rings);
/** Grid periodic in both directions, columns >= 1, rows >= 1, embedded in the torus with columns * rows quadrilaterals;
 * with `diagonals`, twice as many triangles. */
ShapetonGraphModel_EXPORT CombinatorialMap
TorusGridMap(int columns, int rows, bool diagonals = false);
///@}
} // namespace shapeton

#endif
