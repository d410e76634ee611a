#ifndef shapetonSphereAlignment_h
#define shapetonSphereAlignment_h

#include "GraphComparisonExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <array>
#include <vector>

namespace shapeton
{
/** The rotation, row by row, that brings points of the unit sphere closest to their images in the sense of least
 * squares (Kabsch 1976); never a reflection. The lists are of the same length; the identity when they are empty.
 * \ingroup GraphComparison */
GraphComparison_EXPORT std::array<double, 9>
BestRotation(const std::vector<std::array<double, 3>> & points, const std::vector<std::array<double, 3>> & images);

/** A Moebius transformation of the sphere as a Lorentz transformation, row by row, of vectors (n, t): of points (p, 1)
 * and of caps (centre / sin r, cot r). \ingroup GraphComparison */
using SphereMotion = std::array<double, 16>;

/** The Moebius transformation that brings nodes of `b` closest to those of `a` that correspond (`image`: for each node
 * of `a` that of `b`, or -1): the sum of the distances is least, so that few nodes that moved far do not turn the
 * others. A packing is determined but for such a transformation. By Gauss and Newton with weights (Weiszfeld).
 * \pre Both geometries are spherical. \ingroup GraphComparison */
GraphComparison_EXPORT SphereMotion
BestMotion(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image);

/** Moves all circles of an embedding on the sphere; a circle packing stays one. \pre The geometry is spherical.
 * \ingroup GraphComparison */
GraphComparison_EXPORT void
MoveEmbedding(EmbeddingCertificate & certificate, const SphereMotion & motion);

/** The place of a node on the sphere. \ingroup GraphComparison */
GraphComparison_EXPORT std::array<double, 3>
                       PlaceOnSphere(const EmbeddingCertificate & certificate, int node);

/** The angle between two unit vectors in radians, exact for small ones. \ingroup GraphComparison */
GraphComparison_EXPORT double
AngleBetween(const std::array<double, 3> & a, const std::array<double, 3> & b);
} // namespace shapeton

#endif
