#ifndef shapetonVertexMerging_h
#define shapetonVertexMerging_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Merges vertices at one position, or nearer than `distance` when that is greater than 0, into the first of them,
 * which keeps its position and its arrays. Returns how many vertices went. Faces are kept, degenerate ones too. */
int
MergeVertices(SurfaceMesh & mesh, double distance);
} // namespace shapeton

#endif
