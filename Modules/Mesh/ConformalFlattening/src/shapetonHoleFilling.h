#ifndef shapetonHoleFilling_h
#define shapetonHoleFilling_h

#include "shapetonSurfaceConnectivity.h"

namespace shapeton
{
/** New vertices and faces that close a boundary loop. */
struct HoleFilling
{
  std::vector<int>                rim;
  int                             firstVertex{ 0 };
  int                             numberOfVertices{ 0 };
  std::vector<std::array<int, 3>> faces;
};

/** Triangulates a loop that runs in the direction of its faces. The result is a HolePatch. If the loop is very long, or
 * a patch would repeat existing edges, it consists of rings of new vertices, each with six fewer, around a center
 * vertex or triangle. New vertices are numbered from `firstVertex`. */
HoleFilling
TriangulateHole(const std::vector<int> &    loop,
                const VertexMatrix &        V,
                const SurfaceConnectivity & connectivity,
                int                         firstVertex);

/** Places the new vertices to minimize the sum of squared uniform Laplacians at them and at the rim. `connectivity`
 * belongs to the closed surface. */
void
SmoothFilling(const HoleFilling & filling, const SurfaceConnectivity & connectivity, VertexMatrix & V);
} // namespace shapeton

#endif
