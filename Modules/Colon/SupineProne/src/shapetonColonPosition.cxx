#include "shapetonColonPosition.h"

#include "shapetonColonCylinder.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
bool
IsMostlyBridged(const FlatColonGrid & grid, int column)
{
  int bridged = 0;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    bridged += grid.IsBridged(column, row);
  }
  return 2 * bridged > grid.Rows();
}

/** Marks columns at a gap of the centerline. */
void
ExcludeGaps(const ColonCylinder & cylinder, const CurveSet & centerline, std::vector<char> & isExcluded)
{
  const SurfaceArray * gap = FindSurfaceArray(centerline.pointArrays, "gap");
  const SurfaceArray * arc = FindSurfaceArray(centerline.pointArrays, "arcLength");
  if (!gap || !arc)
  {
    return;
  }
  for (Eigen::Index i = 0; i < arc->values.rows(); ++i)
  {
    const double column = std::floor(cylinder.ColumnOfArc(arc->values(i, 0)));
    if (gap->values(i, 0) != 0.0 && column >= 0.0 && column < isExcluded.size())
    {
      isExcluded[static_cast<std::size_t>(column)] = 1;
    }
  }
}
} // namespace

std::vector<char>
FindExcludedColumns(const FlatColon & flat, const CurveSet & centerline, double leastRadius)
{
  const FlatColonGrid & grid = flat.Grid();
  const ColonCylinder   cylinder(flat, centerline);
  std::vector<char>     isExcluded(grid.Columns(), 0);
  for (int column = 0; column < grid.Columns(); ++column)
  {
    isExcluded[column] = cylinder.Radii()[column] < leastRadius || IsMostlyBridged(grid, column);
  }
  ExcludeGaps(cylinder, centerline, isExcluded);
  return isExcluded;
}

ColonPosition
MakeColonPosition(const std::string &               name,
                  std::shared_ptr<const FlatColon>  flat,
                  const CurveSet &                  centerline,
                  const ColonLandmarks &            landmarks,
                  const std::vector<HaustralFold> & folds)
{
  ColonPosition position;
  position.name = name;
  position.flat = std::move(flat);
  position.centerline = centerline;
  for (std::size_t i = 0; i < position.flexures.size(); ++i)
  {
    const ColonFlexure & flexure = landmarks.flexures.flexures[i];
    if (flexure.isFound)
    {
      position.flexures[i] = flexure.arcLength;
      position.flexureConfidence[i] = flexure.confidence;
    }
  }
  if (!landmarks.taeniae.taeniae.empty())
  {
    position.taeniae = TaeniaCurves(landmarks.taeniae);
  }
  position.curvature = landmarks.folds.curvature;
  position.folds = folds;
  position.isExcluded = FindExcludedColumns(*position.flat, centerline);
  return position;
}
} // namespace shapeton
