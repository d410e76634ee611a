#ifndef shapetonGasInGaps_h
#define shapetonGasInGaps_h

#include "shapetonColonCenterline.h"
#include "shapetonColonLumenSegmentation.h"

#include <vector>

namespace shapeton
{
/** Gas excluded from the lumen as too thin that extends from one end of a gap of the centerline to the other: a
 * connection between two ends of a tube is that tube. */
struct GasInGap
{
  CenterlineGap gap;
  ColonLeftOut  gas;
};

/** Finds, for gaps of at least 30 mm, gas of at least 10 ml that contains a ball of 7 mm radius and comes within a
 * quarter of the length of the gap, at most 20 mm, of both its ends. */
std::vector<GasInGap>
FindGasInGaps(const ColonLumen & lumen, const ColonCenterline & line);

/** Sum of the straight lengths of all gaps, mm. */
double
LengthOfGaps(const ColonCenterline & line);
} // namespace shapeton

#endif
