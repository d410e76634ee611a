#include "shapetonGraphFamilies.h"
#include "shapetonGraphStructure.h"

#include <gtest/gtest.h>

TEST(GraphStructure, IncidenceListsEachHalfEdgeAtItsNode)
{
  const shapeton::Graph     graph{ 4, { { 0, 1 }, { 2, 0 }, { 1, 1 } }, {} };
  const shapeton::Incidence incidence(graph);
  EXPECT_EQ(incidence.start, (std::vector<int>{ 0, 2, 5, 6, 6 }));
  EXPECT_EQ(incidence.halfEdges, (std::vector<int>{ 0, 3, 1, 4, 5, 2 }));
  EXPECT_EQ(incidence.Degree(1), 3);
}

TEST(GraphStructure, ComponentsKeepNamesAndIndices)
{
  const shapeton::Graph graph{ 5, { { 1, 3 }, { 0, 4 }, { 3, 3 } }, { "a", "b", "c", "d", "e" } };
  const auto            parts = shapeton::ConnectedComponents(graph);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].nodes, (std::vector<int>{ 1, 3 }));
  EXPECT_EQ(parts[1].edges, (std::vector<int>{ 0, 2 }));
  EXPECT_EQ(parts[1].graph.edges, (std::vector<std::array<int, 2>>{ { 0, 1 }, { 1, 1 } }));
  EXPECT_EQ(parts[1].graph.names, (std::vector<std::string>{ "b", "d" }));
  EXPECT_EQ(parts[2].graph.nodes, 1);
}

TEST(GraphStructure, BlocksPartitionTheEdges)
{
  // Two triangles that share node 2, a bridge, a loop, a double edge.
  const shapeton::Graph graph{
    7, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 2, 3 }, { 3, 4 }, { 4, 2 }, { 4, 5 }, { 5, 5 }, { 5, 6 }, { 6, 5 } }, {}
  };
  EXPECT_EQ(shapeton::BlocksOf(graph),
            (std::vector<std::vector<int>>{ { 0, 1, 2 }, { 3, 4, 5 }, { 6 }, { 7 }, { 8, 9 } }));
  EXPECT_EQ(shapeton::BlocksOf(shapeton::PathGraph(200000)).size(), 199999U); // no recursion
  EXPECT_EQ(shapeton::BlocksOf(shapeton::CompleteGraph(6)).size(), 1U);
  EXPECT_TRUE(shapeton::BlocksOf(shapeton::PathGraph(1)).empty());
}

TEST(GraphStructure, SubgraphOfEdgesHasTheirNodesAlone)
{
  const shapeton::Subgraph part = shapeton::SubgraphOfEdges(shapeton::CycleGraph(6), { 1, 4 });
  EXPECT_EQ(part.nodes, (std::vector<int>{ 1, 2, 4, 5 }));
  EXPECT_EQ(part.graph.edges, (std::vector<std::array<int, 2>>{ { 0, 1 }, { 2, 3 } }));
}

TEST(GraphStructure, FirstParallelsInEitherOrder)
{
  const shapeton::Graph graph{ 4, { { 1, 2 }, { 3, 3 }, { 2, 1 }, { 0, 3 }, { 1, 2 }, { 3, 3 } }, {} };
  EXPECT_EQ(shapeton::FirstParallels(graph), (std::vector<int>{ 0, -1, 0, 3, 0, -1 }));
}

TEST(GraphStructure, GirthOfKnownGraphs)
{
  EXPECT_EQ(shapeton::Girth(shapeton::PathGraph(9)), 0);
  EXPECT_EQ(shapeton::Girth(shapeton::CycleGraph(1)), 1);
  EXPECT_EQ(shapeton::Girth(shapeton::CycleGraph(2)), 2);
  EXPECT_EQ(shapeton::Girth({ 5, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 3 } }, {} }), 2);
  EXPECT_EQ(shapeton::Girth({ 4, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 3 } }, {} }), 1);
  EXPECT_EQ(shapeton::Girth(shapeton::CycleGraph(9)), 9);
  EXPECT_EQ(shapeton::Girth(shapeton::CycleGraph(10)), 10);
  EXPECT_EQ(shapeton::Girth(shapeton::CompleteGraph(4)), 3);
  EXPECT_EQ(shapeton::Girth(shapeton::HypercubeGraph(5)), 4);
  EXPECT_EQ(shapeton::Girth(shapeton::GeneralizedPetersenGraph(5, 2)), 5);
  EXPECT_EQ(shapeton::Girth(shapeton::GeneralizedPetersenGraph(10, 3)), 6);
}
