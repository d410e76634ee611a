#ifndef ColonShape_h
#define ColonShape_h

#include "shapetonColonLandmarks.h"
#include "shapetonHaustralFolds.h"

#include <array>
#include <string>
#include <vector>

/** Shape samples of a colon segment, which can be merged over several colons. Lengths in mm. */
struct SegmentShape
{
  /** \name One for each colon */
  ///@{
  std::vector<double> lengths;
  /** Length over the straight distance between the ends. */
  std::vector<double> tortuosities;
  /** Total turning of the line, smoothed by 10 mm (degrees per dm). */
  std::vector<double> turnings;
  std::vector<double> foldsPerDecimeter;
  /** Distance between folds along a straight path on the wall: the length divided by the sum of the fractions of the
   * circumference covered by the folds. */
  std::vector<double> spacings;
  ///@}
  /** \name One for each mm of the line */
  ///@{
  /** Radius of the largest ball centered on the line; bridges are excluded. */
  std::vector<double> inscribedRadii;
  /** Radius of the circle with the area of the wall's cross section, including folds. */
  std::vector<double> radii;
  ///@}
  /** \name One for each fold */
  ///@{
  std::vector<double> heights;
  /** Distance between the flanks at half height, for folds at least 3 mm high with both flanks visible. */
  std::vector<double> thicknesses;
  /** Extent along the circumference (degrees). */
  std::vector<double> extents;
  ///@}
};

/** A measure of SegmentShape. */
struct ShapeMeasure
{
  std::string         title;
  std::vector<double> SegmentShape::*samples;
};
extern const std::vector<ShapeMeasure> shapeMeasures;

/** Segments 1 to 6; index 0 is the whole colon. */
using ColonShape = std::array<SegmentShape, 7>;

/** Measures segments and folds detected with default options; folds are split along the taeniae. A segment without both
 * borders is empty. */
ColonShape
MeasureColonShape(const shapeton::FlatColon & flat, const shapeton::CurveSet & centerline);

void
AddShape(const ColonShape & other, ColonShape & shape);

#endif
