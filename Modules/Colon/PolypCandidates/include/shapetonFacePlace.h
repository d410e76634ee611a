#ifndef shapetonFacePlace_h
#define shapetonFacePlace_h

#include "ShapetonPolypCandidatesExport.h"

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Barycentric coordinates of a point in the plane of a face. \pre The face has a nonzero area.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT Eigen::Vector3d
                               BarycentricOf(const SurfaceMesh & mesh, int face, const Eigen::Vector3d & point);
} // namespace shapeton

#endif
