#ifndef shapetonColonPosition_h
#define shapetonColonPosition_h

#include "ShapetonSupineProneExport.h"

#include "shapetonColonLandmarks.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"
#include "shapetonHaustralFolds.h"

#include <array>
#include <limits>
#include <memory>

namespace shapeton
{
/** Registration input: the colon in one position. \ingroup ShapetonSupineProne */
struct ColonPosition
{
  /** Name used in messages: "supine", for example, or a folder. */
  std::string name;
  /** The flat wall. */
  std::shared_ptr<const FlatColon> flat;
  /** One curve from the rectum to the cecum, LPS, mm, with the point array arcLength (mm). */
  CurveSet centerline;
  /** Up to three curves on the wall, LPS, mm, with the cell array taenia; the numbering may differ between positions.
   * Empty if unknown. */
  CurveSet taeniae;
  /** Distances along the centerline, mm: rectosigmoid, descending-sigmoid, splenic, hepatic; NaN if not found. */
  std::array<double, 4> flexures{ { std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN(),
                                    std::numeric_limits<double>::quiet_NaN() } };
  /** Probability that each flexure is within 30 mm, 0 to 1. */
  std::array<double, 4>     flexureConfidence{ { 1.0, 1.0, 1.0, 1.0 } };
  std::vector<HaustralFold> folds;
  /** Smoothed mean curvature of the vertices of the flat surface, 1/mm, positive where the wall bulges into the lumen;
   * if empty, the curvature of the grid is used. */
  Eigen::VectorXd curvature;
  /** Flags of the excluded columns of the grid, from FindExcludedColumns(). */
  std::vector<char> isExcluded;
};

/** Finds collapsed columns of the grid: columns that are bridged over more than half a turn, are at a gap of the
 * centerline (point array gap, if present), or have a mean radius below `leastRadius` mm.
 * \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT std::vector<char>
FindExcludedColumns(const FlatColon & flat, const CurveSet & centerline, double leastRadius = 9.0);

/** Creates the position; `flat` is the surface to which landmarks and folds refer.
 * \param name label of the position in messages. \ingroup ShapetonSupineProne */
ShapetonSupineProne_EXPORT ColonPosition
MakeColonPosition(const std::string &               name,
                  std::shared_ptr<const FlatColon>  flat,
                  const CurveSet &                  centerline,
                  const ColonLandmarks &            landmarks,
                  const std::vector<HaustralFold> & folds);
} // namespace shapeton

#endif
