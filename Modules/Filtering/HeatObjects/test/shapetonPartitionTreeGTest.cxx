#include "shapetonExceptions.h"
#include "shapetonPartitionTree.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <tuple>

using namespace shapeton;

namespace
{
using Index = PartitionTree::Index;
using Region = PartitionTree::Region;

constexpr std::array<double, 3> unit{ { 1.0, 1.0, 1.0 } };

/** Random values, with many ties if `different` is small. */
std::vector<float>
RandomValues(const VoxelGrid & grid, unsigned int different, unsigned int seed)
{
  std::mt19937       random(seed);
  std::vector<float> values(grid.NumberOfVoxels());
  std::generate(values.begin(), values.end(), [&] { return static_cast<float>(random() % different) / 8.0F; });
  return values;
}

/** The voxels of a region, sorted. */
std::vector<Index>
VoxelsOf(const PartitionTree & tree, const Region & region)
{
  std::vector<Index> voxels(tree.GetVoxels().begin() + region.first, tree.GetVoxels().begin() + region.end);
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

/** Area, sum of steps and cut of a set of voxels, by visiting all its faces. */
std::array<double, 3>
MeasureBorder(const std::vector<Index> &    voxels,
              const std::vector<float> &    values,
              const VoxelGrid &             grid,
              const std::array<double, 3> & spacing)
{
  const std::set<Index> inside(voxels.begin(), voxels.end());
  std::array<double, 3> sums{};
  for (const Index voxel : voxels)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double area = spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
      for (const int step : { -1, 1 })
      {
        auto at = grid.Voxel(voxel);
        at[axis] += step;
        if (!grid.Holds(at[0], at[1], at[2]))
        {
          sums[2] += area;
        }
        else if (const auto to = static_cast<Index>(grid.Index(at[0], at[1], at[2])); inside.count(to) == 0)
        {
          sums[0] += area;
          sums[1] += area * std::abs(values[voxel] - values[to]);
        }
      }
    }
  }
  return sums;
}

/** Area and sum of steps of the faces between two sets of voxels. */
std::array<double, 2>
MeasureBorderBetween(const std::vector<Index> & a,
                     const std::vector<Index> & b,
                     const std::vector<float> & values,
                     const VoxelGrid &          grid)
{
  const std::set<Index> inside(b.begin(), b.end());
  std::array<double, 2> sums{};
  for (const Index voxel : a)
  {
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) {
      if (inside.count(static_cast<Index>(neighbor)) > 0)
      {
        sums[0] += 1.0;
        sums[1] += std::abs(values[voxel] - values[neighbor]);
      }
    });
  }
  return sums;
}

/** The two parts of each region after the basins. */
std::vector<std::vector<const Region *>>
PartsOf(const PartitionTree & tree)
{
  std::vector<std::vector<const Region *>> parts(tree.GetRegions().size());
  for (const Region & region : tree.GetRegions())
  {
    if (&region != &tree.GetRegions()[region.parent])
    {
      parts[region.parent].push_back(&region);
    }
  }
  return parts;
}

/** The greatest Dice coefficient of a region with a set of voxels. */
double
BestDice(const PartitionTree & tree, const std::function<bool(std::size_t)> & isInside)
{
  std::vector<double> before{ 0.0 }; // voxels of the set among the first ones of the list
  for (const Index voxel : tree.GetVoxels())
  {
    before.push_back(before.back() + (isInside(voxel) ? 1.0 : 0.0));
  }
  double best = 0.0;
  for (const Region & region : tree.GetRegions())
  {
    best =
      std::max(best, 2.0 * (before[region.end] - before[region.first]) / (region.NumberOfVoxels() + before.back()));
  }
  return best;
}
} // namespace

TEST(PartitionTree, TheStrengthIsTheMeanStepWithAShareOfTheSmallerRegionsBorder)
{
  for (const VoxelGrid & grid : { VoxelGrid(16, 15, 14), VoxelGrid(9, 1, 200), VoxelGrid(300, 3, 2) })
  {
    const auto values = RandomValues(grid, 1U << 20U, 5);
    const auto tree = BuildPartitionTree(values.data(), grid, unit);
    const auto parts = PartsOf(tree);
    for (std::size_t i = (parts.size() + 1) / 2; i < parts.size(); ++i)
    {
      ASSERT_EQ(parts[i].size(), 2U);
      const Region & a = *parts[i][0];
      const Region & b = *parts[i][1];
      const Region & smaller = a.NumberOfVoxels() <= b.NumberOfVoxels() ? a : b;
      const auto [area, steps] = MeasureBorderBetween(VoxelsOf(tree, a), VoxelsOf(tree, b), values, grid);
      ASSERT_GT(area, 0.0);
      const double strength =
        (steps + PartitionTree::NarrowShare * smaller.steps) / (area + PartitionTree::NarrowShare * smaller.border);
      const double expected = std::max({ strength, double{ a.strength }, double{ b.strength } });
      EXPECT_NEAR(tree.GetRegions()[i].strength, expected, 1e-4 * expected);
    }
  }
}

TEST(PartitionTree, BasinsAreConnectedLargeEnoughAndClosedByTheirLargestSteps)
{
  const VoxelGrid          grid(20, 18, 16);
  const std::vector<float> values = RandomValues(grid, 1000, 2);
  const auto               tree = BuildPartitionTree(values.data(), grid, unit);
  std::size_t              voxels = 0;
  for (std::size_t basin = 0; 2 * basin < tree.GetRegions().size(); ++basin)
  {
    const Region & region = tree.GetRegions()[basin];
    EXPECT_GE(region.NumberOfVoxels(), PartitionTree::BasinVoxels);
    std::vector<unsigned char> mask(values.size(), 0);
    FillComponent(
      grid,
      tree.GetVoxels()[region.first],
      [&](std::size_t voxel) { return tree.GetBasinOfVoxel()[voxel] == basin; },
      mask.data());
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), region.NumberOfVoxels());
    voxels += region.NumberOfVoxels();
  }
  EXPECT_EQ(voxels, values.size());
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel) // a voxel joins the neighbor with the smallest step
  {
    float least = std::numeric_limits<float>::max();
    bool  isJoined = false;
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) {
      const float step = std::abs(values[voxel] - values[neighbor]);
      const bool  isSame = tree.GetBasinOfVoxel()[voxel] == tree.GetBasinOfVoxel()[neighbor];
      isJoined = step < least ? isSame : isJoined || (step == least && isSame);
      least = std::min(least, step);
    });
    EXPECT_TRUE(isJoined) << voxel;
  }
}

TEST(PartitionTree, RegionsAreNestedAndTheirBordersMeasured)
{
  const VoxelGrid             grid(14, 13, 12);
  const std::array<double, 3> spacing{ { 0.5, 1.25, 3.0 } };
  for (const unsigned int different : { 1U, 3U, 1U << 20U })
  {
    const auto values = RandomValues(grid, different, different);
    const auto tree = BuildPartitionTree(values.data(), grid, spacing);
    for (const Region & region : tree.GetRegions())
    {
      const Region & parent = tree.GetRegions()[region.parent];
      EXPECT_TRUE(parent.first <= region.first && region.end <= parent.end && region.strength <= parent.strength);
      const auto voxels = VoxelsOf(tree, region);
      const auto [border, steps, cut] = MeasureBorder(voxels, values, grid, spacing);
      EXPECT_NEAR(region.border, border, 1e-9 * (1.0 + border));
      EXPECT_NEAR(region.steps, steps, 1e-5 * (1.0 + steps));
      EXPECT_NEAR(region.cut, cut, 1e-9 * (1.0 + cut));
    }
    const Region & root = tree.GetRegions().back();
    EXPECT_EQ(root.NumberOfVoxels(), values.size());
    EXPECT_EQ(root.parent + 1, tree.GetRegions().size());
    EXPECT_NEAR(root.Contrast(), 0.0, 1e-9);
  }
}

TEST(PartitionTree, AHoleInAnEdgeDoesNotJoinTwoRooms)
{
  const VoxelGrid    grid(41, 20, 20); // a wall of one voxel at 20, with one opening
  std::vector<float> values(grid.NumberOfVoxels());
  std::mt19937       random(1);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    const auto [i, j, k] = grid.Voxel(voxel);
    const bool isWall = i == 20 && !(j == 10 && k == 10);
    values[voxel] = (isWall ? 5.0F : 0.0F) + static_cast<float>(random() % 100) / 1000.0F;
  }
  const auto tree = BuildPartitionTree(values.data(), grid, unit);
  EXPECT_GE(BestDice(tree, [&](std::size_t voxel) { return grid.Voxel(voxel)[0] < 20; }), 0.97);
}

TEST(PartitionTree, BallsInNarrowContactAreTwoRegions)
{
  const VoxelGrid grid(60, 30, 30);
  const auto      isInBall = [&](std::size_t voxel, double center) {
    const auto [i, j, k] = grid.Voxel(voxel);
    return std::hypot(i - center, j - 15.0, k - 15.0) <= 12.0;
  };
  constexpr double   left = 18.3, right = 41.1; // in contact over a disk of radius 3.8
  std::vector<float> values(grid.NumberOfVoxels());
  std::mt19937       random(2);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    values[voxel] =
      (isInBall(voxel, left) || isInBall(voxel, right) ? 1.0F : 0.0F) + static_cast<float>(random() % 100) / 1000.0F;
  }
  const auto tree = BuildPartitionTree(values.data(), grid, unit);
  EXPECT_GE(BestDice(tree, [&](std::size_t voxel) { return isInBall(voxel, left); }), 0.95);
  EXPECT_GE(BestDice(tree, [&](std::size_t voxel) { return isInBall(voxel, right); }), 0.95);
  EXPECT_GE(BestDice(tree, [&](std::size_t voxel) { return isInBall(voxel, left) || isInBall(voxel, right); }), 0.95);
}

TEST(PartitionTree, APlateauBetweenALowerAndAHigherNeighborIsARegion)
{
  const VoxelGrid    grid(40, 30, 30); // neither {value >= t} nor {value <= t} contains the middle third alone
  std::vector<float> values(grid.NumberOfVoxels());
  const auto         isInBar = [&](std::size_t voxel) {
    const auto [i, j, k] = grid.Voxel(voxel);
    return j >= 8 && j < 22 && k >= 8 && k < 22;
  };
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    const int i = grid.Voxel(voxel)[0];
    values[voxel] = !isInBar(voxel) ? -9.0F : i < 14 ? -3.0F : i < 26 ? -1.6F : -0.2F;
  }
  const auto tree = BuildPartitionTree(values.data(), grid, unit);
  EXPECT_DOUBLE_EQ(BestDice(tree, [&](std::size_t voxel) { return values[voxel] == -1.6F; }), 1.0);
}

TEST(PartitionTree, ASingleVoxelAndAConstantVolumeAreOneBasinOrMore)
{
  const float one = 3.0F;
  const auto  single = BuildPartitionTree(&one, VoxelGrid(1, 1, 1), unit);
  ASSERT_EQ(single.GetRegions().size(), 1U);
  EXPECT_EQ(single.GetRegions()[0].end, 1U);
  EXPECT_DOUBLE_EQ(single.GetRegions()[0].cut, 6.0);
  const std::vector<float> constant(1000, 2.0F);
  const auto               tree = BuildPartitionTree(constant.data(), VoxelGrid(10, 10, 10), unit);
  EXPECT_EQ(tree.GetRegions().back().NumberOfVoxels(), 1000U);
  EXPECT_FLOAT_EQ(tree.GetRegions().back().strength, 0.0F);
}

TEST(PartitionTree, TheNumberOfThreadsDoesNotChangeTheResult)
{
  const VoxelGrid grid(33, 31, 70);
  const auto      values = RandomValues(grid, 100, 3);
  basetest::ExpectSameWithAnyThreads([&] {
    const auto         tree = BuildPartitionTree(values.data(), grid, unit);
    std::vector<float> strengths;
    for (const Region & region : tree.GetRegions())
    {
      strengths.push_back(region.strength);
    }
    return std::make_tuple(tree.GetVoxels(), tree.GetBasinOfVoxel(), strengths);
  });
}

TEST(PartitionTree, ABoxAsDomainHasTheTreeOfTheCroppedVolume)
{
  const VoxelGrid            grid(14, 13, 12);
  const VoxelGrid            box(9, 8, 10);
  const auto                 values = RandomValues(grid, 1000, 5);
  std::vector<float>         cropped(box.NumberOfVoxels());
  std::vector<Index>         inVolume(box.NumberOfVoxels());
  std::vector<unsigned char> domain(grid.NumberOfVoxels(), 0);
  for (std::size_t voxel = 0; voxel < cropped.size(); ++voxel)
  {
    const auto place = box.Voxel(voxel);
    inVolume[voxel] = static_cast<Index>(grid.Index(place[0] + 3, place[1] + 2, place[2] + 1));
    cropped[voxel] = values[inVolume[voxel]];
    domain[inVolume[voxel]] = 1;
  }
  const std::array<double, 3> spacing{ { 1.0, 1.5, 2.0 } };
  const auto                  whole = BuildPartitionTree(values.data(), grid, spacing, domain.data());
  const auto                  part = BuildPartitionTree(cropped.data(), box, spacing);
  ASSERT_EQ(whole.GetRegions().size(), part.GetRegions().size());
  ASSERT_EQ(whole.GetVoxels().size(), part.GetVoxels().size());
  for (std::size_t i = 0; i < part.GetVoxels().size(); ++i)
  {
    ASSERT_EQ(whole.GetVoxels()[i], inVolume[part.GetVoxels()[i]]);
  }
  for (std::size_t region = 0; region < part.GetRegions().size(); ++region)
  {
    const Region & a = whole.GetRegions()[region];
    const Region & b = part.GetRegions()[region];
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_EQ(a.strength, b.strength);
    EXPECT_EQ(a.border, b.border);
    EXPECT_EQ(a.cut, b.cut);
  }
  EXPECT_EQ(std::count(whole.GetBasinOfVoxel().begin(), whole.GetBasinOfVoxel().end(), PartitionTree::NoBasin),
            static_cast<std::ptrdiff_t>(values.size() - cropped.size()));
}

TEST(PartitionTree, PartsOfADomainAreJoinedLast)
{
  const VoxelGrid            grid(30, 8, 8);
  const auto                 values = RandomValues(grid, 1000, 6);
  std::vector<unsigned char> domain(values.size(), 1);
  for (std::size_t voxel = 0; voxel < domain.size(); ++voxel)
  {
    domain[voxel] = grid.Voxel(voxel)[0] == 10 ? 0 : 1; // a plane between two parts
  }
  const auto     tree = BuildPartitionTree(values.data(), grid, unit, domain.data());
  const Region & root = tree.GetRegions().back();
  EXPECT_EQ(root.NumberOfVoxels(), 29U * 8U * 8U);
  EXPECT_EQ(root.border, 0.0);
  EXPECT_EQ(root.strength, std::numeric_limits<float>::max());
  std::set<Index> parts;
  for (const Region & region : tree.GetRegions())
  {
    if (tree.GetRegions()[region.parent].parent + 1 == tree.GetRegions().size() && region.border == 0.0)
    {
      parts.insert(region.NumberOfVoxels());
    }
  }
  EXPECT_EQ(parts, (std::set<Index>{ 10U * 8U * 8U, 19U * 8U * 8U, 29U * 8U * 8U }));
}

TEST(PartitionTree, RejectsUnsuitableInput)
{
  const std::vector<unsigned char> nothing(8, 0);
  EXPECT_THROW(BuildPartitionTree(std::vector<float>(8, 1.0F).data(), VoxelGrid(2, 2, 2), unit, nothing.data()),
               InputError);
  std::vector<float> values(8, 1.0F);
  EXPECT_THROW(BuildPartitionTree(values.data(), VoxelGrid(0, 2, 2), unit), ParameterError);
  EXPECT_THROW(BuildPartitionTree(values.data(), VoxelGrid(2, 2, 2), { { 1.0, 0.0, 1.0 } }), InputError);
  values[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(BuildPartitionTree(values.data(), VoxelGrid(2, 2, 2), unit), InputError);
}
