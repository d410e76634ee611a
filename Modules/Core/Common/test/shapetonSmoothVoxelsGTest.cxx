#include "shapetonSmoothVoxels.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

using namespace shapeton;

TEST(SmoothVoxels, SpreadsAPointByTheVariancesOfTheAxes)
{
  const VoxelGrid             grid(31, 33, 35);
  const std::array<double, 3> sigmas = { 1.5, 2.0, 0.0 };
  std::vector<float>          values(grid.NumberOfVoxels(), 0.0F);
  values[grid.Index(15, 16, 17)] = 1000.0F;
  SmoothVoxels(grid, sigmas, values.data());
  EXPECT_NEAR(std::accumulate(values.begin(), values.end(), 0.0), 1000.0, 1e-3);
  std::array<double, 3> variances{};
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto voxel = grid.Voxel(i);
    for (int a = 0; a < 3; ++a)
    {
      variances[a] += values[i] / 1000.0 * (voxel[a] - 15 - a) * (voxel[a] - 15 - a);
    }
  }
  EXPECT_NEAR(variances[0], 2.25, 0.05); // cut off at three standard deviations
  EXPECT_NEAR(variances[1], 4.0, 0.1);
  EXPECT_EQ(variances[2], 0.0);
}

TEST(SmoothVoxels, KeepsAConstantUpToTheBorder)
{
  const VoxelGrid    grid(5, 4, 3);
  std::vector<float> values(grid.NumberOfVoxels(), 7.0F);
  SmoothVoxels(grid, { 1.0, 1.0, 1.0 }, values.data());
  for (const float value : values)
  {
    EXPECT_NEAR(value, 7.0F, 1e-5F);
  }
}
