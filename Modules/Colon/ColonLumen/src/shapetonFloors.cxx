#include "shapetonFloors.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** The half-height below one gas voxel, found within three steps; false where the gas goes on or the grid ends. */
bool
FloorBelow(const ColonGrid &          grid,
           const std::vector<float> & hu,
           std::size_t                voxel,
           const Fall &               fall,
           double                     half,
           float &                    depth)
{
  const auto v = grid.Voxel(voxel);
  float      above = hu[voxel];
  for (int t = 1; t <= 3; ++t)
  {
    const auto o = fall.Offset(t);
    if (!grid.Holds(v[0] + o[0], v[1] + o[1], v[2] + o[2]))
    {
      return false;
    }
    const float value = hu[grid.Index(v[0] + o[0], v[1] + o[1], v[2] + o[2])];
    if (value >= half)
    {
      const double part = (half - above) / std::max(1.0F, value - above);
      depth = static_cast<float>(grid.Position(voxel).dot(fall.direction) + (t - 1 + part) * fall.step);
      return true;
    }
    above = value;
  }
  return false;
}
} // namespace

std::vector<Floor>
FloorsOfGas(const ColonGrid &          grid,
            const std::vector<float> & hu,
            const VoxelRuns &          gas,
            const RunLabels &          pieces,
            const std::vector<char> &  use,
            const Fall &               fall,
            const ColonThresholds &    thresholds)
{
  std::vector<Floor> floors;
  const auto         down = fall.Offset(1);
  ForEachRun(gas, [&](std::size_t r, int j, int k) {
    if (!use[pieces.ofRun[r]])
    {
      return;
    }
    for (int i = gas.runs[r].begin; i < gas.runs[r].end; ++i)
    {
      float      depth = 0.0F;
      const auto voxel = grid.Index(i, j, k);
      if (grid.Holds(i + down[0], j + down[1], k + down[2]) &&
          hu[grid.Index(i + down[0], j + down[1], k + down[2])] >= thresholds.gasSeed &&
          FloorBelow(grid, hu, voxel, fall, thresholds.gasBoundary, depth))
      {
        floors.push_back({ voxel, pieces.ofRun[r], depth });
      }
    }
  });
  return floors;
}
} // namespace shapeton
