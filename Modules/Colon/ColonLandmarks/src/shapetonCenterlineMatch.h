#ifndef shapetonCenterlineMatch_h
#define shapetonCenterlineMatch_h

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"

#include <vector>

namespace shapeton
{
/** Correspondence between columns of a flat map and positions on a centerline. */
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

/** Throws InputError if the centerline does not match the surface, or is directed from the cecum to the rectum. */
CenterlineMatch
MatchCenterline(const FlatColon & flat, const CurveSet & centerline);
} // namespace shapeton

#endif
