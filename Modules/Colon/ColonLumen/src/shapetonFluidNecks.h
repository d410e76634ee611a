#ifndef shapetonFluidNecks_h
#define shapetonFluidNecks_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Decides what is Undecided: of the bright matter joined to the colon's levels and seeds only what a wide passage
 * reaches is colon; the rest competes for what lies between. Thin matter is colon no farther than 12 mm from wide fluid
 * or a level: beyond, it is bone or another bowel. */
void
SplitAtNecks(LumenField & field);
} // namespace shapeton

#endif
