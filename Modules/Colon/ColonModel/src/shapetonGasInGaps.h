#ifndef shapetonGasInGaps_h
#define shapetonGasInGaps_h

#include "shapetonColonCentreline.h"
#include "shapetonColonLumenSegmentation.h"

#include <vector>

namespace shapeton
{
/** Gas that was left out of the lumen as too thin, and that reaches from one end of a gap of the centreline to the
 * other: what joins two ends of a tube is that tube. */
struct GasInGap
{
  CentrelineGap gap;
  ColonLeftOut  gas;
};

/** Of gaps of at least 30 mm, gas of at least 10 ml that holds a ball of 7 mm radius and comes within a quarter of the
 * gap's length, at most 20 mm, of both of its ends. */
std::vector<GasInGap>
FindGasInGaps(const ColonLumen & lumen, const ColonCentreline & line);

/** Sum of the straight lengths of all gaps, mm. */
double
LengthOfGaps(const ColonCentreline & line);
} // namespace shapeton

#endif
