#ifndef shapetonBoundaryLoops_h
#define shapetonBoundaryLoops_h

#include "ShapetonConformalFlatteningExport.h"

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** A closed boundary of a surface. \ingroup ShapetonConformalFlattening */
struct BoundaryLoop
{
  /** Vertices in boundary order, with the surface on the left as seen from outside. */
  std::vector<int> vertices;
  /** Length of the straight edges (mm). */
  double length{ 0.0 };
};

/** Returns the boundary loops of a surface, longest first; ties are broken by the lowest vertex index. Tools and
 * statistics number loops from 1. Throws InputError if a boundary is not closed, or touches itself or another boundary
 * at a vertex. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<BoundaryLoop>
BoundaryLoopsByLength(const SurfaceConnectivity & connectivity, const VertexMatrix & V);

/** For each vertex, the index of its loop, or -1. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<int>
                                   LoopOfVertices(const std::vector<BoundaryLoop> & loops, int numberOfVertices);

/** Faces with all three corners on one loop, in ascending order. A function constant on the loop is constant on these
 * faces, so their mapped area is zero. \ingroup ShapetonConformalFlattening */
ShapetonConformalFlattening_EXPORT std::vector<int>
                                   EarsOfLoops(const FaceMatrix & F, const std::vector<int> & loopOfVertices);
} // namespace shapeton

#endif
