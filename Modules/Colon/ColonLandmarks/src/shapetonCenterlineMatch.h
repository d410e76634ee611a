#ifndef shapetonCenterlineMatch_h
#define shapetonCenterlineMatch_h

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Correspondence between columns of a flat map and places on a centerline. */
struct CenterlineMatch
{
  /** Centerline points in order. */
  VertexMatrix    points;
  Eigen::VectorXd arcLength;
  /** Distance along the centerline for each column of the map, nondecreasing, and the column width, mm. */
  std::vector<double> arcLengthOfColumn;
  double              columnWidth{ 1.0 };
  Remarks             warnings;
};

/** Throws InputError when the centerline does not belong to the surface, or runs from the cecum to the rectum. */
CenterlineMatch
MatchCenterline(const FlatColon & flat, const CurveSet & centerline);
} // namespace shapeton

#endif
