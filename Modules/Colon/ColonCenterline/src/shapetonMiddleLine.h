#ifndef shapetonMiddleLine_h
#define shapetonMiddleLine_h

#include "shapetonColonCenterline.h"
#include "shapetonCurveShape.h"
#include "shapetonPieceLine.h"

namespace shapeton
{
/** Converts a path of nodes to a smooth curve in the middle of the lumen. */
CurvePoints
ShapeLine(const LumenNetwork &           network,
          const DistanceField &          field,
          const std::vector<int> &       nodes,
          const ColonCenterlineOptions & options);

/** Extends a curve to the pole of a wide end, since the last path node is only near the pole. */
void
LeadToPole(const LumenNetwork &           network,
           const DistanceField &          field,
           const ColonCenterlineOptions & options,
           CurvePoints &                  points);

/** Trims the end of a curve until its last 10 mm are well inside the lumen, since paths extend into gaps half a voxel
 * wide. */
void
TrimEnds(const DistanceField & field, double step, CurvePoints & points);

/** Radius at each point: the largest inscribed ball whose center is in the cross-section, at most 2 mm away. */
std::vector<double>
RadiiAlong(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step);
} // namespace shapeton

#endif
