#ifndef shapetonEndoscope_h
#define shapetonEndoscope_h

#include "shapetonPerspectiveRendering.h"
#include "shapetonPolypSearch.h"
#include "shapetonSurfaceLocator.h"

namespace shapeton
{
/** See PolypCandidatePictures::DrawFromWithin(). */
PerspectiveCamera
ChooseEye(const SurfaceLocator & wall, const CurveSet & centreline, const PolypCandidate & candidate);

/** Unit vectors of the vertices into the lumen, by area of the faces. */
VertexMatrix
InwardNormalsOf(const SurfaceMesh & wall);

/** The faces with a corner within `reach` mm of a point. */
SurfaceMesh
WallAround(const SurfaceMesh & wall, const Eigen::Vector3d & point, double reach);
} // namespace shapeton

#endif
