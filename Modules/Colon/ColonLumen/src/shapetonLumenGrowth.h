#ifndef shapetonLumenGrowth_h
#define shapetonLumenGrowth_h

#include "shapetonColonVolume.h"

#include <functional>

namespace shapeton
{
/** What a voxel of the working volume holds. */
enum LumenClass : unsigned char
{
  Nothing = 0,
  ColonGas = 1,
  ColonFluid = 2,
  OtherGas = 3,
  OtherBright = 4,
  Undecided = 5 ///< bright, and joined to the colon's fluid, perhaps by a leak
};

using ClassVolume = std::vector<unsigned char>;

/** Grows the first four classes at the same pace, by faces, `layers` times at most, into voxels where `mayEnter(voxel,
 * class)` holds. Where two arrive at once the colon's are served first. */
void
GrowClasses(const ColonGrid &                                               grid,
            ClassVolume &                                                   classes,
            int                                                             layers,
            const std::function<bool(std::size_t voxel, unsigned char c)> & mayEnter);
} // namespace shapeton

#endif
