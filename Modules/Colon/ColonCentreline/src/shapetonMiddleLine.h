#ifndef shapetonMiddleLine_h
#define shapetonMiddleLine_h

#include "shapetonColonCentreline.h"
#include "shapetonCurveShape.h"
#include "shapetonPieceLine.h"

namespace shapeton
{
/** A smooth curve in the middle of the lumen from a path of nodes. */
CurvePoints
ShapeLine(const LumenNetwork &           network,
          const DistanceField &          field,
          const std::vector<int> &       nodes,
          const ColonCentrelineOptions & options);

/** Leads the end of a curve on to the pole of a wide end: the last node of its path lies on the side of the pole as
 * well as at it. */
void
LeadToPole(const LumenNetwork &           network,
           const DistanceField &          field,
           const ColonCentrelineOptions & options,
           CurvePoints &                  points);

/** Ends a curve where all of it is safely inside over 10 mm: a path goes on into what is only half a voxel wide. */
void
TrimEnds(const DistanceField & field, double step, CurvePoints & points);

/** At each point the radius of the largest ball inside the lumen whose centre lies across the curve within 2 mm. */
std::vector<double>
RadiiAlong(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step);
} // namespace shapeton

#endif
