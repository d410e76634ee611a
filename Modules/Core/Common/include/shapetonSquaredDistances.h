#ifndef shapetonSquaredDistances_h
#define shapetonSquaredDistances_h

#include "shapetonVoxelGrid.h"
#include "shapetonVoxelValues.h"
#include "ShapetonCommonExport.h"

#include <limits>
#include <vector>

namespace shapeton
{
/** Value of SquaredDistances() (mm^2) if there is no voxel outside the mask, or none within `farthest`.
 * \ingroup ShapetonCommon */
constexpr float UnknownSquaredDistance = 1e12F;

/** A box of mask voxels in a larger volume; the first axis is contiguous. \ingroup ShapetonCommon */
struct VoxelRows
{
  const unsigned char * first;
  /** Offset from one row to the next, and from one slice to the next, in voxels. */
  std::size_t rowStride;
  std::size_t sliceStride;
};

/** Exact squared distance in mm^2 between the centers of each mask voxel (not 0) and the nearest voxel outside the
 * mask; 0 outside the mask. Voxels beyond the box are ignored.
 *
 * Lower envelopes of parabolas, line by line (Felzenszwalb, Huttenlocher: Distance transforms of sampled functions,
 * Theory of Computing 8, 2012): linear time; the values do not depend on the number of threads.
 *
 * \param box the voxels of the box; `squares` has the same size and order.
 * \param farthest mm; larger distances are not computed. A small value reduces the run time.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void
SquaredDistances(const VoxelRows &             mask,
                 const VoxelGrid &             box,
                 const std::array<double, 3> & spacing,
                 float *                       squares,
                 double                        farthest = std::numeric_limits<double>::infinity());

/** Overload for a mask on a grid. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT VoxelValues
SquaredDistances(const VoxelGrid &                  grid,
                 const std::array<double, 3> &      spacing,
                 const std::vector<unsigned char> & mask,
                 double                             farthest = std::numeric_limits<double>::infinity());
} // namespace shapeton

#endif
