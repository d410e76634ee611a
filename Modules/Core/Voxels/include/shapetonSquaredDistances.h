#ifndef shapetonSquaredDistances_h
#define shapetonSquaredDistances_h

#include "shapetonVoxelGrid.h"
#include "shapetonVoxelValues.h"
#include "VoxelsExport.h"

#include <limits>
#include <vector>

namespace shapeton
{
/** What SquaredDistances() gives where no voxel outside the mask is known, or none within `farthest`, mm^2.
 * \ingroup Voxels */
constexpr float UnknownSquaredDistance = 1e12F;

/** A box of mask voxels in a larger volume; the first axis is contiguous. \ingroup Voxels */
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
 * \param box the voxels of the box; `squares` holds as many values, in its order.
 * \param farthest mm; greater distances are not told. A small one takes less time.
 * \ingroup Voxels */
Voxels_EXPORT void
SquaredDistances(const VoxelRows &             mask,
                 const VoxelGrid &             box,
                 const std::array<double, 3> & spacing,
                 float *                       squares,
                 double                        farthest = std::numeric_limits<double>::infinity());

/** The same of a mask on a grid. \ingroup Voxels */
Voxels_EXPORT VoxelValues
SquaredDistances(const VoxelGrid &                  grid,
                 const std::array<double, 3> &      spacing,
                 const std::vector<unsigned char> & mask,
                 double                             farthest = std::numeric_limits<double>::infinity());
} // namespace shapeton

#endif
