#ifndef shapetonShapeSearch_h
#define shapetonShapeSearch_h

#include "shapetonShapeSearchOptions.h"
#include "shapetonShapeSignature.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Differences between two signatures by component: root mean square differences of logarithms; 0 for equal signatures.
 * Volume is excluded, so that shapes of any size can be compared. \ingroup ShapetonShapeSignature */
struct SignatureDifference
{
  /** Logarithm of 0.01 + remainingHeat, because heat below 0.01 carries little information. */
  double remainingHeat{ 0.0 };
  double displacement{ 0.0 };
  double spectrum{ 0.0 };
  double surface{ 0.0 }; ///< over volume^(2/3)
  double elongation{ 0.0 };
  double flatness{ 0.0 };
};

/** The differences between two signatures. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT SignatureDifference
DifferenceOf(const ShapeSignature & a, const ShapeSignature & b);

/** Distance between two signatures, at least 0: the root mean square of their differences, each normalized such that
 * copies of one shape have a distance of about 1. The copies are rotated, scaled, resampled and noisy versions of
 * generated shapes (seeds 1 to 64). \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT double
SignatureDistance(const ShapeSignature & a, const ShapeSignature & b);

/** The probability that the nearest entry has the same shape as the query: logistic in the logarithms of its distance
 * and of the margin. The margin is the distance of the nearest entry with another name divided by that distance, at
 * most 10. Fitted to generated shapes (seeds 1 to 99), half of which have no entry. \ingroup ShapetonShapeSignature
 */
ShapetonShapeSignature_EXPORT double
ProbabilityOfSameShape(double distance, double margin);

/** A named shape; several shapes may share a name. \ingroup ShapetonShapeSignature */
struct NamedShape
{
  std::string    name;
  ShapeSignature signature;
};

/** An entry and its distance. \ingroup ShapetonShapeSignature */
struct ShapeNeighbor
{
  std::size_t entry{ 0 };
  double      distance{ 0.0 };
};

/** Result of FindShape(). \ingroup ShapetonShapeSignature */
struct ShapeSearchResult
{
  /** Nearest first; earlier entry first for ties. */
  std::vector<ShapeNeighbor> neighbors;
  /** ProbabilityOfSameShape() of the first one; if all entries share a name there is no margin, and it is set to 1. */
  double probability{ 0.0 };

  /** Whether the shape most likely matches none of the names. */
  bool
  IsUnknown() const
  {
    return probability < 0.5;
  }
};

/** Finds the entries that are closest to a shape. Throws ParameterError for an option out of range. \pre There is at
 * least one entry. \ingroup ShapetonShapeSignature */
ShapetonShapeSignature_EXPORT ShapeSearchResult
FindShape(const ShapeSignature &          shape,
          const std::vector<NamedShape> & entries,
          const ShapeSearchOptions &      options = {});
} // namespace shapeton

#endif
