#ifndef ColonShape_h
#define ColonShape_h

#include "shapetonColonLandmarks.h"
#include "shapetonHaustralFolds.h"

#include <array>
#include <vector>

/** What a segment of the colon is like: samples, so that those of several colons can be put together. Lengths in mm. */
struct SegmentShape
{
  /** \name One for each colon */
  ///@{
  std::vector<double> lengths;
  /** Length over the straight way between the ends. */
  std::vector<double> tortuosities;
  /** How far the line, smoothed by 10 mm, turns in all, degrees for each dm. */
  std::vector<double> turnings;
  std::vector<double> foldsPerDecimetre;
  /** From fold to fold along the wall, as a walker on a straight way meets them: the length over the sum of the shares
   * of the circumference that the folds take. */
  std::vector<double> spacings;
  ///@}
  /** \name One for each mm of the line */
  ///@{
  /** Of the largest ball on the line; bridges are left out. */
  std::vector<double> inscribedRadii;
  /** Of the circle with the area of the section of the wall. Folds are cut into it. */
  std::vector<double> radii;
  ///@}
  /** \name One for each fold */
  ///@{
  std::vector<double> heights;
  /** Between the flanks at half of the height, where the fold is 3 mm high or more and both flanks can be seen. */
  std::vector<double> thicknesses;
  /** Of the circumference, degrees. */
  std::vector<double> extents;
  ///@}

  void
  Add(const SegmentShape & other);
};

/** The segments 1 to 6, and at 0 the whole colon. */
using ColonShape = std::array<SegmentShape, 7>;

/** Segments and folds as the tools find them with default options: folds split along the taeniae. A segment without
 * both of its borders stays empty. */
ColonShape
MeasureColonShape(const shapeton::FlatColon & flat, const shapeton::CurveSet & centreline);

void
AddShape(const ColonShape & other, ColonShape & shape);

#endif
