#ifndef shapetonCatheterFilling_h
#define shapetonCatheterFilling_h

#include "shapetonCatheterSearch.h"

namespace shapeton
{
/** Searches for a catheter within 150 mm of the caudal end of the lumen. If its confidence is sufficient, the catheter
 * is added to the lumen: bore, wall, enclosed gas, and a balloon with its content and membrane. A morphological closing
 * of 2.3 mm within 20 mm of the inner end adds the rest of the tip, including the side holes and the bulb. Empty if no
 * candidate is found. */
std::optional<RectalCatheter>
FillRectalCatheter(LumenField & field);
} // namespace shapeton

#endif
