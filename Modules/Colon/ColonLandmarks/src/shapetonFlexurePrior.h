#ifndef shapetonFlexurePrior_h
#define shapetonFlexurePrior_h

#include <array>
#include <cmath>

namespace shapeton
{
/** A normal distribution. */
struct PriorValue
{
  double mean;
  double deviation;

  double
  SquaredDeviation(double value) const
  {
    const double d = (value - mean) / deviation;
    return d * d;
  }
  double
  LogDensity(double value) const
  {
    constexpr double rootOfTwoPi = 2.5066282746310002; // sqrt(2 pi), of the normal density
    return -0.5 * this->SquaredDeviation(value) - std::log(rootOfTwoPi * deviation);
  }
};

/** Number of features of a flexure, in the order of FlexurePrior::features. */
constexpr int NumberOfFlexureFeatures = 12;
using FlexureFeatures = std::array<double, NumberOfFlexureFeatures>;

/** Anatomical prior of a flexure; see shapetonColonFlexures.h for the sources. */
struct FlexurePrior
{
  /** Fraction of the length before the flexure; position in the bounding box (0 right, front, bottom; 1 left, back,
   * top); angle between chords of 35 and 70 mm in units of 90 degrees; direction (left, back, up) 40 mm before and
   * after. */
  std::array<PriorValue, NumberOfFlexureFeatures> features;
  /** Length from the previous flexure, as a fraction of the total length; for the first flexure see
   * TheLengthOfRectum. */
  PriorValue gap;
};

constexpr std::array<FlexurePrior, 4> TheFlexurePriors{
  { // rectosigmoid: 16 of 152 cm; midline, in front of S3; the sigmoid turns forward, to either side
    { { { { 0.105, 0.06 },
          { 0.50, 0.10 },
          { 0.70, 0.15 },
          { 0.32, 0.10 },
          { 0.60, 0.30 },
          { 0.70, 0.35 },
          { 0.00, 0.40 },
          { 0.00, 0.45 },
          { 0.75, 0.35 },
          { 0.00, 0.65 },
          { -0.40, 0.50 },
          { 0.10, 0.55 } } },
      { 0.105, 0.03 } },
    // end of the descending colon: pelvic brim, left iliac fossa, 11 to 17 cm above the verge; the colon ascends from
    // there. The sigmoid is 20 to 45 % of the length, so that the fraction is 0.22 to 0.55.
    { { { { 0.39, 0.10 },
          { 0.85, 0.12 },
          { 0.65, 0.20 },
          { 0.36, 0.10 },
          { 0.50, 0.30 },
          { 0.55, 0.35 },
          { 0.40, 0.45 },
          { 0.20, 0.50 },
          { 0.20, 0.50 },
          { 0.10, 0.35 },
          { 0.20, 0.35 },
          { 0.85, 0.25 } } },
      { 0.28, 0.10 } },
    // splenic: the highest point, left and back; the transverse colon turns right, forward and down
    { { { { 0.54, 0.09 },
          { 0.90, 0.10 },
          { 0.75, 0.18 },
          { 0.98, 0.06 },
          { 1.00, 0.40 },
          { 1.40, 0.40 },
          { 0.10, 0.35 },
          { 0.10, 0.35 },
          { 0.80, 0.30 },
          { -0.45, 0.40 },
          { -0.45, 0.40 },
          { -0.40, 0.40 } } },
      { 0.145, 0.045 } },
    // hepatic: right, one to two vertebrae lower; the ascending colon turns down
    { { { { 0.84, 0.045 },
          { 0.12, 0.10 },
          { 0.65, 0.18 },
          { 0.88, 0.10 },
          { 0.90, 0.40 },
          { 1.20, 0.40 },
          { -0.50, 0.40 },
          { 0.35, 0.40 },
          { 0.40, 0.40 },
          { -0.10, 0.35 },
          { 0.15, 0.40 },
          { -0.80, 0.30 } } },
      { 0.31, 0.07 } } }
};

/** Fraction of the length from the hepatic flexure to the end: ascending colon and cecum. */
constexpr PriorValue ThePriorOfRightColon{ 0.165, 0.045 };

/** Length (mm) from the anal verge to the rectosigmoid flexure, almost independent of the length of the colon. Up to 5
 * cm of the anal canal may be outside the image. */
constexpr PriorValue TheLengthOfRectum{ 150.0, 40.0 };

/** Prior for the points of a section of the colon: position in the box and direction, as for a flexure. */
struct SectionPrior
{
  std::array<PriorValue, 3> place;
  std::array<PriorValue, 3> direction;

  /** Log-likelihood ratio of the section to the whole colon, whose positions and directions are uniformly
   * distributed. */
  template <typename TPlace, typename TDirection>
  double
  LogRatio(const TPlace & at, const TDirection & tangent) const
  {
    constexpr double widthOfDirections = 2.0; // a component is uniform in -1 to 1 for a random direction
    double           sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += place[axis].LogDensity(at[axis]) + direction[axis].LogDensity(tangent[axis]) + std::log(widthOfDirections);
    }
    return sum;
  }
};

/** Descending colon: straight up along the left and posterior wall, from the iliac crest. */
constexpr SectionPrior TheDescendingColon{ { { { 0.88, 0.10 }, { 0.70, 0.22 }, { 0.64, 0.24 } } },
                                           { { { 0.00, 0.30 }, { 0.00, 0.35 }, { 0.90, 0.20 } } } };

/** Lower end of the descending colon, the iliac colon: it runs from the pelvic brim obliquely up to the left, in front
 * of the iliac bone. */
constexpr SectionPrior TheIliacColon{ { { { 0.72, 0.08 }, { 0.30, 0.12 }, { 0.36, 0.08 } } },
                                      { { { 0.40, 0.25 }, { -0.05, 0.40 }, { 0.75, 0.15 } } } };

/** Fraction of the descending colon that is iliac colon: 12 to 15 of 37 to 40 cm. */
constexpr double TheShareOfIliacColon = 0.4;

/** The end of the descending colon relative to the bones, mm: height above the promontory, distance to the left of it.
 * In two patients, the end is 33 mm above and 30 mm below the promontory, and 80 to 120 mm to the left of it. */
constexpr PriorValue TheHeightAbovePromontory{ 0.0, 25.0 };
constexpr PriorValue TheDistanceLeftOfPromontory{ 85.0, 30.0 };
} // namespace shapeton

#endif
