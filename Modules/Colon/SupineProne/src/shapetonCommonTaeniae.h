#ifndef shapetonCommonTaeniae_h
#define shapetonCommonTaeniae_h

#include "shapetonColonPair.h"
#include "shapetonSupineProneRegistration.h"

namespace shapeton
{
/** Compares the taeniae under the final map and its confidence. Both positions have their taeniae in one order around
 * the tube, so one of three cyclic shifts is right; each row of nodes votes for the shift with the nearest taeniae,
 * with the probability that the map is right there. */
CommonTaeniae
FindCommonTaeniae(const ColonPair & pair, const SupineProneRegistration & registration);
} // namespace shapeton

#endif
