#ifndef shapetonCatheterFilling_h
#define shapetonCatheterFilling_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
/** Searches a catheter within 150 mm of the caudal end of the lumen. If certain, it is added to the lumen: bore and
 * wall; enclosed gas; a balloon with its content and membrane; and the rest of the tip within 20 mm of the inner end,
 * with side holes and bulb, as the morphological closing of the lumen by 2.3 mm. Empty if nothing resembles a
 * catheter. */
std::optional<RectalCatheter>
FillRectalCatheter(LumenField & field);
} // namespace shapeton

#endif
