#ifndef shapetonSphereAlignment_h
#define shapetonSphereAlignment_h

#include "ShapetonGraphComparisonExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <array>
#include <vector>

namespace shapeton
{
/** Least-squares rotation (row-major) that maps points of the unit sphere to their images (Kabsch 1976); never a
 * reflection. Both lists have the same length; the identity if they are empty. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::array<double, 9>
BestRotation(const std::vector<std::array<double, 3>> & points, const std::vector<std::array<double, 3>> & images);

/** A Moebius transformation of the sphere as a row-major Lorentz transformation of vectors (n, t): points (p, 1) and
 * caps (center / sin r, cot r). \ingroup ShapetonGraphComparison */
using SphereMotion = std::array<double, 16>;

/** Moebius transformation that minimizes the sum of distances between corresponding nodes (`image`: for each node of
 * `a` its node of `b`, or -1). The plain sum, unlike squares, is robust against a few nodes that moved far. A packing
 * is unique up to Moebius transformations. Gauss-Newton with Weiszfeld weights.
 * \pre Both geometries are spherical. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT SphereMotion
BestMotion(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image);

/** Transforms all circles of an embedding on the sphere; a circle packing remains a circle packing. \pre The geometry
 * is spherical.
 * \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT void
MoveEmbedding(EmbeddingCertificate & certificate, const SphereMotion & motion);

/** Position of a node on the sphere. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::array<double, 3>
                               PlaceOnSphere(const EmbeddingCertificate & certificate, int node);

/** Angle between two unit vectors in radians, accurate for small angles. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT double
AngleBetween(const std::array<double, 3> & a, const std::array<double, 3> & b);
} // namespace shapeton

#endif
