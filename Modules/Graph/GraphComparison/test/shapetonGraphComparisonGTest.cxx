#include "shapetonGraphComparison.h"

#include "shapetonCarriedRotation.h"
#include "shapetonEmbeddingVerification.h"
#include "shapetonGraphFamilies.h"
#include "shapetonJson.h"
#include "shapetonProgressTests.h"
#include "shapetonSphereAlignment.h"
#include "shapetonTestGraphs.h"

#include <gtest/gtest.h>

#include <cmath>

using graphtest::Shuffled;
using graphtest::WithNames;

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
  const auto rotation = shapeton::BestRotation(points, images);
  EXPECT_NEAR(rotation[0], c, 1e-14);
  EXPECT_NEAR(rotation[1], -s, 1e-14);
  EXPECT_NEAR(rotation[8], 1.0, 1e-14);
  EXPECT_NEAR(shapeton::AngleBetween(points[0], images[0]), 0.7, 1e-14);
  EXPECT_NEAR(shapeton::AngleBetween({ 1, 0, 0 }, { 1, 1e-9, 0 }), 1e-9, 1e-17);
  EXPECT_EQ(shapeton::BestRotation({}, {})[4], 1.0);
}

TEST(GraphComparison, FiguresOfAGraph)
{
  const shapeton::GraphFigures figures =
    shapeton::FiguresOf({ 6, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 1 }, { 2, 3 }, { 4, 4 } }, {} });
  EXPECT_EQ(figures.loops, 1);
  EXPECT_EQ(figures.parallelEdges, 1);
  EXPECT_EQ(figures.components, 3);
  EXPECT_EQ(figures.blocks, 3);
  EXPECT_EQ(figures.triangles, 1);
  EXPECT_EQ(figures.nodesOfDegree, (std::vector<int>{ 1, 1, 1, 3 }));
  EXPECT_EQ(shapeton::FiguresOf(shapeton::CompleteGraph(7)).triangles, 35);
}

TEST(GraphComparison, IsomorphicPlanarGraphsHaveOnePicture)
{
  for (const shapeton::Graph & graph :
       { shapeton::GridGraph(9, 7), shapeton::WheelGraph(8), shapeton::PathGraph(12), shapeton::HypercubeGraph(3) })
  {
    const shapeton::GraphComparison comparison = shapeton::CompareGraphs(graph, Shuffled(graph));
    ASSERT_TRUE(comparison.isomorphic);
    EXPECT_TRUE(comparison.differences.empty());
    EXPECT_EQ(comparison.changes.unchangedNodes, graph.nodes);
    EXPECT_LE(comparison.changes.largestDisplacement, 1e-6);
    for (int v = 0; v < graph.nodes; ++v)
    {
      EXPECT_NEAR(comparison.a.nodeRadii[v], comparison.b.nodeRadii[v], 1e-9);
    }
    const auto colors = shapeton::ColorsOfNodes(comparison);
    EXPECT_EQ(colors[0], colors[1]);
  }
}

TEST(GraphComparison, WhatDiffersIsSaid)
{
  const shapeton::Graph a = WithNames(shapeton::GridGraph(7, 6));
  shapeton::Graph       b = a;
  b.edges.erase(b.edges.begin() + 30);
  b.edges.push_back({ 8, 16 });
  b.edges.push_back({ 20, 28 });
  const shapeton::GraphComparison comparison = shapeton::CompareGraphs(a, b);
  EXPECT_FALSE(comparison.isomorphic);
  EXPECT_EQ(comparison.correspondence.by, "names");
  EXPECT_EQ(comparison.differences[0], "edges: 71 and 72");
  EXPECT_EQ(comparison.changes.addedEdges.size(), 2U);
  EXPECT_EQ(comparison.changes.removedEdges.size(), 1U);
  EXPECT_TRUE(comparison.changes.addedNodes.empty());
  EXPECT_LT(comparison.changes.meanDisplacement, 0.5);
  const shapeton::Json json = shapeton::ComparisonToJson(comparison);
  EXPECT_EQ(json["isomorphic"], false);
  EXPECT_EQ(json["correspondence"]["nodes"].size(), 42U);
}

TEST(GraphComparison, WithoutNamesSurroundingsTellNodesApart)
{
  shapeton::Graph a = shapeton::GridGraph(6, 5);
  a.edges.insert(a.edges.end(), { { 0, 7 }, { 3, 10 }, { 14, 21 } }); // breaks the symmetry
  shapeton::Graph b = a;
  b.edges.push_back({ 22, 29 });
  const shapeton::GraphComparison comparison = shapeton::CompareGraphs(a, Shuffled(b));
  EXPECT_EQ(comparison.correspondence.by, "neighborhoods");
  EXPECT_FALSE(comparison.isomorphic);
  EXPECT_GT(comparison.changes.unchangedNodes, 5);
}

TEST(DynamicEmbedding, EditsLeaveTheRestInPlace)
{
  const shapeton::Graph      first = WithNames(shapeton::GridGraph(30, 20));
  shapeton::Graph            second = first;
  shapeton::DynamicEmbedding dynamic;
  second.edges.push_back({ 100, 131 });
  const shapeton::DynamicStep before = dynamic.Add(first);
  const shapeton::DynamicStep after = dynamic.Add(second);
  EXPECT_FALSE(after.embeddedAnew);
  EXPECT_EQ(after.changes.changedNodes, (std::vector<int>{ 100, 131 }));
  EXPECT_EQ(after.changes.unchangedNodes, 598);
  EXPECT_LT(after.changes.meanDisplacement, 0.01);
  EXPECT_EQ(before.certificate.genus, 0);
}

TEST(DynamicEmbedding, OneEdgeOfALongFaceMovesLessThanAPackingMadeAnew)
{
  const shapeton::Graph first = WithNames(shapeton::GridGraph(40, 30)); // the face around it has 136 edges
  shapeton::Graph       second = first;
  second.edges.erase(second.edges.begin() + 20);
  shapeton::DynamicEmbedding     dynamic;
  const shapeton::DynamicStep    before = dynamic.Add(first);
  const shapeton::DynamicStep    after = dynamic.Add(second);
  const auto                     map = shapeton::MapOfRotation(second, after.certificate.rotation);
  shapeton::EmbeddingCertificate anew = shapeton::EmbedGraph(second, map);
  shapeton::MoveEmbedding(anew,
                          shapeton::BestMotion(before.certificate, anew, shapeton::NodesOfSameName(first, second)));
  EXPECT_LT(after.changes.meanDisplacement, 0.2 * shapeton::ChangesBetween(before.certificate, anew).meanDisplacement);
}

TEST(DynamicEmbedding, DeletedEdgesHardlyMoveTheirEnds)
{
  shapeton::Graph graph = WithNames(shapeton::GridGraph(12, 10));
  graph.edges.insert(graph.edges.end(), { graph.edges[3], graph.edges[50], graph.edges[50] });
  shapeton::DynamicEmbedding dynamic;
  dynamic.Add(graph);
  for (const int edge : { 100, 60, 50, 20 })
  {
    const std::array<int, 2> ends = graph.edges[edge];
    graph.edges.erase(graph.edges.begin() + edge);
    const shapeton::DynamicStep step = dynamic.Add(graph);
    const auto &                radii = step.certificate.nodeRadii;
    const double                gap = shapeton::AngleBetween(shapeton::PlaceOnSphere(step.certificate, ends[0]),
                                              shapeton::PlaceOnSphere(step.certificate, ends[1])) -
                       radii[ends[0]] - radii[ends[1]];
    EXPECT_EQ(shapeton::VerifyEmbedding(step.certificate).refusal, "") << edge;
    EXPECT_LT(step.changes.meanDisplacement, 1e-3) << edge;
    EXPECT_LT(step.changes.largestDisplacement, 0.02) << edge;
    EXPECT_EQ(edge != 50, 1e-6 < gap) << edge; // only circles with an edge touch; edge 50 has two parallel ones
  }
}

TEST(DynamicEmbedding, TheVerifierAcceptsEachStep)
{
  shapeton::DynamicEmbedding dynamic;
  shapeton::Graph            graph = WithNames(shapeton::GridGraph(12, 10));
  for (int step = 0; step < 8; ++step)
  {
    const shapeton::DynamicStep result = dynamic.Add(graph);
    EXPECT_EQ(shapeton::VerifyEmbedding(result.certificate).refusal, "") << step;
    const std::array<int, 2> moved = graph.edges[17 * step];
    graph.edges.erase(graph.edges.begin() + 17 * step);
    graph.edges.erase(graph.edges.begin() + 9 * step + 5);
    graph.edges.push_back(moved[1] == moved[0] + 1 ? std::array<int, 2>{ moved[0], (moved[0] + 13) % 120 } : moved);
  }
}

TEST(SphereAlignment, FindsAMoebiusTransformation)
{
  const shapeton::Graph                graph = shapeton::GridGraph(8, 6);
  const shapeton::EmbeddingCertificate still = shapeton::EmbedGraph(graph, shapeton::FindEmbedding(graph).map);
  shapeton::EmbeddingCertificate       moved = still;
  const double                         c = std::cosh(0.8);
  const double                         s = std::sinh(0.8);
  std::vector<int>                     image(graph.nodes);
  shapeton::MoveEmbedding(moved, { 1, 0, 0, 0, 0, c, 0, s, 0, 0, 1, 0, 0, s, 0, c }); // a boost along y
  double farthest = 0.0;
  for (int v = 0; v < graph.nodes; ++v)
  {
    image[v] = v;
    farthest =
      std::max(farthest, shapeton::AngleBetween(shapeton::PlaceOnSphere(still, v), shapeton::PlaceOnSphere(moved, v)));
  }
  EXPECT_GT(farthest, 0.5);
  shapeton::MoveEmbedding(moved, shapeton::BestMotion(still, moved, image));
  for (int v = 0; v < graph.nodes; ++v)
  {
    EXPECT_LT(shapeton::AngleBetween(shapeton::PlaceOnSphere(still, v), shapeton::PlaceOnSphere(moved, v)), 1e-9);
    EXPECT_NEAR(moved.nodeRadii[v], still.nodeRadii[v], 1e-9);
  }
}

TEST(GraphComparison, IsAbortedByProgress)
{
  const shapeton::Graph one = WithNames(shapeton::GridGraph(8, 8));
  const shapeton::Graph other = WithNames(shapeton::GridGraph(16, 4));
  const auto work = [&](const shapeton::Progress & progress) { CompareGraphs(one, other, {}, {}, progress); };
  shapeton::test::ExpectProgress(work, 20);
}
