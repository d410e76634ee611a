#ifndef shapetonColonDistension_h
#define shapetonColonDistension_h

#include "shapetonCurveSet.h"

#include "ShapetonColonCenterlineExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Minimum caliber of distended lumen, mm. \ingroup ShapetonColonCenterline */
constexpr double LeastDistendedCaliber = 10.0;

/** A segment of the colon along its centerline. \ingroup ShapetonColonCenterline */
struct ColonSegmentBorder
{
  std::string name;
  /** arcLength of its cecal end, mm. */
  double end{ 0.0 };
};

/** Distension of a part of the colon: length, caliber, collapsed part. See MeasureDistension().
 * \ingroup ShapetonColonCenterline */
struct SegmentDistension
{
  std::string name;
  /** First and last arcLength, mm. */
  double begin{ 0.0 };
  double end{ 0.0 };
  /** Fraction of its length with a caliber of at least 10 mm, 0 to 1. */
  double share{ 0.0 };
  /** Mean inner diameter, mm; collapsed stretches count as 0. */
  double meanCaliber{ 0.0 };
  /** Length without lumen, mm. */
  double collapsedLength{ 0.0 };
};

/** Segment borders at customary fractions of the length from the anal verge, for use without landmarks:
 *
 * | segment | fraction | from | to |
 * |---|---|---|---|
 * | rectum | 0.10 | 0 | 0.10 |
 * | sigmoid | 0.25 | 0.10 | 0.35 |
 * | descending | 0.17 | 0.35 | 0.52 |
 * | transverse | 0.31 | 0.52 | 0.83 |
 * | ascending | 0.13 | 0.83 | 0.96 |
 * | cecum | 0.04 | 0.96 | 1 |
 *
 * These are rounded typical values; patients differ by several percent of the length.
 * \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT std::vector<ColonSegmentBorder>
                               CustomarySegments(double length);

/** Measures the distension of each segment as in reports of CT colonography and barium enema: the fraction of the
 * centerline with a caliber of at least 1 cm.
 *
 * The caliber is the diameter of the largest inscribed ball, 2 * radius: the inner diameter at folds, not at haustra.
 * It is 0 in gaps. Points are weighted by step length.
 *
 * `curve` needs the point arrays arcLength, radius and gap of TraceColonCenterline(). The last segment ends with the
 * line. Throws InputError if an array is missing or the line has zero length, and ParameterError if borders are missing
 * or not in ascending order. \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT std::vector<SegmentDistension>
MeasureDistension(const CurveSet & curve, const std::vector<ColonSegmentBorder> & borders);

/** Measures distension for CustomarySegments(). \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT std::vector<SegmentDistension>
                               MeasureDistension(const CurveSet & curve);
} // namespace shapeton

#endif
