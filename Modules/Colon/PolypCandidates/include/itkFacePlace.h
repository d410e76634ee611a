#ifndef itkFacePlace_h
#define itkFacePlace_h

#include "PolypCandidatesExport.h"

#include "itkSurfaceMesh.h"

namespace itk
{
/** Weights of the corners of a face, sum 1, at a point in its plane. \pre The face has an area.
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT Eigen::Vector3d
                       BarycentricOf(const SurfaceMesh & mesh, int face, const Eigen::Vector3d & point);
} // namespace itk

#endif
