#ifndef shapetonColonDistension_h
#define shapetonColonDistension_h

#include "shapetonCurveSet.h"

#include "ShapetonColonCenterlineExport.h"

#include <limits>

namespace shapeton
{
/** Minimum caliber of distended lumen, mm. \ingroup ShapetonColonCenterline */
constexpr double LeastDistendedCaliber = 10.0;

/** Length of the anal canal, mm, at the beginning of the centerline; it is narrow in every colon (Gray's Anatomy, 41st
 * ed.: 4 cm). \ingroup ShapetonColonCenterline */
constexpr double AnalCanalLength = 40.0;

/** End of the anal canal on a line with these arc lengths and radii, mm: the arc length of the last point before the
 * caliber first reaches LeastDistendedCaliber, at most AnalCanalLength from the start; minus infinity if the line
 * starts distended. \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT double
EndOfAnalCanal(const Eigen::VectorXd & arcLength, const Eigen::VectorXd & radius);

/** Distension of a part of the colon: calibers and collapsed length. See MeasureDistension().
 * \ingroup ShapetonColonCenterline */
struct ColonDistension
{
  /** First and last arcLength, mm. */
  double begin{ 0.0 };
  double end{ 0.0 };
  /** Fraction of its length with a caliber of at least 10 mm, 0 to 1. */
  double share{ 0.0 };
  /** Mean inner diameter, mm; collapsed stretches count as 0. */
  double meanCaliber{ 0.0 };
  /** Smallest and largest inner diameter, mm; 0 in a collapsed stretch. */
  double leastCaliber{ 0.0 };
  double largestCaliber{ 0.0 };
  /** Length without lumen, mm. */
  double collapsedLength{ 0.0 };
};

/** Measures the distension of a stretch of the colon as in reports on CT colonography and barium enema: the fraction of
 * the centerline with a caliber of at least 1 cm.
 *
 * The caliber is the diameter of the largest inscribed ball, 2 * radius: the inner diameter at folds, not at haustra.
 * It is 0 in gaps. Points are weighted by step length.
 *
 * `curve` needs the point arrays arcLength, radius and gap that TraceColonCenterline() adds. The stretch is clipped to
 * the line; the default is the whole line. Throws InputError if an array is missing or the line has zero length, and
 * ParameterError if `end` precedes `begin`. \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT ColonDistension
MeasureDistension(const CurveSet & curve, double begin = 0.0, double end = std::numeric_limits<double>::infinity());
} // namespace shapeton

#endif
