#ifndef shapetonPaddedVoxels_h
#define shapetonPaddedVoxels_h

#include "shapetonTopologyPreservingGrowth.h"

#include <algorithm>
#include <vector>

namespace shapeton
{
/** Flags of voxels with a layer of zeros around, so that each voxel has 26 neighbours. */
struct PaddedVoxels
{
  std::int64_t               nx, ny, nz; ///< with the layer
  std::vector<unsigned char> flags;

  explicit PaddedVoxels(const itk::ImageRegion<3> & region)
    : nx(static_cast<std::int64_t>(region.GetSize(0)) + 2)
    , ny(static_cast<std::int64_t>(region.GetSize(1)) + 2)
    , nz(static_cast<std::int64_t>(region.GetSize(2)) + 2)
    , flags(static_cast<std::size_t>(nx * ny * nz), 0)
  {}

  std::int64_t
  Index(std::int64_t x, std::int64_t y, std::int64_t z) const
  {
    return (z * ny + y) * nx + x;
  }

  /** Calls `body(padded index, index in the image's buffer)` for each voxel of the image, in order. */
  template <typename TBody>
  void
  ForEachVoxel(const TBody & body) const
  {
    std::int64_t inner = 0;
    for (std::int64_t z = 1; z + 1 < nz; ++z)
    {
      for (std::int64_t y = 1; y + 1 < ny; ++y)
      {
        const std::int64_t row = this->Index(0, y, z);
        for (std::int64_t x = 1; x + 1 < nx; ++x)
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

/** Components of voxels, as runs along x. */
struct VoxelRuns
{
  struct Run
  {
    std::int64_t first, last; ///< padded indices, both included
    int          component;   ///< from 0 on, in the order of their first voxels
  };
  std::vector<Run>          runs;
  std::vector<std::int64_t> sizes; ///< voxels of each component
};

/** The components of the voxels where (flags & flag) != 0 equals `isSet`; connected by faces, or by faces and edges.
 * The layer of padding takes part: with `isSet` false, component 0 is the outside. */
VoxelRuns
FindVoxelRuns(const PaddedVoxels & voxels, unsigned char flag, bool isSet, bool throughEdges);
} // namespace shapeton

#endif
