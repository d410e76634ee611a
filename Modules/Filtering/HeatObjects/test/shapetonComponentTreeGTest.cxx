#include "shapetonComponentTree.h"
#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <tuple>

using namespace shapeton;

namespace
{
using Index = ComponentTree::Index;

/** Random values, with many ties if `different` is small. */
std::vector<float>
RandomValues(const VoxelGrid & grid, int different, unsigned int seed)
{
  std::mt19937       random(seed);
  std::vector<float> values(grid.NumberOfVoxels());
  for (float & value : values)
  {
    value = static_cast<float>(static_cast<int>(random() % different) - different / 2);
  }
  return values;
}

/** The sorted region of a voxel, by flooding: voxels connected to it by values >= its own (<= if `sign` is -1). */
std::vector<Index>
Flood(const std::vector<float> & values, const VoxelGrid & grid, std::size_t voxel, float sign)
{
  std::vector<char>        isFound(values.size(), 0);
  std::vector<std::size_t> open{ voxel };
  isFound[voxel] = 1;
  while (!open.empty())
  {
    const std::size_t next = open.back();
    open.pop_back();
    ForEachNeighbor(grid, next, [&](std::size_t neighbor) {
      if (!isFound[neighbor] && sign * values[neighbor] >= sign * values[voxel])
      {
        isFound[neighbor] = 1;
        open.push_back(neighbor);
      }
    });
  }
  std::vector<Index> found;
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    if (isFound[v])
    {
      found.push_back(static_cast<Index>(v));
    }
  }
  return found;
}

/** The same from the tree. */
std::vector<Index>
Region(const ComponentTree & tree, const std::vector<float> & values, std::size_t voxel)
{
  const auto & voxels = tree.GetVoxels();
  const auto * arc = &tree.GetArcs()[tree.GetArcOfVoxel()[voxel]];
  Index        end = arc->begin;
  while (voxels[end] != voxel)
  {
    ++end;
  }
  for (;;)
  {
    while (end < arc->end && values[voxels[end]] == values[voxel])
    {
      ++end;
    }
    const auto & parent = tree.GetArcs()[arc->parent];
    if (end < arc->end || &parent == arc || values[voxels[parent.begin]] != values[voxel])
    {
      break;
    }
    arc = &parent;
    end = arc->begin;
  }
  std::vector<Index> region(voxels.begin() + arc->first, voxels.begin() + end);
  std::sort(region.begin(), region.end());
  return region;
}

void
ExpectRegionsOf(const ComponentTree & tree, const std::vector<float> & values, const VoxelGrid & grid, float sign)
{
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    ASSERT_EQ(Region(tree, values, voxel), Flood(values, grid, voxel, sign)) << voxel;
  }
}
} // namespace

TEST(ComponentTree, RegionsEqualFloodingOfAllThresholds)
{
  unsigned int seed = 0;
  for (const VoxelGrid & grid : { VoxelGrid(9, 8, 7), VoxelGrid(5, 1, 80), VoxelGrid(1, 1, 1), VoxelGrid(40, 3, 1) })
  {
    for (const int different : { 1, 2, 5, 1000 })
    {
      const auto values = RandomValues(grid, different, ++seed);
      const auto trees = BuildComponentTrees(values.data(), grid);
      ExpectRegionsOf(trees.maxTree, values, grid, 1.0F);
      ExpectRegionsOf(trees.minTree, values, grid, -1.0F);
    }
  }
}

TEST(ComponentTree, TwoHillsJoinAtTheirSaddle)
{
  const std::vector<float> values{ 1, 5, 4, 2, 3, 1 };
  const auto               tree = BuildComponentTrees(values.data(), VoxelGrid(6, 1, 1)).maxTree;
  ASSERT_EQ(tree.GetArcs().size(), 3U);
  EXPECT_EQ(tree.GetArcs()[0].parent, 2U);
  EXPECT_EQ(tree.GetArcs()[1].parent, 2U);
  EXPECT_EQ(tree.GetArcs()[2].parent, 2U);
  const auto & root = tree.GetArcs()[2];
  EXPECT_EQ(root.first, 0U);
  EXPECT_EQ(tree.GetVoxels()[root.begin], 3U); // the saddle
  EXPECT_EQ(root.end, 6U);
}

TEST(ComponentTree, NegatedValuesExchangeTheTrees)
{
  const VoxelGrid    grid(12, 10, 11);
  std::vector<float> values = RandomValues(grid, 1 << 30, 7); // practically no ties
  const auto         minTree = BuildComponentTrees(values.data(), grid).minTree;
  for (float & value : values)
  {
    value = -value;
  }
  EXPECT_EQ(BuildComponentTrees(values.data(), grid).maxTree.GetArcs().size(), minTree.GetArcs().size());
}

TEST(ComponentTree, TheNumberOfThreadsDoesNotChangeTheResult)
{
  const VoxelGrid grid(33, 31, 70);
  const auto      values = RandomValues(grid, 100, 3);
  basetest::ExpectSameWithAnyThreads([&] {
    const auto trees = BuildComponentTrees(values.data(), grid);
    return std::make_tuple(trees.maxTree.GetVoxels(), trees.minTree.GetVoxels(), trees.maxTree.GetArcOfVoxel());
  });
}

TEST(ComponentTree, RejectsValuesThatAreNotNumbers)
{
  std::vector<float> values(8, 1.0F);
  values[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(BuildComponentTrees(values.data(), VoxelGrid(2, 2, 2)), InputError);
  EXPECT_THROW(BuildComponentTrees(values.data(), VoxelGrid(0, 2, 2)), ParameterError);
}
