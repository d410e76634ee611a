#ifndef itkSphereAlignment_h
#define itkSphereAlignment_h

#include "GraphComparisonExport.h"
#include "itkEmbeddingCertificate.h"

#include <array>
#include <vector>

namespace itk
{
/** The rotation, row by row, that brings points of the unit sphere closest to their images in the sense of least
 * squares (Kabsch 1976); never a reflection. The lists are of the same length; the identity when they are empty.
 * \ingroup GraphComparison */
GraphComparison_EXPORT std::array<double, 9>
BestRotation(const std::vector<std::array<double, 3>> & points, const std::vector<std::array<double, 3>> & images);

/** Turns all places of an embedding on the sphere; a circle packing stays one. \pre The geometry is spherical.
 * \ingroup GraphComparison */
GraphComparison_EXPORT void
TurnEmbedding(EmbeddingCertificate & certificate, const std::array<double, 9> & rotation);

/** The place of a node on the sphere. \ingroup GraphComparison */
GraphComparison_EXPORT std::array<double, 3>
                       PlaceOnSphere(const EmbeddingCertificate & certificate, int node);

/** The angle between two unit vectors in radians, exact for small ones. \ingroup GraphComparison */
GraphComparison_EXPORT double
AngleBetween(const std::array<double, 3> & a, const std::array<double, 3> & b);
} // namespace itk

#endif
