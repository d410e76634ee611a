#ifndef itkHoleFilling_h
#define itkHoleFilling_h

#include "itkSurfaceConnectivity.h"

namespace itk
{
/** New vertices and faces that close a boundary loop. */
struct HoleFilling
{
  std::vector<int>                rim;
  int                             firstVertex{ 0 };
  int                             numberOfVertices{ 0 };
  std::vector<std::array<int, 3>> faces;
};

/** Triangles for a loop that runs in the direction of its faces: rings of new vertices, each with six less, and a
 * vertex or a triangle in the middle. New vertices are numbered from `firstVertex` on. */
HoleFilling
TriangulateHole(const std::vector<int> & loop, int firstVertex);

/** Places the new vertices so that the squares of the uniform Laplacian at them and at the rim sum to a minimum.
 * `connectivity` is that of the closed surface. */
void
SmoothFilling(const HoleFilling & filling, const SurfaceConnectivity & connectivity, VertexMatrix & V);
} // namespace itk

#endif
