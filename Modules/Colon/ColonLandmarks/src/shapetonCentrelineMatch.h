#ifndef shapetonCentrelineMatch_h
#define shapetonCentrelineMatch_h

#include "shapetonRemarks.h"
#include "shapetonCurveSet.h"
#include "shapetonFlatColon.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Which place of a flat map lies at which place of a centreline. */
struct CentrelineMatch
{
  /** The centreline in order. */
  VertexMatrix    points;
  Eigen::VectorXd arcLength;
  /** For each column of the map, its width in mm; never falling. */
  std::vector<double> arcLengthOfColumn;
  double              columnWidth{ 1.0 };
  Remarks             warnings;
};

/** Throws InputError where the centreline is not that of the surface, or runs from the caecum to the rectum. */
CentrelineMatch
MatchCentreline(const FlatColon & flat, const CurveSet & centreline);
} // namespace shapeton

#endif
