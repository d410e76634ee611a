#include "shapetonGraph.h"
#include "shapetonExceptions.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphReader.h"
#include "shapetonGraphStructure.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>

namespace
{
std::string
FaultOf(const shapeton::Graph & graph)
{
  return basetest::ErrorOf([&] { shapeton::RequireSound(graph, "file.gml"); });
}
} // namespace

TEST(Graph, EndsOutOfRangeAreRefusedEverywhere)
{
  shapeton::Graph graph{ 3, { { { 1, 2 } }, { { 2, 3 } }, { { 3, 1 } } }, {} }; // numbered from 1
  for (const auto & call : std::initializer_list<std::function<void()>>{
         [&] { shapeton::ConnectedComponents(graph); },
         [&] { shapeton::BlocksOf(graph); },
         [&] { shapeton::Girth(graph); },
         [&] { shapeton::GenusLowerBound(graph); },
         [&] { shapeton::WriteGraphML(graph, "/proc/nowhere/g.graphml"); } })
  {
    EXPECT_THROW(call(), shapeton::InputError);
  }
  graph.edges.clear();
  graph.names = { "a" };
  EXPECT_THROW(shapeton::WriteGraphML(graph, "/proc/nowhere/g.graphml"), shapeton::ParameterError);
}

TEST(Graph, UnsoundGraphsAreRefusedByName)
{
  EXPECT_EQ(FaultOf({ 1, {}, {} }), "");
  EXPECT_EQ(FaultOf({ 2, { { 0, 1 }, { 1, 1 } }, { "a", "b" } }), "");
  EXPECT_EQ(FaultOf({ 0, {}, {} }), "file.gml: the graph has no nodes; use a graph with at least one");
  EXPECT_EQ(FaultOf({ 2, { { 0, 1 }, { 0, 2 } }, {} }), "file.gml: edge 1 names node 2, but there are 2");
  EXPECT_EQ(FaultOf({ 2, { { -1, 1 } }, {} }), "file.gml: edge 0 names node -1, but there are 2");
  EXPECT_EQ(FaultOf({ 2, {}, { "a" } }), "file.gml: the graph has 2 nodes but 1 names");
}

TEST(Graph, RelabelingMovesNodesAndNames)
{
  const shapeton::Graph graph = shapeton::RelabeledGraph({ 3, { { 0, 1 }, { 1, 2 } }, { "a", "b", "c" } }, { 2, 0, 1 });
  EXPECT_EQ(graph.edges, (std::vector<std::array<int, 2>>{ { 2, 0 }, { 0, 1 } }));
  EXPECT_EQ(graph.names, (std::vector<std::string>{ "b", "c", "a" }));
  EXPECT_EQ(shapeton::NameOfNode(graph, 2), "a");
  EXPECT_EQ(shapeton::NameOfNode(shapeton::PathGraph(3), 2), "2");
}

TEST(Graph, FamiliesHaveTheirNumbersOfNodesAndEdges)
{
  const auto expect = [](const shapeton::Graph & graph, int nodes, std::size_t edges) {
    shapeton::RequireSound(graph, "family");
    EXPECT_EQ(graph.nodes, nodes);
    EXPECT_EQ(graph.edges.size(), edges);
  };
  expect(shapeton::CompleteGraph(7), 7, 21);
  expect(shapeton::CompleteBipartiteGraph(3, 4), 7, 12);
  expect(shapeton::HypercubeGraph(4), 16, 32);
  expect(shapeton::PathGraph(1), 1, 0);
  expect(shapeton::CycleGraph(1), 1, 1);
  expect(shapeton::WheelGraph(5), 6, 10);
  expect(shapeton::GeneralizedPetersenGraph(5, 2), 10, 15);
  expect(shapeton::GridGraph(4, 3), 12, 17);
}
