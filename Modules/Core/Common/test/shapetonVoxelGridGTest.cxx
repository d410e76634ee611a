#include "shapetonVoxelGrid.h"

#include "gtest/gtest.h"

#include <cstdlib>

TEST(VoxelGrid, IndicesRunThroughMemoryAndLeadBackToTheirVoxels)
{
  const shapeton::VoxelGrid grid(4, 3, 5);
  std::size_t               index = 0;
  for (int k = 0; k < 5; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int i = 0; i < 4; ++i, ++index)
      {
        EXPECT_EQ(grid.Index(i, j, k), index);
        EXPECT_EQ(grid.Voxel(index), (std::array<int, 3>{ { i, j, k } }));
        EXPECT_EQ(grid.Index(1, 1, 1) + grid.Offset(i - 1, j - 1, k - 1), index);
      }
    }
  }
  EXPECT_EQ(grid.NumberOfVoxels(), index);
}

TEST(VoxelGrid, NeighborsShareAFaceAndLieInTheGrid)
{
  const shapeton::VoxelGrid grid(4, 3, 5);
  std::size_t               pairs = 0;
  for (std::size_t p = 0; p < grid.NumberOfVoxels(); ++p)
  {
    shapeton::ForEachNeighbor(grid, p, [&](std::size_t q) {
      ASSERT_LT(q, grid.NumberOfVoxels());
      int steps = 0;
      for (int a = 0; a < 3; ++a)
      {
        steps += std::abs(grid.Voxel(p)[a] - grid.Voxel(q)[a]);
      }
      EXPECT_EQ(steps, 1);
      ++pairs;
    });
  }
  EXPECT_EQ(pairs, 2U * (3 * 3 * 5 + 4 * 2 * 5 + 4 * 3 * 4));
}

TEST(VoxelGrid, HoldsItsVoxelsAlone)
{
  const shapeton::VoxelGrid grid(2, 2, 2);
  EXPECT_TRUE(grid.Holds(0, 0, 0));
  EXPECT_TRUE(grid.Holds(1, 1, 1));
  EXPECT_FALSE(grid.Holds(-1, 0, 0));
  EXPECT_FALSE(grid.Holds(0, 2, 0));
  EXPECT_TRUE(shapeton::VoxelBox().IsEmpty());
  EXPECT_FALSE((shapeton::VoxelBox{ { { 0, 0, 0 } }, { { 1, 1, 1 } } }.IsEmpty()));
}
