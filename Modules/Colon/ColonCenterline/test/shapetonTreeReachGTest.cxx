#include "shapetonTreeReach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace shapeton
{
namespace
{
struct Edge
{
  int    a, b;
  double length;
};

/** A random tree with core cells. */
struct Tree
{
  std::vector<Edge> edges;
  std::vector<char> isCore;
};

Tree
RandomTree(int cells, double coreShare, unsigned seed)
{
  std::mt19937                           random(seed);
  std::uniform_real_distribution<double> uniform;
  Tree                                   tree;
  for (int cell = 0; cell < cells; ++cell)
  {
    tree.isCore.push_back(uniform(random) < coreShare ? 1 : 0);
    if (cell > 0)
    {
      // Long paths with short branches, and some stars.
      const int nearest = std::max(0, cell - 1 - static_cast<int>(4.0 * uniform(random)));
      const int parent = uniform(random) < 0.8 ? nearest : cell / 3;
      tree.edges.push_back({ parent, cell, 1.0 + 9.0 * uniform(random) });
    }
  }
  return tree;
}

TreeLinks
LinksOf(const Tree & tree)
{
  TreeLinks links(tree.isCore.size());
  for (int i = 0; i < static_cast<int>(tree.edges.size()); ++i)
  {
    const Edge & edge = tree.edges[i];
    links[edge.a].push_back({ edge.b, i, edge.length });
    links[edge.b].push_back({ edge.a, i, edge.length });
  }
  return links;
}

TreeWalk
WalkFrom(const TreeLinks & links, int start)
{
  TreeWalk walk(links.size());
  walk.Visit(links, start);
  return walk;
}

/** Reference result, found by a search from each core cell. */
double
LongestWay(const Tree & tree)
{
  const TreeLinks links = LinksOf(tree);
  double          longest = 0.0;
  for (int start = 0; start < static_cast<int>(links.size()); ++start)
  {
    if (tree.isCore[start])
    {
      const TreeWalk walk = WalkFrom(links, start);
      for (const int cell : walk.order)
      {
        longest = std::max(longest, tree.isCore[cell] ? walk.length[cell] : 0.0);
      }
    }
  }
  return longest;
}

/** The path from a cell back to the start of a walk. */
TreeRing
RingTo(const TreeWalk & walk, int cell)
{
  TreeRing ring{ { cell }, {}, {} };
  for (; walk.parent[cell] >= 0; cell = walk.parent[cell])
  {
    ring.cells.push_back(walk.parent[cell]);
    ring.passages.push_back(walk.passage[cell]);
    ring.lengths.push_back(walk.length[cell] - walk.length[walk.parent[cell]]);
  }
  return ring;
}

/** Compares the longest paths after each swap on the path between two cells with those found by brute force. */
void
ExpectWays(const Tree & tree, int from, int to)
{
  const TreeLinks links = LinksOf(tree);
  const TreeWalk  all = WalkFrom(links, 0);
  const TreeReach reach(links, all, tree.isCore);
  const TreeRing  ring = RingTo(WalkFrom(links, to), from);
  const auto      ways = reach.LongestWaysWithout(ring, 2.5);
  ASSERT_EQ(ways.size(), ring.passages.size());
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    Tree exchanged = tree;
    exchanged.edges[ring.passages[i]] = { from, to, 2.5 };
    EXPECT_NEAR(ways[i], LongestWay(exchanged), 1e-9) << "from " << from << " to " << to << ", passage " << i;
  }
}
} // namespace

TEST(TreeReach, LongestWayIsThatOfBruteForceFromEachCell)
{
  for (const double share : { 0.0, 0.05, 0.5, 1.0 })
  {
    const Tree      tree = RandomTree(80, share, 7);
    const TreeLinks links = LinksOf(tree);
    const TreeWalk  all = WalkFrom(links, 0);
    const TreeReach reach(links, all, tree.isCore);
    const double    longest = LongestWay(tree);
    EXPECT_EQ(longest > 0.0, share > 0.0);
    for (int cell = 0; cell < 80; ++cell)
    {
      EXPECT_NEAR(reach.LongestWay(cell), longest, 1e-9);
    }
  }
}

TEST(TreeReach, ExchangedPassagesGiveTheLongestWayOfBruteForce)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const Tree tree = RandomTree(60, seed % 2 == 0 ? 0.3 : 0.9, seed);
    ExpectWays(tree, 59, 0);
    ExpectWays(tree, 59, 30);
    ExpectWays(tree, 12, 57);
  }
}
} // namespace shapeton
