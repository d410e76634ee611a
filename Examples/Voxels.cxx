// Two balls in a volume with slices of 2 mm: finds the components of the mask and the largest ball in each.
// Usage: ExampleVoxels
#include "shapetonSquaredDistances.h"
#include "shapetonVoxelRuns.h"

#include <cmath>
#include <iostream>

int
main()
{
  const shapeton::VoxelGrid   grid(40, 20, 12);
  const std::array<double, 3> spacing{ { 1.0, 1.0, 2.0 } }; // mm
  std::vector<unsigned char>  mask(grid.NumberOfVoxels(), 0);
  for (std::size_t p = 0; p < mask.size(); ++p)
  {
    const auto   v = grid.Voxel(p);
    const double yz = std::hypot(v[1] - 10.0, spacing[2] * (v[2] - 6.0));
    mask[p] = std::hypot(v[0] - 10.0, yz) < 8.0 || std::hypot(v[0] - 30.0, yz) < 5.0;
  }
  const auto set = shapeton::CollectRuns(grid, [&](std::size_t p) { return mask[p] != 0; });
  const auto labels = shapeton::LabelRuns(set); // 1 and 2: voxels that share faces
  const auto squares = shapeton::SquaredDistances(grid, spacing, mask);

  std::vector<int>    voxels(labels.number + 1, 0);
  std::vector<double> radii(labels.number + 1, 0.0);
  shapeton::ForEachRun(set, [&](std::size_t r, int j, int k) {
    const int label = labels.ofRun[r];
    for (int i = set.runs[r].begin; i < set.runs[r].end; ++i)
    {
      ++voxels[label];
      radii[label] = std::max(radii[label], std::sqrt(static_cast<double>(squares[grid.Index(i, j, k)])));
    }
  });
  for (int label = 1; label <= labels.number; ++label)
  {
    std::cout << "component " << label << ": " << voxels[label] << " voxels, a ball of " << radii[label] << " mm\n";
  }
}
