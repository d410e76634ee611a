#ifndef shapetonSegmentQuality_h
#define shapetonSegmentQuality_h

#include "ShapetonColonLandmarksExport.h"

#include "shapetonColonAssessability.h"
#include "shapetonColonDistension.h"
#include "shapetonColonLandmarkDocument.h"
#include "shapetonColonSegments.h"
#include "shapetonCsvTable.h"
#include "shapetonLumenDistance.h"
#include "shapetonSurfaceMesh.h"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup SegmentQuality Distension and preparation by segment What a reader of CT colonography states for each
 * segment of the colon: distension, fluid, residue, and parts of the wall that cannot be seen.
 * \ingroup ShapetonColonLandmarks */
///@{

/** Distension on the four-point scale of radiologists (Pickhardt et al., AJR 2014: collapsed, inadequate, adequate,
 * optimal). Radiologists grade by eye. Here, the grade is computed from the caliber outside the anal canal, with limits
 * of our choice: collapsed if less than half of the length has a caliber of at least 10 mm, inadequate if less than
 * nine tenths has, and otherwise adequate, or optimal if the mean caliber is at least 20 mm. */
enum class DistensionGrade
{
  Collapsed = 1,
  Inadequate,
  Adequate,
  Optimal
};

/** "collapsed", "inadequate", "adequate", "optimal". */
ShapetonColonLandmarks_EXPORT std::string
                              NameOf(DistensionGrade grade);

ShapetonColonLandmarks_EXPORT DistensionGrade
GradeOf(const ColonDistension & distension);

/** What covers or changes visible wall. */
enum class WallCover : unsigned char
{
  None,
  /** Coated by tagged matter: more than 300 HU within 2 mm behind the wall, not next to fluid; or, under fluid, more
   * than 200 HU up to 3 mm behind it. */
  Residue,
  Seam ///< within 2.5 mm of a fluid level, where electronic cleansing determines the wall
};

/** A part of the wall that a flat map does not show, such as a blind pouch. */
struct HiddenWall
{
  /** LPS, mm. */
  Eigen::Vector3d place{ Eigen::Vector3d::Zero() };
  /** mm^2. */
  double area{ 0.0 };
};

/** Quality of a segment. Values that require images are NaN if there are none. */
struct SegmentQuality
{
  ColonSegmentExtent extent;
  /** Excluding the anal canal. */
  ColonDistension    distension;
  DistensionGrade    grade{ DistensionGrade::Collapsed };
  ColonAssessability assessability;
  /** Fraction of the wall under tagged fluid, 0 to 1. */
  double submergedShare{ std::numeric_limits<double>::quiet_NaN() };
  /** Mean attenuation, before cleansing, of tagged fluid next to the wall, HU; NaN if there is no fluid. */
  double fluidAttenuation{ std::numeric_limits<double>::quiet_NaN() };
  /** Areas (mm^2) of the wall by WallCover. */
  double seamArea{ std::numeric_limits<double>::quiet_NaN() };
  double residueArea{ std::numeric_limits<double>::quiet_NaN() };
  /** Area (mm^2) and number of the parts of the wall that the flat map does not show. */
  double hiddenArea{ 0.0 };
  int    hiddenParts{ 0 };
  /** The largest of these parts. */
  HiddenWall largestHidden;
  /** Fraction of the length that is visible in the other position, and in at least one of the positions, 0 to 1; NaN if
   * unknown. */
  double otherShare{ std::numeric_limits<double>::quiet_NaN() };
  double eitherShare{ std::numeric_limits<double>::quiet_NaN() };

  /** The visible fraction of the length, or the fraction of the wall that the flat map shows without seams, whichever
   * is smaller; 0 to 1. */
  ShapetonColonLandmarks_EXPORT double
  EvaluableShare() const;
};

/** HU of a CT at a place (LPS, mm), NaN outside. */
using AttenuationAt = std::function<double(const Eigen::Vector3d &)>;

/** Interpolates linearly; the image must outlive the result. */
ShapetonColonLandmarks_EXPORT AttenuationAt
AttenuationOf(const itk::Image<float, 3> * ct);

/** For each face of a wall.
 * \param lumen 1 gas, 2 tagged fluid. \param original HU before cleansing. */
ShapetonColonLandmarks_EXPORT std::vector<WallCover>
FindWallCovers(const SurfaceMesh & wall, const LumenMask * lumen, const AttenuationAt & original);

/** Input of MeasureSegmentQuality(). */
struct SegmentQualityInput
{
  /** With the arrays of TraceColonCenterline(). */
  const CurveSet * centerline{ nullptr };
  /** The wall, with the cell array segment. */
  const SurfaceMesh *             wall{ nullptr };
  std::vector<ColonSegmentExtent> segments;
  std::vector<HiddenWall>         hidden;
  /** 1 gas, 2 tagged fluid; null if unknown or if the input was a mask. */
  const LumenMask * lumen{ nullptr };
  /** HU before cleansing; empty if unknown. */
  AttenuationAt attenuation;
};

/** In the order of the segments. Throws InputError if the wall or the centerline lacks an array. */
ShapetonColonLandmarks_EXPORT std::vector<SegmentQuality>
                              MeasureSegmentQuality(const SegmentQualityInput & input);

/** The columns of segments.csv: lengths in mm, areas in mm^2, fractions from 0 to 1, attenuations in HU. */
ShapetonColonLandmarks_EXPORT CsvTable
TableOfSegmentQuality(const std::vector<SegmentQuality> & segments);
///@}
} // namespace shapeton

#endif
