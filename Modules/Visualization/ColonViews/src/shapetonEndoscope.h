#ifndef shapetonEndoscope_h
#define shapetonEndoscope_h

#include "shapetonPerspectiveRendering.h"
#include "shapetonPolypSearch.h"
#include "shapetonSurfaceLocator.h"

namespace shapeton
{
/** Camera of PolypCandidatePictures::DrawFromWithin(): it looks at the center of the head. The normals are those
 * of InwardNormalsOf(). */
PerspectiveCamera
ChooseEye(const SurfaceMesh &    wall,
          const VertexMatrix &   inwardNormals,
          const SurfaceLocator & locator,
          const CurveSet &       centerline,
          const PolypCandidate & candidate);

/** Unit vertex normals into the lumen, weighted by face area. */
VertexMatrix
InwardNormalsOf(const SurfaceMesh & wall);

/** Faces with a corner within `reach` mm of a point. */
SurfaceMesh
WallAround(const SurfaceMesh & wall, const Eigen::Vector3d & point, double reach);
} // namespace shapeton

#endif
