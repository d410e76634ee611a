#ifndef shapetonVertexMerging_h
#define shapetonVertexMerging_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Merges vertices at equal positions, or closer than a positive `distance`, into the first of them, which keeps its
 * position and arrays. Returns the number of removed vertices. All faces are kept, including degenerate ones. */
int
MergeVertices(SurfaceMesh & mesh, double distance);
} // namespace shapeton

#endif
