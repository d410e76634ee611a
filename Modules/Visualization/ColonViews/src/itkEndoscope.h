#ifndef itkEndoscope_h
#define itkEndoscope_h

#include "itkPerspectiveRendering.h"
#include "itkPolypSearch.h"
#include "itkSurfaceLocator.h"

namespace itk
{
/** See PolypCandidatePictures::DrawFromWithin(). */
PerspectiveCamera
ChooseEye(const SurfaceLocator & wall, const CurveSet & centreline, const PolypCandidate & candidate);

/** Unit vectors of the vertices into the lumen, by area of the faces. */
VertexMatrix
InwardNormalsOf(const SurfaceMesh & wall);

/** The faces with a corner within `reach` mm of a point, and the point array head. */
SurfaceMesh
WallAround(const SurfaceMesh & wall, const std::vector<char> & isHead, const Eigen::Vector3d & point, double reach);
} // namespace itk

#endif
