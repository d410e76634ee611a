#include "shapetonSquaredDistances.h"
#include "shapetonTestThreads.h"

#include "gtest/gtest.h"

#include <random>

namespace
{
using shapeton::VoxelGrid;

std::vector<unsigned char>
RandomMask(std::size_t voxels, double share)
{
  std::mt19937               random(5);
  std::vector<unsigned char> mask(voxels);
  for (auto & voxel : mask)
  {
    voxel = random() < share * 4294967296.0 ? 1 : 0;
  }
  return mask;
}

double
BruteForce(const VoxelGrid &                  grid,
           const std::array<double, 3> &      spacing,
           const std::vector<unsigned char> & mask,
           std::size_t                        p)
{
  double least = shapeton::UnknownSquaredDistance;
  for (std::size_t q = 0; q < mask.size(); ++q)
  {
    double square = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const double d = spacing[a] * (grid.Voxel(p)[a] - grid.Voxel(q)[a]);
      square += d * d;
    }
    least = mask[q] == 0 ? std::min(least, square) : least;
  }
  return least;
}
} // namespace

TEST(SquaredDistances, AreThoseOfBruteForceOnUnequalSpacing)
{
  const VoxelGrid             grid(19, 11, 9);
  const std::array<double, 3> spacing{ { 0.7, 0.9, 1.3 } };
  for (const double share : { 0.5, 0.95, 0.999 })
  {
    const auto mask = RandomMask(grid.NumberOfVoxels(), share);
    const auto squares = shapeton::SquaredDistances(grid, spacing, mask);
    for (std::size_t p = 0; p < mask.size(); ++p)
    {
      const double expected = BruteForce(grid, spacing, mask, p);
      ASSERT_NEAR(squares[p], expected, 1e-6 * expected);
    }
  }
}

TEST(SquaredDistances, OfAPartAreThoseOfThePartAlone)
{
  const VoxelGrid            whole(12, 10, 8);
  const VoxelGrid            part(7, 6, 5);
  const auto                 mask = RandomMask(whole.NumberOfVoxels(), 0.9);
  std::vector<unsigned char> copy(part.NumberOfVoxels());
  for (std::size_t p = 0; p < copy.size(); ++p)
  {
    const auto v = part.Voxel(p);
    copy[p] = mask[whole.Index(v[0] + 2, v[1] + 3, v[2] + 1)];
  }
  shapeton::VoxelValues squares(part.NumberOfVoxels());
  shapeton::SquaredDistances(
    { &mask[whole.Index(2, 3, 1)], whole.stride[1], whole.stride[2] }, part, { { 1.0, 1.0, 2.0 } }, squares.data());
  EXPECT_EQ(squares, shapeton::SquaredDistances(part, { { 1.0, 1.0, 2.0 } }, copy));
}

TEST(SquaredDistances, AreUnknownBeyondTheFarthestThatIsAskedFor)
{
  const VoxelGrid             grid(40, 30, 20);
  const std::array<double, 3> spacing{ { 0.7, 0.9, 1.3 } };
  const auto                  mask = RandomMask(grid.NumberOfVoxels(), 0.998);
  const auto                  all = shapeton::SquaredDistances(grid, spacing, mask);
  for (const double farthest : { 0.0, 0.7, 2.8, 4.0 })
  {
    const auto  near = shapeton::SquaredDistances(grid, spacing, mask, farthest);
    std::size_t found = 0;
    for (std::size_t p = 0; p < mask.size(); ++p)
    {
      const bool isFound = all[p] <= static_cast<float>(farthest * farthest);
      found += isFound;
      ASSERT_EQ(near[p], isFound ? all[p] : shapeton::UnknownSquaredDistance);
    }
    EXPECT_GT(found, 0U);
    EXPECT_LT(found, mask.size());
  }
}

TEST(SquaredDistances, AreUnknownWithoutBackground)
{
  const VoxelGrid grid(3, 4, 5);
  const auto      squares = shapeton::SquaredDistances(grid, { { 1.0, 1.0, 1.0 } }, std::vector<unsigned char>(60, 1));
  EXPECT_EQ(squares, shapeton::VoxelValues(60, shapeton::UnknownSquaredDistance));
}

TEST(SquaredDistances, HaveTheSameBytesForAnyNumberOfThreads)
{
  const VoxelGrid grid(40, 30, 20);
  const auto      mask = RandomMask(grid.NumberOfVoxels(), 0.99);
  basetest::ExpectSameWithAnyThreads([&] { return shapeton::SquaredDistances(grid, { { 0.8, 0.8, 1.0 } }, mask); });
}
