#ifndef shapetonShapeSearch_h
#define shapetonShapeSearch_h

#include "shapetonShapeSignature.h"

#include <string>
#include <vector>

namespace shapeton
{
/** How much two signatures differ, part by part: root mean squares of the differences of logarithms. 0 for equal ones.
 * Volume takes no part, so that shapes of any size compare. \ingroup ShapeSignature */
struct SignatureDifference
{
  /** Of 0.01 + remainingHeat: heats below a hundredth tell little. */
  double remainingHeat{ 0.0 };
  double displacement{ 0.0 };
  double spectrum{ 0.0 };
  double surface{ 0.0 }; ///< over volume^(2/3)
  double elongation{ 0.0 };
  double flatness{ 0.0 };
};

/** The differences of two signatures. \ingroup ShapeSignature */
ShapeSignature_EXPORT SignatureDifference
DifferenceOf(const ShapeSignature & a, const ShapeSignature & b);

/** The distance of two signatures, from 0: the root mean square of their differences, each in units of the root mean
 * square of what copies of one shape differ by, so that those are about 1 away from their shape. The copies are
 * turned, scaled, resampled and noisy ones of generated shapes (seeds 1 to 64). \ingroup ShapeSignature */
ShapeSignature_EXPORT double
SignatureDistance(const ShapeSignature & a, const ShapeSignature & b);

/** The probability that the nearest entry is of the same shape as what is looked for: logistic in the logarithms of its
 * distance and of the margin, the distance of the nearest entry of another name over it, at most 10. Fitted to
 * generated shapes (seeds 1 to 99), half of which had no entry. \ingroup ShapeSignature */
ShapeSignature_EXPORT double
ProbabilityOfSameShape(double distance, double margin);

/** A shape with a name, which several may share. \ingroup ShapeSignature */
struct NamedShape
{
  std::string    name;
  ShapeSignature signature;
};

/** An entry and its distance. \ingroup ShapeSignature */
struct ShapeNeighbour
{
  std::size_t entry{ 0 };
  double      distance{ 0.0 };
};

/** What FindShape() answers. \ingroup ShapeSignature */
struct ShapeSearchResult
{
  /** The nearest first; of equal distances the earlier entry. */
  std::vector<ShapeNeighbour> neighbours;
  /** ProbabilityOfSameShape() of the first one; where all entries have one name there is no margin: it counts as 1. */
  double probability{ 0.0 };

  /** More likely than not the shape is of none of the names. */
  bool
  IsUnknown() const
  {
    return probability < 0.5;
  }
};

/** Looks a shape up among entries, of which there is at least one; `nearest` neighbours at most.
 * \ingroup ShapeSignature */
ShapeSignature_EXPORT ShapeSearchResult
FindShape(const ShapeSignature & shape, const std::vector<NamedShape> & entries, std::size_t nearest);
} // namespace shapeton

#endif
