#ifndef itkSmallBowel_h
#define itkSmallBowel_h

#include "itkPhantomSolid.h"

namespace itk
{
/** Loops of small bowel in the central abdomen: tubes with a radius of 10 to 14 mm, pressed against each other with
 * walls between them. Most hold contrast medium, some of them as bright as tagged fluid, some gas over a level.
 * `down` is the direction of gravity. */
std::shared_ptr<const PhantomBody>
MakeSmallBowel(unsigned seed, const Vector<double, 3> & down);
} // namespace itk

#endif
