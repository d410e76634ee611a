#include "shapetonGraphFamilies.h"
#include "shapetonPhiloxStream.h"
#include "shapetonTestGraphs.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
/** Reference: Boost's Boyer-Myrvold test. */
bool
IsPlanarByBoost(const shapeton::Graph & graph)
{
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> boostGraph(graph.nodes);
  for (const auto & edge : graph.edges)
  {
    boost::add_edge(edge[0], edge[1], boostGraph);
  }
  return boost::boyer_myrvold_planarity_test(boostGraph);
}

/** Checks that the map is planar and has the edges of the graph; CombinatorialMap has checked the orders. */
bool
IsPlanar(const shapeton::Graph & graph)
{
  shapeton::CombinatorialMap map;
  const bool                 planar = shapeton::FindPlanarEmbedding(graph, map);
  if (planar)
  {
    EXPECT_EQ(map.Genus(), 0);
    EXPECT_EQ(map.ToGraph().edges, graph.edges);
  }
  return planar;
}

/** Random simple graph with at most this many edges. */
shapeton::Graph
RandomGraph(int nodes, int edges, shapeton::PhiloxStream & random)
{
  shapeton::Graph graph;
  graph.nodes = nodes;
  while (edges-- > 0)
  {
    std::array<int, 2> edge{ random.Below(nodes), random.Below(nodes) };
    const bool         known = std::any_of(graph.edges.begin(), graph.edges.end(), [&edge](const auto & other) {
      return other == edge || (other[0] == edge[1] && other[1] == edge[0]);
    });
    if (edge[0] != edge[1] && !known)
    {
      graph.edges.push_back(edge);
    }
  }
  return graph;
}

/** A planar triangulation with all edges in random order: nodes are inserted into random triangles, then edges flip. */
shapeton::Graph
RandomTriangulation(int nodes, shapeton::PhiloxStream & random)
{
  shapeton::Graph graph = graphtest::StackedTriangles(nodes, [&](int triangles) { return random.Below(triangles); });
  for (int i = static_cast<int>(graph.edges.size()); i > 1; --i)
  {
    std::swap(graph.edges[i - 1], graph.edges[random.Below(i)]);
  }
  return graph;
}
} // namespace

TEST(Planarity, AgreesWithBoostOnRandomGraphs)
{
  shapeton::PhiloxStream random(7, 0, 0);
  int                    planar = 0;
  constexpr int          trials = 4000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const int             nodes = 4 + random.Below(14);
    const shapeton::Graph graph = RandomGraph(nodes, nodes + random.Below(2 * nodes), random);
    const bool            isPlanar = IsPlanar(graph);
    ASSERT_EQ(isPlanar, IsPlanarByBoost(graph)) << trial;
    planar += isPlanar ? 1 : 0;
  }
  EXPECT_GT(planar, trials / 5);
  EXPECT_LT(planar, trials - trials / 5);
}

TEST(Planarity, PartsOfTriangulationsArePlanarAndOneEdgeMoreIsNot)
{
  shapeton::PhiloxStream random(8, 0, 0);
  for (int trial = 0; trial < 60; ++trial)
  {
    shapeton::Graph graph = RandomTriangulation(5 + random.Below(200), random);
    ASSERT_TRUE(IsPlanar(graph));
    shapeton::Graph more = graph;
    more.edges.push_back({ 0, graph.nodes - 1 });
    EXPECT_EQ(IsPlanar(more), IsPlanarByBoost(more));
    graph.edges.resize(graph.edges.size() * (50 + random.Below(50)) / 100);
    ASSERT_TRUE(IsPlanar(graph));
  }
}

TEST(Planarity, DeepGraphsNeedNoStack)
{
  EXPECT_TRUE(IsPlanar(shapeton::PathGraph(300000)));
  EXPECT_TRUE(IsPlanar(shapeton::CycleGraph(300000)));
  EXPECT_TRUE(IsPlanar(shapeton::WheelGraph(100000)));
  EXPECT_TRUE(IsPlanar(shapeton::GridGraph(300, 300)));
}

TEST(Planarity, KnownGraphs)
{
  EXPECT_TRUE(IsPlanar(shapeton::CompleteGraph(4)));
  EXPECT_FALSE(IsPlanar(shapeton::CompleteGraph(5)));
  EXPECT_FALSE(IsPlanar(shapeton::CompleteBipartiteGraph(3, 3)));
  EXPECT_TRUE(IsPlanar(shapeton::CompleteBipartiteGraph(2, 50)));
  EXPECT_TRUE(IsPlanar(shapeton::GeneralizedPetersenGraph(10, 2))); // dodecahedron
  EXPECT_FALSE(IsPlanar(shapeton::GeneralizedPetersenGraph(5, 2)));
  EXPECT_FALSE(IsPlanar(shapeton::TorusGridMap(4, 4).ToGraph()));
}

/** Compares the kept edges with one Boost test per edge; for K5 and K3,3, one edge is left out. */
TEST(Planarity, PlanarEdgesAreGreedy)
{
  EXPECT_EQ(9u, shapeton::PlanarEdges(shapeton::CompleteGraph(5)).size());
  EXPECT_EQ(8u, shapeton::PlanarEdges(shapeton::CompleteBipartiteGraph(3, 3)).size());
  EXPECT_EQ(12u, shapeton::PlanarEdges(shapeton::HypercubeGraph(3)).size());
  EXPECT_TRUE(shapeton::PlanarEdges(shapeton::Graph{ 3, {}, {} }).empty());
  shapeton::PhiloxStream random(17, 0, 0);
  for (int i = 0; i < 20; ++i)
  {
    const shapeton::Graph graph = RandomGraph(25, 90, random);
    std::vector<int>      kept;
    for (int edge = 0; edge < static_cast<int>(graph.edges.size()); ++edge)
    {
      kept.push_back(edge);
      if (!IsPlanarByBoost(shapeton::GraphWithEdges(graph, kept)))
      {
        kept.pop_back();
      }
    }
    EXPECT_EQ(kept, shapeton::PlanarEdges(graph));
  }
}
