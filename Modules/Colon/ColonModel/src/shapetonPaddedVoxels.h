#ifndef shapetonPaddedVoxels_h
#define shapetonPaddedVoxels_h

#include "shapetonTopologyPreservingGrowth.h"
#include "shapetonVoxelRuns.h"

#include <vector>

namespace shapeton
{
/** Voxel flags padded by a layer of zeros, so that each voxel has 26 neighbors. */
struct PaddedVoxels
{
  VoxelGrid                  grid; ///< including the layer
  std::vector<unsigned char> flags;

  explicit PaddedVoxels(const itk::ImageRegion<3> & region)
    : grid(static_cast<int>(region.GetSize(0)) + 2,
           static_cast<int>(region.GetSize(1)) + 2,
           static_cast<int>(region.GetSize(2)) + 2)
    , flags(grid.NumberOfVoxels(), 0)
  {}

  /** Calls `body(padded index, buffer index)` for each voxel of the image, in parallel over slices. */
  template <typename TBody>
  void
  ForEachVoxel(const TBody & body) const
  {
    const std::int64_t columns = grid.size[0] - 2;
    const std::int64_t rows = grid.size[1] - 2;
    ParallelFor(grid.size[2] - 2, [&](std::size_t z) {
      for (std::int64_t y = 0; y < rows; ++y)
      {
        const auto padded = static_cast<std::int64_t>(grid.Index(1, static_cast<int>(y) + 1, static_cast<int>(z) + 1));
        const auto inner = (static_cast<std::int64_t>(z) * rows + y) * columns;
        for (std::int64_t x = 0; x < columns; ++x)
        {
          body(padded + x, inner + x);
        }
      }
    });
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

/** Components of voxels; runs refer to the padded grid. */
struct VoxelComponents
{
  VoxelRuns                 runs;
  RunLabels                 labels;
  std::vector<std::int64_t> sizes; ///< number of voxels per label; label 0 is unused
};

/** The components of the voxels for which (flags & flag) != 0 equals `isSet`. The padding is included: if `isSet` is
 * false, label 1 is the outside. */
VoxelComponents
FindComponents(const PaddedVoxels & voxels, unsigned char flag, bool isSet, VoxelContact contact);
} // namespace shapeton

#endif
