#ifndef shapetonRectalCatheter_h
#define shapetonRectalCatheter_h

#include "shapetonLumenVoxels.h"

namespace shapeton
{
/** Makes a rectal catheter part of the lumen: in axial slices, islands in the lumen of at most 250 mm^2 with gas inside
 * that is not the lumen's, and the catheter's tip next to them. Folds and polyps hold no gas. From there the catheter
 * is followed caudally, slice by slice, through the anal canal: its gas with a wall of 1 mm, until it is no longer
 * surrounded by tissue, which is the anal verge, or for 60 mm. */
void
FillCatheter(const ColonGrid & grid, const std::vector<float> & hu, double gasBoundary, ClassVolume & classes);
} // namespace shapeton

#endif
