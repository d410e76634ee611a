#ifndef shapetonHollowIslands_h
#define shapetonHollowIslands_h

#include "shapetonLumenField.h"

namespace shapeton
{
/** Fills catheters not detected as a whole (see shapetonCatheterSearch.h) because their wall is too thin to be visible
 * all around. In axial slices, islands of at most 250 mm^2 in the lumen that contain separate gas become lumen, as do
 * islands adjacent to them; folds and polyps do not contain gas. The gas is then followed caudally through the anal
 * canal, slice by slice, with a 1 mm wall, until tissue no longer surrounds it (at the anal verge), or for 60 mm. */
void
FillHollowIslands(const ColonGrid & grid, const VoxelValues & hu, double gasBoundary, ClassVolume & classes);
} // namespace shapeton

#endif
