#ifndef shapetonVertexMerging_h
#define shapetonVertexMerging_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Positions closer than this fraction of the largest extent of the faces are equal: transforms in double precision
 * make the ends of a seam differ by 1e-16 of it, and different positions in single precision by 6e-8. */
constexpr double CoincidentPositions = 1e-9;

/** For each vertex, the lowest one at its position, or closer than a positive `distance` (mm), transitively. */
std::vector<int>
FirstAtPosition(const SurfaceMesh & mesh, double distance = 0.0);

/** Merges these vertices into the first of them, which keeps its position and arrays. Returns the number of removed
 * vertices. All faces are kept, including degenerate ones. */
int
MergeVertices(SurfaceMesh & mesh, double distance = 0.0);
} // namespace shapeton

#endif
