#ifndef shapetonMiddleLine_h
#define shapetonMiddleLine_h

#include "shapetonColonCenterline.h"
#include "shapetonCurveShape.h"
#include "shapetonPieceLine.h"

namespace shapeton
{
/** A smooth curve in the middle of the lumen from a path of nodes. */
CurvePoints
ShapeLine(const LumenNetwork &           network,
          const DistanceField &          field,
          const std::vector<int> &       nodes,
          const ColonCenterlineOptions & options);

/** Extends the end of a curve to the pole of a wide end: the last node of its path may be anywhere near the pole. */
void
LeadToPole(const LumenNetwork &           network,
           const DistanceField &          field,
           const ColonCenterlineOptions & options,
           CurvePoints &                  points);

/** Cuts the end of a curve where 10 mm of it are safely inside: a path continues into places half a voxel wide. */
void
TrimEnds(const DistanceField & field, double step, CurvePoints & points);

/** At each point the radius of the largest ball inside the lumen with its center across the curve within 2 mm. */
std::vector<double>
RadiiAlong(const LumenNetwork & network, const DistanceField & field, const CurvePoints & points, double step);
} // namespace shapeton

#endif
