#ifndef shapetonSmallBowel_h
#define shapetonSmallBowel_h

#include "shapetonPhantomSolid.h"

namespace shapeton
{
/** Loops of small bowel in the central abdomen: adjacent tubes with a radius of 10 to 14 mm, separated by walls.
 * `tagged` is the fraction with contrast medium; some loops are as bright as tagged fluid, some contain gas above a
 * fluid level. `down` is the direction of gravity. */
struct SmallBowelLoops
{
  std::shared_ptr<const PhantomBody> body;
  PhantomSolid                       lumen; ///< gas and fluid; distances are clamped to 6 mm
};

SmallBowelLoops
MakeSmallBowel(unsigned seed, const itk::Vector<double, 3> & down, double tagged);
} // namespace shapeton

#endif
