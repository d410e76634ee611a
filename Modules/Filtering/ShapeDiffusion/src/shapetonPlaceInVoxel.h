#ifndef shapetonPlaceInVoxel_h
#define shapetonPlaceInVoxel_h

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shapeton
{
/** The place along an axis `within`, in [0, 1], of the voxel with this index. Never the begin of the next voxel: not
 * for a place on the upper face, and not where the sum is rounded up. */
inline float
PlaceInVoxel(std::uint32_t index, float within)
{
  const float begin = static_cast<float>(index);
  return std::min(begin + within, std::nextafter(begin + 1.0F, begin));
}
} // namespace shapeton

#endif
