#include "itkCarriedPacking.h"

#include "itkCarriedRotation.h"
#include "itkGraphFamilies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{
/** The edges of a grid that are marked; every other square is large where most of them are. */
itk::Graph
PartOfGrid(const std::vector<char> & isThere)
{
  const itk::Graph grid = itk::GridGraph(12, 10);
  itk::Graph       part{ grid.nodes, {}, {} };
  for (std::size_t e = 0; e < grid.edges.size(); ++e)
  {
    if (isThere[e])
    {
      part.edges.push_back(grid.edges[e]);
    }
  }
  return part;
}

/** Packable, and without the dummies the map is left, each order but where a component of its own lies. */
void
ExpectPackedMapOf(const itk::PackedMap & packed, const itk::CombinatorialMap & map)
{
  EXPECT_EQ(packed.map.Components(), 1);
  EXPECT_EQ(packed.map.Genus(), map.Genus());
  EXPECT_EQ(itk::FaceConflicts(packed.map).reason, "");
  ASSERT_EQ(packed.graphNodes, map.Nodes());
  ASSERT_EQ(packed.graphEdges, map.Edges());
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    EXPECT_EQ(packed.map.Node(h), map.Node(h));
    int next = packed.map.NextAround(h);
    while (next >= map.HalfEdges())
    {
      next = packed.map.NextAround(next);
    }
    EXPECT_EQ(next, map.NextAround(h));
  }
}

/** Nodes of the graph around which nothing has changed, dummies included. */
int
NodesAsBefore(const itk::PackedMap & a, const itk::PackedMap & b)
{
  const auto degreesAround = [](const itk::PackedMap & packed, int node) {
    std::vector<int>       list;
    const std::vector<int> degrees = packed.map.Degrees();
    for (const int h : packed.map.Around(node))
    {
      list.push_back(degrees[packed.map.Node(h ^ 1)]);
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  int same = 0;
  for (int node = 0; node < a.graphNodes; ++node)
  {
    same += degreesAround(a, node) == degreesAround(b, node) ? 1 : 0;
  }
  return same;
}

/** A ring of `length` nodes with a tail, so that its two faces are filled with rings of dummies. */
itk::Graph
RingWithTail(int length)
{
  itk::Graph graph = itk::CycleGraph(length);
  graph.nodes += 1;
  graph.edges.push_back({ 0, length });
  return graph;
}
} // namespace

TEST(CarriedPacking, TheSameGraphKeepsAllDummies)
{
  const itk::Graph      graph = RingWithTail(40);
  itk::CombinatorialMap map;
  ASSERT_TRUE(itk::FindPlanarEmbedding(graph, map));
  const itk::PackedMap packed = itk::MakePackedMap(map);
  ASSERT_GT(packed.map.Nodes(), graph.nodes);
  const itk::PackedMap carried = itk::CarryPackedMap(graph, packed, graph, map);
  EXPECT_EQ(carried.map.GetRotation(), packed.map.GetRotation());
}

TEST(CarriedPacking, DummiesFarFromAnEditStay)
{
  const itk::Graph      before = RingWithTail(200);
  itk::CombinatorialMap map;
  ASSERT_TRUE(itk::FindPlanarEmbedding(before, map));
  const itk::PackedMap packed = itk::MakePackedMap(map);
  itk::Graph           after = before;
  after.edges.push_back({ 50, 52 });
  after.edges.erase(after.edges.begin() + 120);
  const itk::CombinatorialMap edited = itk::CarryRotation(before, map, after).map;
  const itk::PackedMap        carried = itk::CarryPackedMap(before, packed, after, edited);
  ExpectPackedMapOf(carried, edited);
  EXPECT_GT(NodesAsBefore(packed, carried), 180);
  EXPECT_LT(NodesAsBefore(packed, itk::MakePackedMap(edited)), 150); // made anew
}

TEST(CarriedPacking, RandomEditsGivePackableMapsOfTheGraph)
{
  std::mt19937      random(5);
  std::vector<char> isThere(itk::GridGraph(12, 10).edges.size(), 1);
  for (char & flag : isThere)
  {
    flag = random() % 4 != 0;
  }
  itk::Graph            graph = PartOfGrid(isThere);
  itk::CombinatorialMap map;
  ASSERT_TRUE(itk::FindPlanarEmbedding(graph, map));
  itk::PackedMap packed = itk::MakePackedMap(map);
  int            carriedSteps = 0;
  for (int step = 0; step < 60; ++step)
  {
    for (int edit = 0; edit < 1 + step % 7; ++edit)
    {
      char & flag = isThere[random() % isThere.size()];
      flag = !flag;
    }
    const itk::Graph            next = PartOfGrid(isThere);
    const itk::CombinatorialMap nextMap = itk::CarryRotation(graph, map, next).map;
    packed = itk::CarryPackedMap(graph, packed, next, nextMap);
    ExpectPackedMapOf(packed, nextMap);
    carriedSteps += packed.map.GetRotation() != itk::MakePackedMap(nextMap).map.GetRotation() ? 1 : 0;
    graph = next;
    map = nextMap;
  }
  EXPECT_GT(carriedSteps, 50);
}

TEST(CarriedPacking, LoopsAndHandlesArePackedAnew)
{
  const itk::Graph      before = RingWithTail(20);
  itk::CombinatorialMap map;
  ASSERT_TRUE(itk::FindPlanarEmbedding(before, map));
  const itk::PackedMap packed = itk::MakePackedMap(map);
  for (const std::array<int, 2> & edge : { std::array<int, 2>{ 3, 3 }, std::array<int, 2>{ 5, 4 } })
  {
    itk::Graph after = before;
    after.edges.push_back(edge);
    const itk::CombinatorialMap edited = itk::CarryRotation(before, map, after).map;
    const itk::PackedMap        carried = itk::CarryPackedMap(before, packed, after, edited);
    EXPECT_EQ(carried.map.GetRotation(), itk::MakePackedMap(edited).map.GetRotation());
    EXPECT_EQ(carried.subdivided.size(), 1U);
  }
}
