#ifndef shapetonHollowIslands_h
#define shapetonHollowIslands_h

#include "shapetonLumenVoxels.h"

namespace shapeton
{
/** Handles catheters that are not recognized as a whole (see shapetonCatheterSearch.h) because their wall is too thin
 * to be visible all around. In axial slices, islands in the lumen of at most 250 mm^2 that contain separate gas, and
 * adjacent ones, become lumen; folds and polyps contain no gas. From there the gas is followed caudally, slice by
 * slice, through the anal canal, with a wall of 1 mm. It ends where tissue no longer surrounds it, at the anal verge,
 * or after 60 mm. */
void
FillHollowIslands(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, ClassVolume & classes);
} // namespace shapeton

#endif
