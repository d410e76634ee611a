#include "itkGraph.h"
#include "itkGraphFamilies.h"
#include "itkExceptions.h"

#include <gtest/gtest.h>

namespace
{
std::string
FaultOf(const itk::Graph & graph)
{
  try
  {
    itk::RequireSound(graph, "file.gml");
  }
  catch (const itk::InputError & error)
  {
    return error.what();
  }
  return "";
}
} // namespace

TEST(Graph, UnsoundGraphsAreRefusedByName)
{
  EXPECT_EQ(FaultOf({ 1, {}, {} }), "");
  EXPECT_EQ(FaultOf({ 2, { { 0, 1 }, { 1, 1 } }, { "a", "b" } }), "");
  EXPECT_EQ(FaultOf({ 0, {}, {} }), "file.gml: the graph has no nodes; give one with at least one");
  EXPECT_EQ(FaultOf({ 2, { { 0, 1 }, { 0, 2 } }, {} }), "file.gml: edge 1 names node 2, but there are 2");
  EXPECT_EQ(FaultOf({ 2, { { -1, 1 } }, {} }), "file.gml: edge 0 names node -1, but there are 2");
  EXPECT_EQ(FaultOf({ 2, {}, { "a" } }), "file.gml: the graph has 2 nodes but 1 names");
}

TEST(Graph, RelabellingMovesNodesAndNames)
{
  const itk::Graph graph = itk::RelabelledGraph({ 3, { { 0, 1 }, { 1, 2 } }, { "a", "b", "c" } }, { 2, 0, 1 });
  EXPECT_EQ(graph.edges, (std::vector<std::array<int, 2>>{ { 2, 0 }, { 0, 1 } }));
  EXPECT_EQ(graph.names, (std::vector<std::string>{ "b", "c", "a" }));
  EXPECT_EQ(itk::NameOfNode(graph, 2), "a");
  EXPECT_EQ(itk::NameOfNode(itk::PathGraph(3), 2), "2");
}

TEST(Graph, FamiliesHaveTheirNumbersOfNodesAndEdges)
{
  const auto expect = [](const itk::Graph & graph, int nodes, std::size_t edges) {
    itk::RequireSound(graph, "family");
    EXPECT_EQ(graph.nodes, nodes);
    EXPECT_EQ(graph.edges.size(), edges);
  };
  expect(itk::CompleteGraph(7), 7, 21);
  expect(itk::CompleteBipartiteGraph(3, 4), 7, 12);
  expect(itk::HypercubeGraph(4), 16, 32);
  expect(itk::PathGraph(1), 1, 0);
  expect(itk::CycleGraph(1), 1, 1);
  expect(itk::WheelGraph(5), 6, 10);
  expect(itk::GeneralizedPetersenGraph(5, 2), 10, 15);
  expect(itk::GridGraph(4, 3), 12, 17);
}
