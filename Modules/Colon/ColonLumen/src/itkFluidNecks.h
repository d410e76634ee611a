#ifndef itkFluidNecks_h
#define itkFluidNecks_h

#include "itkLumenField.h"

namespace itk
{
/** Decides what is Undecided: of the bright matter joined to the colon's levels and seeds only what a wide passage
 * reaches is colon; the rest competes for what lies between. Thin matter is colon no farther than 12 mm from wide fluid
 * or a level: beyond, it is bone or another bowel. */
void
SplitAtNecks(LumenField & field);
} // namespace itk

#endif
