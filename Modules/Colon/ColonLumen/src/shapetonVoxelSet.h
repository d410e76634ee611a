#ifndef shapetonVoxelSet_h
#define shapetonVoxelSet_h

#include "shapetonColonVolume.h"

#include <functional>
#include <unordered_map>

namespace shapeton
{
/** Indices of voxels, ascending: a small part of a large grid. */
using VoxelSet = std::vector<std::size_t>;

/** Whether `holds(index, squared distance in mm^2)` for each voxel of the box that reaches `reach` mm to each side of
 * this one; stops at the first one for which it does not. */
template <typename THolds>
bool
ForAllWithin(const ColonGrid & grid, std::size_t voxel, double reach, const THolds & holds)
{
  const auto v = grid.Voxel(voxel);
  const auto box = grid.Widened({ v, { { v[0] + 1, v[1] + 1, v[2] + 1 } } }, reach);
  for (int k = box.low[2]; k < box.high[2]; ++k)
  {
    for (int j = box.low[1]; j < box.high[1]; ++j)
    {
      for (int i = box.low[0]; i < box.high[0]; ++i)
      {
        const Eigen::Vector3d d = Eigen::Vector3d(i - v[0], j - v[1], k - v[2]).cwiseProduct(grid.spacing);
        if (!holds(grid.Index(i, j, k), d.squaredNorm()))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/** Parts of a set: voxels without an entry are one more part. */
using VoxelParts = std::unordered_map<std::size_t, int>;

/** The pieces whose voxels are joined by faces, in the order of their first voxels; each one in the order in which it
 * is reached. Voxels join only those of their own part. */
std::vector<std::vector<std::size_t>>
ConnectedPieces(const ColonGrid & grid, const VoxelSet & voxels, const VoxelParts & parts = {});

/** Cuts a set at its necks, where no ball of this radius (mm) fits that holds nothing but the set and what is `isOpen`:
 * for each voxel the number, from 1, of the wide part that is the next within the set. None where there is no wide
 * part. */
VoxelParts
PartsAtNecks(const ColonGrid &                        grid,
             const VoxelSet &                         voxels,
             double                                   radius,
             const std::function<bool(std::size_t)> & isOpen);
} // namespace shapeton

#endif
