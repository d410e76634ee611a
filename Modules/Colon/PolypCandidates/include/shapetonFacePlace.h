#ifndef shapetonFacePlace_h
#define shapetonFacePlace_h

#include "PolypCandidatesExport.h"

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Weights of the corners of a face, sum 1, at a point in its plane. \pre The face has an area.
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT Eigen::Vector3d
                       BarycentricOf(const SurfaceMesh & mesh, int face, const Eigen::Vector3d & point);
} // namespace shapeton

#endif
