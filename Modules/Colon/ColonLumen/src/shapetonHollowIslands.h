#ifndef shapetonHollowIslands_h
#define shapetonHollowIslands_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Fills catheters not detected as a whole (see shapetonCatheterSearch.h) because their wall is too thin to be visible
 * all around. In axial slices, islands of at most 250 mm^2 in the lumen that contain separate gas, and adjacent
 * islands, become lumen; folds and polyps contain no gas. The gas is then followed caudally through the anal canal,
 * slice by slice, with a wall of 1 mm, until tissue no longer surrounds it (at the anal verge) or for 60 mm. */
void
FillHollowIslands(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, ClassVolume & classes);
} // namespace shapeton

#endif
