#ifndef shapetonBoundaryLoops_h
#define shapetonBoundaryLoops_h

#include "ConformalFlatteningExport.h"

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** A closed boundary of a surface. \ingroup ConformalFlattening */
struct BoundaryLoop
{
  /** In the order of the boundary, with the surface on the left as seen from outside. */
  std::vector<int> vertices;
  /** Of its straight edges, mm. */
  double length{ 0.0 };
};

/** The boundary loops of a surface, the longest first, of equally long ones that with the least vertex. Loop number i
 * of tools and statistics is element i - 1. Throws InputError where a boundary is not closed or touches itself or
 * another one in a vertex. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<BoundaryLoop>
                           BoundaryLoopsByLength(const SurfaceConnectivity & connectivity, const VertexMatrix & V);

/** For each vertex the element of the loops that it lies on, or -1. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<int>
                           LoopOfVertices(const std::vector<BoundaryLoop> & loops, int numberOfVertices);

/** Faces with all three corners on one loop: a function that is constant on the loop is constant on them, so that its
 * map gives them no area. In ascending order. \ingroup ConformalFlattening */
ConformalFlattening_EXPORT std::vector<int>
                           EarsOfLoops(const FaceMatrix & F, const std::vector<int> & loopOfVertices);
} // namespace shapeton

#endif
