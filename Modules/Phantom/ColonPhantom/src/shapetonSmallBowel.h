#ifndef shapetonSmallBowel_h
#define shapetonSmallBowel_h

#include "shapetonPhantomSolid.h"

namespace shapeton
{
/** Loops of small bowel in the central abdomen: tubes with a radius of 10 to 14 mm, pressed against each other with
 * walls between them. Most hold contrast medium, some of them as bright as tagged fluid, some gas over a level.
 * `down` is the direction of gravity. */
std::shared_ptr<const PhantomBody>
MakeSmallBowel(unsigned seed, const itk::Vector<double, 3> & down);
} // namespace shapeton

#endif
