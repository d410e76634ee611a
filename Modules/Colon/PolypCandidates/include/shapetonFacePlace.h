#ifndef shapetonFacePlace_h
#define shapetonFacePlace_h

#include "PolypCandidatesExport.h"

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Barycentric coordinates of a point in the plane of a face. \pre The face has a nonzero area.
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT Eigen::Vector3d
                       BarycentricOf(const SurfaceMesh & mesh, int face, const Eigen::Vector3d & point);
} // namespace shapeton

#endif
