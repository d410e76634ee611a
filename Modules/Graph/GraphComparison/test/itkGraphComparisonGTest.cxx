#include "itkGraphComparison.h"

#include "itkCarriedRotation.h"
#include "itkEmbeddingVerification.h"
#include "itkGraphFamilies.h"
#include "itkSphereAlignment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
itk::Graph
Shuffled(const itk::Graph & graph)
{
  std::vector<int> image(graph.nodes);
  for (int v = 0; v < graph.nodes; ++v)
  {
    image[v] = static_cast<int>((7919LL * v + 11) % graph.nodes); // 7919 is a prime
  }
  return itk::RelabelledGraph(graph, image);
}

itk::Graph
WithNames(itk::Graph graph)
{
  for (int v = 0; v < graph.nodes; ++v)
  {
    graph.names.push_back("n" + std::to_string(v));
  }
  return graph;
}
} // namespace

TEST(SphereAlignment, FindsTheRotation)
{
  const double                             c = std::cos(0.7);
  const double                             s = std::sin(0.7);
  const std::vector<std::array<double, 3>> points{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.6, 0.8, 0 } };
  std::vector<std::array<double, 3>>       images;
  for (const auto & p : points)
  {
    images.push_back({ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] });
  }
  const auto rotation = itk::BestRotation(points, images);
  EXPECT_NEAR(rotation[0], c, 1e-14);
  EXPECT_NEAR(rotation[1], -s, 1e-14);
  EXPECT_NEAR(rotation[8], 1.0, 1e-14);
  EXPECT_NEAR(itk::AngleBetween(points[0], images[0]), 0.7, 1e-14);
  EXPECT_NEAR(itk::AngleBetween({ 1, 0, 0 }, { 1, 1e-9, 0 }), 1e-9, 1e-17);
  EXPECT_EQ(itk::BestRotation({}, {})[4], 1.0);
}

TEST(GraphComparison, FiguresOfAGraph)
{
  const itk::GraphFigures figures =
    itk::FiguresOf({ 6, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 1 }, { 2, 3 }, { 4, 4 } }, {} });
  EXPECT_EQ(figures.loops, 1);
  EXPECT_EQ(figures.parallelEdges, 1);
  EXPECT_EQ(figures.components, 3);
  EXPECT_EQ(figures.blocks, 3);
  EXPECT_EQ(figures.triangles, 1);
  EXPECT_EQ(figures.nodesOfDegree, (std::vector<int>{ 1, 1, 1, 3 }));
  EXPECT_EQ(itk::FiguresOf(itk::CompleteGraph(7)).triangles, 35);
}

TEST(GraphComparison, IsomorphicPlanarGraphsHaveOnePicture)
{
  for (const itk::Graph & graph :
       { itk::GridGraph(9, 7), itk::WheelGraph(8), itk::PathGraph(12), itk::HypercubeGraph(3) })
  {
    const itk::GraphComparison comparison = itk::CompareGraphs(graph, Shuffled(graph));
    ASSERT_TRUE(comparison.isomorphic);
    EXPECT_TRUE(comparison.differences.empty());
    EXPECT_EQ(comparison.changes.unchangedNodes, graph.nodes);
    EXPECT_LE(comparison.changes.largestDisplacement, 1e-6);
    for (int v = 0; v < graph.nodes; ++v)
    {
      EXPECT_NEAR(comparison.a.nodeRadii[v], comparison.b.nodeRadii[v], 1e-9);
    }
    const auto colours = itk::ColoursOfNodes(comparison);
    EXPECT_EQ(colours[0], colours[1]);
  }
}

TEST(GraphComparison, WhatDiffersIsSaid)
{
  const itk::Graph a = WithNames(itk::GridGraph(7, 6));
  itk::Graph       b = a;
  b.edges.erase(b.edges.begin() + 30);
  b.edges.push_back({ 8, 16 });
  b.edges.push_back({ 20, 28 });
  const itk::GraphComparison comparison = itk::CompareGraphs(a, b);
  EXPECT_FALSE(comparison.isomorphic);
  EXPECT_EQ(comparison.correspondence.by, "names");
  EXPECT_EQ(comparison.differences[0], "edges: 71 and 72");
  EXPECT_EQ(comparison.changes.addedEdges.size(), 2U);
  EXPECT_EQ(comparison.changes.removedEdges.size(), 1U);
  EXPECT_TRUE(comparison.changes.addedNodes.empty());
  EXPECT_LT(comparison.changes.meanDisplacement, 0.5);
  const itk::Json json = itk::ComparisonToJson(comparison);
  EXPECT_EQ(json["isomorphic"], false);
  EXPECT_EQ(json["correspondence"]["nodes"].size(), 42U);
}

TEST(GraphComparison, WithoutNamesSurroundingsTellNodesApart)
{
  itk::Graph a = itk::GridGraph(6, 5);
  a.edges.insert(a.edges.end(), { { 0, 7 }, { 3, 10 }, { 14, 21 } }); // breaks the symmetry
  itk::Graph b = a;
  b.edges.push_back({ 22, 29 });
  const itk::GraphComparison comparison = itk::CompareGraphs(a, Shuffled(b));
  EXPECT_EQ(comparison.correspondence.by, "neighbourhoods");
  EXPECT_FALSE(comparison.isomorphic);
  EXPECT_GT(comparison.changes.unchangedNodes, 5);
}

TEST(DynamicEmbedding, EditsLeaveTheRestInPlace)
{
  const itk::Graph      first = WithNames(itk::GridGraph(30, 20));
  itk::Graph            second = first;
  itk::DynamicEmbedding dynamic;
  second.edges.push_back({ 100, 131 });
  const itk::DynamicStep before = dynamic.Add(first);
  const itk::DynamicStep after = dynamic.Add(second);
  EXPECT_FALSE(after.embeddedAnew);
  EXPECT_EQ(after.changes.changedNodes, (std::vector<int>{ 100, 131 }));
  EXPECT_EQ(after.changes.unchangedNodes, 598);
  EXPECT_LT(after.changes.meanDisplacement, 0.01);
  EXPECT_EQ(before.certificate.genus, 0);
}

TEST(DynamicEmbedding, OneEdgeOfALongFaceMovesLessThanAPackingMadeAnew)
{
  const itk::Graph first = WithNames(itk::GridGraph(40, 30)); // the face around it has 136 edges
  itk::Graph       second = first;
  second.edges.erase(second.edges.begin() + 20);
  itk::DynamicEmbedding     dynamic;
  const itk::DynamicStep    before = dynamic.Add(first);
  const itk::DynamicStep    after = dynamic.Add(second);
  const auto                map = itk::MapOfRotation(second, after.certificate.rotation);
  itk::EmbeddingCertificate anew = itk::EmbedGraph(second, map);
  itk::MoveEmbedding(anew, itk::BestMotion(before.certificate, anew, itk::NodesOfSameName(first, second)));
  EXPECT_LT(after.changes.meanDisplacement, 0.2 * itk::ChangesBetween(before.certificate, anew).meanDisplacement);
}

TEST(DynamicEmbedding, TheVerifierAcceptsEachStep)
{
  itk::DynamicEmbedding dynamic;
  itk::Graph            graph = WithNames(itk::GridGraph(12, 10));
  for (int step = 0; step < 8; ++step)
  {
    const itk::DynamicStep result = dynamic.Add(graph);
    EXPECT_EQ(itk::VerifyEmbedding(result.certificate).refusal, "") << step;
    const std::array<int, 2> moved = graph.edges[17 * step];
    graph.edges.erase(graph.edges.begin() + 17 * step);
    graph.edges.erase(graph.edges.begin() + 9 * step + 5);
    graph.edges.push_back(moved[1] == moved[0] + 1 ? std::array<int, 2>{ moved[0], (moved[0] + 13) % 120 } : moved);
  }
}

TEST(SphereAlignment, FindsAMoebiusTransformation)
{
  const itk::Graph                graph = itk::GridGraph(8, 6);
  const itk::EmbeddingCertificate still = itk::EmbedGraph(graph, itk::FindEmbedding(graph).map);
  itk::EmbeddingCertificate       moved = still;
  const double                    c = std::cosh(0.8);
  const double                    s = std::sinh(0.8);
  std::vector<int>                image(graph.nodes);
  itk::MoveEmbedding(moved, { 1, 0, 0, 0, 0, c, 0, s, 0, 0, 1, 0, 0, s, 0, c }); // a boost along y
  double farthest = 0.0;
  for (int v = 0; v < graph.nodes; ++v)
  {
    image[v] = v;
    farthest = std::max(farthest, itk::AngleBetween(itk::PlaceOnSphere(still, v), itk::PlaceOnSphere(moved, v)));
  }
  EXPECT_GT(farthest, 0.5);
  itk::MoveEmbedding(moved, itk::BestMotion(still, moved, image));
  for (int v = 0; v < graph.nodes; ++v)
  {
    EXPECT_LT(itk::AngleBetween(itk::PlaceOnSphere(still, v), itk::PlaceOnSphere(moved, v)), 1e-9);
    EXPECT_NEAR(moved.nodeRadii[v], still.nodeRadii[v], 1e-9);
  }
}
