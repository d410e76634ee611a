#ifndef shapetonGasInGaps_h
#define shapetonGasInGaps_h

#include "shapetonColonCenterline.h"
#include "shapetonColonLumenSegmentation.h"

#include <vector>

namespace shapeton
{
/** Gas that was excluded from the lumen as too thin but connects the two ends of a gap in the centerline. */
struct GasInGap
{
  CenterlineGap gap;
  ColonLeftOut  gas;
};

/** Finds gas with a volume of at least 10 ml and an inscribed radius of at least 7 mm near both ends of a gap at least
 * 30 mm long. The maximum distance from an end is a quarter of the gap length, but at most 20 mm. */
std::vector<GasInGap>
FindGasInGaps(const ColonLumen & lumen, const ColonCenterline & line);

/** Total straight length of the gaps, mm. */
double
LengthOfGaps(const ColonCenterline & line);
} // namespace shapeton

#endif
