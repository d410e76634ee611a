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

/** Triangles for a loop of a surface that runs in the direction of its faces: a HolePatch, or, where the loop is very
 * long or only edges that the surface has already would do, rings of new vertices, each with six less, around a vertex
 * or a triangle in the middle. New vertices are numbered from `firstVertex` on. */
HoleFilling
TriangulateHole(const std::vector<int> &    loop,
                const VertexMatrix &        V,
                const SurfaceConnectivity & connectivity,
                int                         firstVertex);

/** Places the new vertices so that the squares of the uniform Laplacian at them and at the rim sum to a minimum.
 * `connectivity` is that of the closed surface. */
void
SmoothFilling(const HoleFilling & filling, const SurfaceConnectivity & connectivity, VertexMatrix & V);
} // namespace shapeton

#endif
