#ifndef shapetonPlaceInVoxel_h
#define shapetonPlaceInVoxel_h

#include "shapetonHostDevice.h"

#include <cmath>
#include <cstdint>

namespace shapeton
{
/** The position along an axis at `within`, in [0, 1], of the voxel with this index. Never the start of the next voxel,
 * even on the upper face or after rounding. */
SHAPETON_HOST_DEVICE float
PlaceInVoxel(std::uint32_t index, float within)
{
  const float begin = static_cast<float>(index);
  const float place = begin + within;
  const float last = nextafterf(begin + 1.0F, begin);
  return last < place ? last : place;
}
} // namespace shapeton

#endif
