#ifndef shapetonHollowIslands_h
#define shapetonHollowIslands_h

#include "shapetonLumenVoxels.h"

namespace shapeton
{
/** Where no catheter is recognised as a whole (see shapetonCatheterSearch.h), because its wall is too thin to be seen
 * all round: in axial slices, islands in the lumen of at most 250 mm^2 with gas inside that is not the lumen's, and
 * those next to them, become lumen. Folds and polyps hold no gas. From there the gas is followed caudally, slice by
 * slice, through the anal canal, with a wall of 1 mm, until it is no longer surrounded by tissue, which is the anal
 * verge, or for 60 mm. */
void
FillHollowIslands(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, ClassVolume & classes);
} // namespace shapeton

#endif
