#ifndef shapetonColonPosition_h
#define shapetonColonPosition_h

#include "SupineProneExport.h"

#include "shapetonColonLandmarks.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonHaustralFolds.h"

#include <array>
#include <limits>
#include <memory>

namespace shapeton
{
/** The colon in one position, as its registration needs it. \ingroup SupineProne */
struct ColonPosition
{
  /** For messages: "supine", a folder. */
  std::string name;
  /** The flat wall. */
  std::shared_ptr<const FlatColon> flat;
  /** One curve from the rectum to the caecum, LPS, mm, with the point array arcLength (mm). */
  CurveSet centreline;
  /** Up to three curves on the wall, LPS, mm, with the cell array taenia; the numbers need not be those of the other
   * position. Empty where they are not known. */
  CurveSet taeniae;
  /** Along the centreline, mm: rectosigmoid, descending-sigmoid, splenic, hepatic; not a number where one was not
   * found. */
  std::array<double, 4> flexures{ { std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN() } };
  /** Of each flexure the probability that it lies within 30 mm, 0 to 1. */
  std::array<double, 4>     flexureConfidence{ { 1.0, 1.0, 1.0, 1.0 } };
  std::vector<HaustralFold> folds;
  /** Mean curvature of the vertices of the flat surface, 1/mm, positive where the wall bulges into the lumen, smooth
   * over some mm; that of the grid where empty. */
  Eigen::VectorXd curvature;
  /** Of each column of the grid: nothing is to be seen there, as FindExcludedColumns() tells. */
  std::vector<char> isExcluded;
};

/** Columns of the grid that are bridged for more than half of their turn, lie at a gap of the centreline (point array
 * gap, used where it is there), or where the wall lies less than `leastRadius` mm from its middle: collapsed
 * stretches. \ingroup SupineProne */
SupineProne_EXPORT std::vector<char>
                   FindExcludedColumns(const FlatColon & flat, const CurveSet & centreline, double leastRadius = 9.0);

/** The colon in one position from what was found of it; `flat` is what landmarks and folds were found on.
 * \param name for messages. \ingroup SupineProne */
SupineProne_EXPORT ColonPosition
MakeColonPosition(const std::string &               name,
                  std::shared_ptr<const FlatColon>  flat,
                  const CurveSet &                  centreline,
                  const ColonLandmarks &            landmarks,
                  const std::vector<HaustralFold> & folds);
} // namespace shapeton

#endif
