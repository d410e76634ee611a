#ifndef shapetonPaddedVoxels_h
#define shapetonPaddedVoxels_h

#include "shapetonTopologyPreservingGrowth.h"
#include "shapetonVoxelRuns.h"

#include <vector>

namespace shapeton
{
/** Flags of voxels with a layer of zeros around, so that each voxel has 26 neighbours. */
struct PaddedVoxels
{
  VoxelGrid                  grid; ///< with the layer
  std::vector<unsigned char> flags;

  explicit PaddedVoxels(const itk::ImageRegion<3> & region)
    : grid(static_cast<int>(region.GetSize(0)) + 2,
           static_cast<int>(region.GetSize(1)) + 2,
           static_cast<int>(region.GetSize(2)) + 2)
    , flags(grid.NumberOfVoxels(), 0)
  {}

  /** Calls `body(padded index, index in the image's buffer)` for each voxel of the image, in order. */
  template <typename TBody>
  void
  ForEachVoxel(const TBody & body) const
  {
    std::int64_t inner = 0;
    for (int z = 1; z + 1 < grid.size[2]; ++z)
    {
      for (int y = 1; y + 1 < grid.size[1]; ++y)
      {
        const auto row = static_cast<std::int64_t>(grid.Index(0, y, z));
        for (int x = 1; x + 1 < grid.size[0]; ++x)
        {
          body(row + x, inner++);
        }
      }
    }
  }

  void
  SetFlag(const LumenMaskImage * mask, unsigned char flag)
  {
    const unsigned char * values = mask->GetBufferPointer();
    this->ForEachVoxel([&](std::int64_t padded, std::int64_t inner) {
      flags[padded] = static_cast<unsigned char>(flags[padded] | (values[inner] != 0 ? flag : 0));
    });
  }
};

/** Components of voxels; runs are those of the padded grid. */
struct VoxelComponents
{
  VoxelRuns                 runs;
  RunLabels                 labels;
  std::vector<std::int64_t> sizes; ///< voxels of each label; 0 for the label 0, which no run has
};

/** The components of the voxels where (flags & flag) != 0 equals `isSet`. The layer of padding takes part: with `isSet`
 * false, the label 1 is the outside. */
VoxelComponents
FindComponents(const PaddedVoxels & voxels, unsigned char flag, bool isSet, VoxelContact contact);
} // namespace shapeton

#endif
