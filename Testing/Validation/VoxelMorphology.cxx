#include "VoxelMorphology.h"

#include "shapetonParallelFor.h"

using namespace shapeton;

namespace
{
/** A voxel of the result has this value if it or a face neighbor has. */
VoxelMask
Spread(const VoxelMask & mask, const VoxelGrid & grid, unsigned char value)
{
  VoxelMask result(mask);
  ParallelForBlocks(mask.size(), [&](std::size_t voxel) {
    ForEachNeighbor(
      grid, voxel, [&](std::size_t neighbor) { result[voxel] = mask[neighbor] == value ? value : result[voxel]; });
  });
  return result;
}
} // namespace

VoxelMask
Eroded(VoxelMask mask, const VoxelGrid & grid, int times)
{
  for (; times > 0; --times)
  {
    mask = Spread(mask, grid, 0);
  }
  return mask;
}

VoxelMask
Dilated(const VoxelMask & mask, const VoxelGrid & grid)
{
  return Spread(mask, grid, 1);
}
