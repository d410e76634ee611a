#ifndef shapetonSquaredDistances_h
#define shapetonSquaredDistances_h

#include "ColonLumenExport.h"

#include <array>
#include <cstddef>

namespace shapeton
{
/** What SquaredDistances() gives where no voxel outside the mask is known, mm^2. \ingroup ColonLumen */
constexpr float UnknownSquaredDistance = 1e12F;

/** A box of mask voxels in a larger volume; the first axis is contiguous. \ingroup ColonLumen */
struct VoxelRows
{
  const unsigned char * first;
  /** Voxels from one row to the next, and from one slice to the next. */
  std::size_t rowStride;
  std::size_t sliceStride;
};

/** For each voxel of the mask (not 0) the squared distance in mm^2 from its centre to that of the nearest voxel outside
 * it (0), for these 0; exact. What lies beyond the box counts as neither.
 *
 * Lower envelopes of parabolas, line by line (Felzenszwalb, Huttenlocher: Distance transforms of sampled functions,
 * Theory of Computing 8, 2012): linear in voxels; threads do not change the values.
 *
 * \param size of the box in voxels; `squares` holds as many values, the first axis running fastest.
 * \ingroup ColonLumen */
ColonLumen_EXPORT void
SquaredDistances(const VoxelRows &                  mask,
                 const std::array<std::size_t, 3> & size,
                 const std::array<double, 3> &      spacing,
                 float *                            squares);
} // namespace shapeton

#endif
