#ifndef shapetonCatheterFilling_h
#define shapetonCatheterFilling_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
/** Looks for a catheter within 150 mm of the caudal end of the lumen and, where it is sure, makes it part of the lumen:
 * bore and wall; the gas that is closed in around it; a balloon, what it holds and its membrane; what is left of the
 * tip within 20 mm of the inner end, with side holes and bulb: what closing the lumen by 2.3 mm adds to the tube.
 * Nothing where nothing looks like a catheter. */
std::optional<RectalCatheter>
FillRectalCatheter(LumenField & field);
} // namespace shapeton

#endif
