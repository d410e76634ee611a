#ifndef shapetonColonDistension_h
#define shapetonColonDistension_h

#include "shapetonCurveSet.h"

#include "ShapetonColonCenterlineExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Smallest caliber of distended lumen, mm. \ingroup ShapetonColonCenterline */
constexpr double LeastDistendedCaliber = 10.0;

/** A segment of the colon along its centerline. \ingroup ShapetonColonCenterline */
struct ColonSegmentBorder
{
  std::string name;
  /** arcLength of its end toward the cecum, mm. */
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
  /** Share of its length with a caliber of at least 10 mm, 0 to 1. */
  double share{ 0.0 };
  /** Mean inner diameter, mm; collapsed stretches count as 0. */
  double meanCaliber{ 0.0 };
  /** Length without lumen, mm. */
  double collapsedLength{ 0.0 };
};

/** Segment borders at customary shares of the length from the anal verge, for use without landmarks:
 *
 * | segment | share | from | to |
 * |---|---|---|---|
 * | rectum | 0.10 | 0 | 0.10 |
 * | sigmoid | 0.25 | 0.10 | 0.35 |
 * | descending | 0.17 | 0.35 | 0.52 |
 * | transverse | 0.31 | 0.52 | 0.83 |
 * | ascending | 0.13 | 0.83 | 0.96 |
 * | cecum | 0.04 | 0.96 | 1 |
 *
 * Round figures for orientation, not measured here. Individual patients differ by several percent of the length.
 * \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT std::vector<ColonSegmentBorder>
                       CustomarySegments(double length);

/** Measures the distension of each segment as reports of CT colonography and barium enema state it: the share of the
 * centerline with a caliber of at least 1 cm.
 *
 * The caliber is the diameter of the largest ball inside the lumen across the line, 2 * radius: the inner diameter
 * between folds, not between haustra. A gap counts as 0 mm. Each step of the line is weighted by its length.
 *
 * `curve` needs the point arrays arcLength, radius and gap of TraceColonCenterline(). The borders must ascend; the last
 * segment ends with the line. Throws InputError when an array is missing or the line has zero length,
 * ParameterError for borders that do not ascend or are missing. \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT std::vector<SegmentDistension>
                       MeasureDistension(const CurveSet & curve, const std::vector<ColonSegmentBorder> & borders);

/** Measures the distension of CustomarySegments(). \ingroup ShapetonColonCenterline */
ShapetonColonCenterline_EXPORT std::vector<SegmentDistension>
                       MeasureDistension(const CurveSet & curve);
} // namespace shapeton

#endif
