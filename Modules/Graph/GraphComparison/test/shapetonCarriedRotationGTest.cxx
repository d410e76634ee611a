#include "shapetonCarriedRotation.h"
#include "shapetonGraphFamilies.h"
#include "shapetonTestGraphs.h"

#include <gtest/gtest.h>

namespace
{
using graphtest::WithNames;

/** For each half-edge, the next one around its node that is also in the other map, by node names. */
int
KeptOrders(const shapeton::CombinatorialMap & before, const shapeton::CombinatorialMap & after, int edges)
{
  int kept = 0;
  for (int h = 0; h < 2 * edges; ++h)
  {
    kept += before.NextAround(h) == after.NextAround(h) ? 1 : 0;
  }
  return kept;
}
} // namespace

TEST(CarriedRotation, SameGraphKeepsItsMap)
{
  const shapeton::CombinatorialMap torus = shapeton::TorusGridMap(5, 4);
  const shapeton::Graph            graph = torus.ToGraph();
  const shapeton::CarriedRotation  carried = shapeton::CarryRotation(graph, torus, graph);
  EXPECT_FALSE(carried.embeddedAnew);
  EXPECT_EQ(carried.map.GetRotation(), torus.GetRotation());
}

TEST(CarriedRotation, RenumberedGraphHasTheSameMap)
{
  const shapeton::Graph            before = WithNames(shapeton::GridGraph(6, 5));
  const shapeton::CombinatorialMap map = graphtest::PlanarMap(before);
  std::vector<int>                 image(before.nodes);
  for (int v = 0; v < before.nodes; ++v)
  {
    image[v] = (7 * v + 3) % before.nodes;
  }
  shapeton::Graph after = shapeton::RelabeledGraph(before, image);
  for (std::size_t e = 0; e < after.edges.size(); e += 3)
  {
    std::swap(after.edges[e][0], after.edges[e][1]);
  }
  const shapeton::CarriedRotation carried = shapeton::CarryRotation(before, map, after);
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    const int turned = h / 2 % 3 == 0 ? 1 : 0;
    const int next = map.NextAround(h);
    const int nextTurned = next / 2 % 3 == 0 ? 1 : 0;
    EXPECT_EQ(carried.map.NextAround(h ^ turned), next ^ nextTurned);
  }
}

TEST(CarriedRotation, EditsStayPlanarAndLocal)
{
  const shapeton::Graph            before = WithNames(shapeton::GridGraph(12, 10));
  const shapeton::CombinatorialMap map = graphtest::PlanarMap(before);
  shapeton::Graph                  after = before;
  const int                        edges = static_cast<int>(before.edges.size());
  after.edges.push_back({ 13, 26 }); // a diagonal of a square
  after.edges.push_back({ 50, 50 }); // a loop
  after.edges.push_back({ 60, 61 }); // parallel
  after.nodes += 3;                  // a node inside a square, one outside, one isolated
  after.names.insert(after.names.end(), { "new", "leaf", "alone" });
  after.edges.insert(after.edges.end(), { { 120, 80 }, { 81, 120 }, { 120, 92 }, { 121, 120 } });
  const shapeton::CarriedRotation carried = shapeton::CarryRotation(before, map, after);
  EXPECT_FALSE(carried.embeddedAnew);
  EXPECT_EQ(carried.map.Genus(), 0);
  EXPECT_EQ(carried.map.ToGraph().edges, after.edges);
  EXPECT_GE(KeptOrders(map, carried.map, edges), 2 * edges - 8);
  const shapeton::CarriedRotation back = shapeton::CarryRotation(after, carried.map, before);
  EXPECT_EQ(back.map.GetRotation(), map.GetRotation());
}

/** A ladder between two rim nodes of a grid, with one rail at the outer face and the other at the grid. An edge from
 * the inner rail to the far rim flips the ladder and keeps the orders of the grid. */
TEST(CarriedRotation, OnlyWhatIsInTheWayTurnsOver)
{
  shapeton::Graph before = shapeton::GridGraph(12, 10);
  before.nodes += 6;
  const std::vector<std::array<int, 2>> ladder{ { 4, 120 },   { 120, 121 }, { 121, 122 }, { 122, 7 },
                                                { 4, 123 },   { 123, 124 }, { 124, 125 }, { 125, 7 },
                                                { 120, 123 }, { 121, 124 }, { 122, 125 } };
  before.edges.insert(before.edges.end(), ladder.begin(), ladder.end());
  before = WithNames(before);
  const shapeton::CombinatorialMap map = graphtest::PlanarMap(before);
  const int                        edges = static_cast<int>(before.edges.size());
  int                              turned = 0;
  for (const int rail : { 121, 124 })
  {
    shapeton::Graph after = before;
    after.edges.push_back({ rail, 114 });
    const shapeton::CarriedRotation carried = shapeton::CarryRotation(before, map, after);
    EXPECT_FALSE(carried.embeddedAnew);
    EXPECT_EQ(carried.map.Genus(), 0);
    EXPECT_EQ(carried.map.ToGraph().edges, after.edges);
    const int changed = 2 * edges - KeptOrders(map, carried.map, edges);
    EXPECT_LE(changed, 2 + 18 + 2 * 3); // the ends of the new edge, the ladder and its two ends
    turned += changed > 2 ? 1 : 0;
  }
  EXPECT_EQ(turned, 1);
}

TEST(CarriedRotation, HandlesComeAndGo)
{
  const shapeton::Graph           k4 = WithNames(shapeton::CompleteGraph(4));
  const shapeton::Graph           k5 = WithNames(shapeton::CompleteGraph(5));
  const shapeton::CarriedRotation raised = shapeton::CarryRotation(k4, graphtest::PlanarMap(k4), k5);
  EXPECT_EQ(raised.map.Genus(), 1);
  shapeton::Graph less = k5;
  less.edges.erase(less.edges.begin());
  EXPECT_EQ(shapeton::CarryRotation(k5, raised.map, less).map.Genus(), 0);
}

TEST(CarriedRotation, ANewEmbeddingIsTakenWhenItHasFewerHandles)
{
  // A path of squares whose blocks may flip: the new edge is planar only after a flip.
  shapeton::Graph before =
    WithNames({ 6, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 4, 2 }, { 0, 5 }, { 5, 2 } }, {} });
  const shapeton::CombinatorialMap map(
    before, { { 0, 7, 8, 12 }, { 1, 2 }, { 3, 4, 11, 15 }, { 5, 6 }, { 9, 10 }, { 13, 14 } });
  shapeton::Graph after = before;
  after.edges.insert(after.edges.end(), { { 1, 4 }, { 3, 5 } });
  const shapeton::CarriedRotation carried = shapeton::CarryRotation(before, map, after);
  EXPECT_EQ(carried.map.Genus(), 0);
}
