#include "shapetonPaddedVoxels.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace shapeton
{
namespace
{
/** Contribution of a cube of 2 x 2 x 2 voxels (bit x + 2 y + 4 z) to eight times the Euler number. The object is a cell
 * complex: voxels are vertices, face pairs are edges, full squares and full cubes are cells. The background is not
 * connected through corners, so the ring of six voxels around two opposite background voxels is also filled. */
int
EightfoldEulerNumber(unsigned int cube)
{
  constexpr unsigned int all = 0xFF; // the eight voxels of a cube
  const auto             has = [cube](unsigned int voxels) { return (cube & voxels) == voxels; };
  int                    eightfold = cube == all ? -8 : 0;
  for (unsigned int i = 0; i < 8; ++i)
  {
    eightfold += has(1U << i) ? 1 : 0; // a voxel is in eight cubes
    eightfold += i < 4 && cube == (all & ~(1U << i) & ~(0x80U >> i)) ? 8 : 0;
  }
  for (unsigned int a = 1; a < 8; a <<= 1)
  {
    const unsigned int b = a == 4 ? 1 : a << 1;
    const unsigned int c = 7 - a - b;
    for (const unsigned int i : { 0U, b, c, b + c })
    {
      eightfold -= has(1U << i | 1U << (i + a)) ? 2 : 0; // an edge in four
    }
    for (const unsigned int i : { 0U, c })
    {
      eightfold += has(1U << i | 1U << (i + a) | 1U << (i + b) | 1U << (i + a + b)) ? 4 : 0; // a square in two
    }
  }
  return eightfold;
}

std::int64_t
EulerNumber(const PaddedVoxels & voxels)
{
  std::array<int, 256> table;
  for (unsigned int cube = 0; cube < 256; ++cube)
  {
    table[cube] = EightfoldEulerNumber(cube);
  }
  const auto &              flags = voxels.flags;
  const std::size_t         row = voxels.grid.stride[1];
  const std::size_t         slice = voxels.grid.stride[2];
  std::vector<std::int64_t> ofSlice(voxels.grid.size[2], 0);
  ParallelFor(ofSlice.size(), [&](std::size_t z) {
    const auto column = [&](std::size_t k) {
      return static_cast<unsigned int>(flags[k] | flags[k + row] << 2 | flags[k + slice] << 4 |
                                       flags[k + slice + row] << 6);
    };
    const std::size_t end = std::min((z + 1) * slice, flags.size() - std::min(flags.size(), slice + row + 1));
    unsigned int      left = z * slice < end ? column(z * slice) : 0;
    for (std::size_t i = z * slice; i < end; ++i)
    {
      const unsigned int right = column(i + 1);
      ofSlice[z] += table[left | right << 1];
      left = right;
    }
  });
  return std::accumulate(ofSlice.begin(), ofSlice.end(), std::int64_t{ 0 }) / 8;
}
} // namespace

MaskTopology
TopologyOfMask(const LumenMaskImage * mask)
{
  PaddedVoxels voxels(mask->GetBufferedRegion());
  voxels.SetFlag(mask, 1);
  MaskTopology          topology;
  const VoxelComponents object = FindComponents(voxels, 1, true, VoxelContact::Face);
  for (const std::int64_t size : object.sizes)
  {
    topology.voxels += size;
  }
  topology.components = object.labels.number;
  topology.cavities = FindComponents(voxels, 1, false, VoxelContact::FaceOrEdge).labels.number - 1;
  topology.eulerNumber = EulerNumber(voxels);
  topology.handles = topology.components + topology.cavities - topology.eulerNumber;
  return topology;
}
} // namespace shapeton
