#include "shapetonCarriedPacking.h"

#include "shapetonCarriedRotation.h"
#include "shapetonGraphFamilies.h"
#include "shapetonPackedMapTests.h"
#include "shapetonTestGraphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{
/** The marked edges of a grid; if most are marked, every other square is large. */
shapeton::Graph
PartOfGrid(const std::vector<char> & isThere)
{
  std::vector<int> edges;
  for (std::size_t e = 0; e < isThere.size(); ++e)
  {
    edges.insert(edges.end(), isThere[e] ? 1 : 0, static_cast<int>(e));
  }
  return shapeton::GraphWithEdges(shapeton::GridGraph(12, 10), edges);
}

/** Checks that the map is packable and that its orders, ignoring dummies, are unchanged, except for the placement of
 * components. */
void
ExpectPackedMapOf(const shapeton::PackedMap & packed, const shapeton::CombinatorialMap & map)
{
  EXPECT_EQ(packed.map.Components(), 1);
  EXPECT_EQ(packed.map.Genus(), map.Genus());
  EXPECT_EQ(shapeton::FaceConflicts(packed.map).reason, "");
  graphtest::ExpectOrdersOf(packed, map);
}

/** Number of graph nodes with unchanged surroundings, including dummies. */
int
NodesAsBefore(const shapeton::PackedMap & a, const shapeton::PackedMap & b)
{
  const auto degreesAround = [](const shapeton::PackedMap & packed, int node) {
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

/** A ring of `length` nodes with a tail; rings of dummies fill both faces. */
shapeton::Graph
RingWithTail(int length)
{
  shapeton::Graph graph = shapeton::CycleGraph(length);
  graph.nodes += 1;
  graph.edges.push_back({ 0, length });
  return graph;
}

struct PackedRing
{
  explicit PackedRing(int length)
    : graph(RingWithTail(length)), map(graphtest::PlanarMap(graph)), packed(shapeton::MakePackedMap(map))
  {}
  shapeton::Graph            graph;
  shapeton::CombinatorialMap map;
  shapeton::PackedMap        packed;
};
} // namespace

TEST(CarriedPacking, TheSameGraphKeepsAllDummies)
{
  const auto [graph, map, packed] = PackedRing(40);
  ASSERT_GT(packed.map.Nodes(), graph.nodes);
  const shapeton::PackedMap carried = shapeton::CarryPackedMap(graph, packed, graph, map);
  EXPECT_EQ(carried.map.GetRotation(), packed.map.GetRotation());
}

TEST(CarriedPacking, DummiesFarFromAnEditStay)
{
  const auto [before, map, packed] = PackedRing(200);
  shapeton::Graph after = before;
  after.edges.push_back({ 50, 52 });
  after.edges.erase(after.edges.begin() + 120);
  const shapeton::CombinatorialMap edited = shapeton::CarryRotation(before, map, after).map;
  const shapeton::PackedMap        carried = shapeton::CarryPackedMap(before, packed, after, edited);
  ExpectPackedMapOf(carried, edited);
  EXPECT_GT(NodesAsBefore(packed, carried), 180);
  EXPECT_LT(NodesAsBefore(packed, shapeton::MakePackedMap(edited)), 150); // without reuse
}

/** An edge across a long face is routed along dummies without moving any circle. */
TEST(CarriedPacking, AnEdgeAcrossALongFaceRunsAlongDummies)
{
  const auto [before, map, packed] = PackedRing(200);
  shapeton::Graph after = before;
  after.edges.push_back({ 50, 150 });
  const shapeton::CombinatorialMap edited = shapeton::CarryRotation(before, map, after).map;
  const shapeton::PackedMap        carried = shapeton::CarryPackedMap(before, packed, after, edited);
  ExpectPackedMapOf(carried, edited);
  ASSERT_EQ(carried.subdivided.size(), 1U);
  EXPECT_GT(carried.subdivided[0].size(), 3U);
  EXPECT_EQ(carried.map.Nodes(), packed.map.Nodes());
  EXPECT_EQ(carried.map.Edges(), packed.map.Edges());
  EXPECT_EQ(NodesAsBefore(packed, carried), before.nodes);
  // The same applies to a second and a third parallel edge.
  after.edges.insert(after.edges.end(), { { 20, 40 }, { 52, 100 } });
  const shapeton::CombinatorialMap both = shapeton::CarryRotation(before, map, after).map;
  const shapeton::PackedMap        all = shapeton::CarryPackedMap(before, packed, after, both);
  ExpectPackedMapOf(all, both);
  EXPECT_EQ(all.subdivided.size(), 3U);
  EXPECT_EQ(NodesAsBefore(packed, all), before.nodes);
  // The next step recovers the path, and releases it when its edge is deleted.
  const shapeton::PackedMap again = shapeton::CarryPackedMap(after, all, after, both);
  ExpectPackedMapOf(again, both);
  EXPECT_EQ(again.map.GetRotation().size(), all.map.GetRotation().size());
  const shapeton::PackedMap back = shapeton::CarryPackedMap(after, all, before, map);
  ExpectPackedMapOf(back, map);
  EXPECT_EQ(NodesAsBefore(packed, back), before.nodes);
}

TEST(CarriedPacking, RandomEditsGivePackableMapsOfTheGraph)
{
  std::mt19937      random(5);
  std::vector<char> isThere(shapeton::GridGraph(12, 10).edges.size(), 1);
  for (char & flag : isThere)
  {
    flag = random() % 4 != 0;
  }
  shapeton::Graph            graph = PartOfGrid(isThere);
  shapeton::CombinatorialMap map = graphtest::PlanarMap(graph);
  shapeton::PackedMap        packed = shapeton::MakePackedMap(map);
  int                        carriedSteps = 0;
  for (int step = 0; step < 60; ++step)
  {
    for (int edit = 0; edit < 1 + step % 7; ++edit)
    {
      char & flag = isThere[random() % isThere.size()];
      flag = !flag;
    }
    const shapeton::Graph            next = PartOfGrid(isThere);
    const shapeton::CombinatorialMap nextMap = shapeton::CarryRotation(graph, map, next).map;
    packed = shapeton::CarryPackedMap(graph, packed, next, nextMap);
    ExpectPackedMapOf(packed, nextMap);
    carriedSteps += packed.map.GetRotation() != shapeton::MakePackedMap(nextMap).map.GetRotation() ? 1 : 0;
    graph = next;
    map = nextMap;
  }
  EXPECT_GT(carriedSteps, 50);
}

TEST(CarriedPacking, LoopsArePackedAnew)
{
  const auto [before, map, packed] = PackedRing(20);
  shapeton::Graph after = before;
  after.edges.push_back({ 3, 3 });
  const shapeton::CombinatorialMap edited = shapeton::CarryRotation(before, map, after).map;
  const shapeton::PackedMap        carried = shapeton::CarryPackedMap(before, packed, after, edited);
  EXPECT_EQ(carried.map.GetRotation(), shapeton::MakePackedMap(edited).map.GetRotation());
  EXPECT_EQ(carried.subdivided.size(), 1U);
}

TEST(CarriedPacking, ParallelEdgesKeepTheirDummies)
{
  const auto [ring, ringMap, ringPacked] = PackedRing(60);
  shapeton::Graph before = ring;
  before.edges.insert(before.edges.end(), { { 5, 4 }, { 4, 5 }, { 30, 31 }, { 10, 20 } });
  const shapeton::CombinatorialMap map = shapeton::CarryRotation(ring, ringMap, before).map;
  const shapeton::PackedMap        packed = shapeton::CarryPackedMap(ring, ringPacked, before, map);
  ExpectPackedMapOf(packed, map);
  const shapeton::PackedMap again = shapeton::CarryPackedMap(before, packed, before, map);
  ExpectPackedMapOf(again, map);
  EXPECT_EQ(again.map.Nodes(), packed.map.Nodes());
  EXPECT_EQ(NodesAsBefore(packed, again), before.nodes);
  // Without one of three parallel edges, and without the other edges of a pair.
  shapeton::Graph after = before;
  after.edges.erase(after.edges.begin() + 4);
  after.edges.erase(after.edges.begin() + 29);
  const shapeton::CombinatorialMap edited = shapeton::CarryRotation(before, map, after).map;
  const shapeton::PackedMap        carried = shapeton::CarryPackedMap(before, packed, after, edited);
  ExpectPackedMapOf(carried, edited);
  EXPECT_GT(NodesAsBefore(packed, carried), 40);
}
