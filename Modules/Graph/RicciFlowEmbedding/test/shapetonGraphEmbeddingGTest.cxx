#include "shapetonGraphEmbedding.h"

#include "shapetonBlockArrangement.h"
#include "shapetonCanonicalMapOrder.h"
#include "shapetonGraphFamilies.h"
#include "shapetonProgressTests.h"
#include "shapetonSplitArrangement.h"
#include "shapetonTestGraphs.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace
{
/** A triangulation of the sphere: nodes inserted into pseudorandom triangles. */
shapeton::CombinatorialMap
StackedTriangles(int nodes)
{
  unsigned int state = 12345;
  return graphtest::PlanarMap(graphtest::StackedTriangles(nodes, [&state](unsigned int triangles) {
    state = state * 1664525U + 1013904223U;
    return (state >> 8) % triangles;
  }));
}

/** The same map with nodes and edges renumbered. */
shapeton::CombinatorialMap
Renumbered(const shapeton::CombinatorialMap & map, std::vector<int> & image)
{
  const auto stride = [](int number) {
    std::vector<int> list(number);
    for (int i = 0; i < number; ++i)
    {
      list[i] = static_cast<int>((7LL * i + 3) % number);
    }
    return list;
  };
  image = stride(map.Nodes());
  const std::vector<int>          edgeImage = stride(map.Edges());
  std::vector<std::array<int, 2>> edges(map.Edges());
  std::vector<int>                next(map.HalfEdges());
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    const int to = 2 * edgeImage[h / 2] + h % 2;
    edges[to / 2][to % 2] = image[map.Node(h)];
    next[to] = 2 * edgeImage[map.NextAround(h) / 2] + map.NextAround(h) % 2;
  }
  return { map.Nodes(), edges, next };
}

double
Statistic(const shapeton::EmbeddingCertificate & certificate, const std::string & name)
{
  return std::map<std::string, double>(certificate.statistics.begin(), certificate.statistics.end()).at(name);
}
} // namespace

TEST(GraphEmbedding, ThreeConnectedGraphsAgreeWhateverTheirNumbersAndSide)
{
  const shapeton::CombinatorialMap map = StackedTriangles(80);
  std::vector<int>                 image;
  const shapeton::CombinatorialMap other = Renumbered(map, image).Mirrored();
  shapeton::GraphEmbeddingSettings options;
  options.isRotationFree = true;
  const auto one = shapeton::EmbedGraph(map.ToGraph(), map, options);
  const auto two = shapeton::EmbedGraph(other.ToGraph(), other, options);
  for (int node = 0; node < map.Nodes(); ++node)
  {
    EXPECT_NEAR(one.nodeRadii[node], two.nodeRadii[image[node]], 1e-9);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(one.nodePositions[3 * node + i], two.nodePositions[3 * image[node] + i], 1e-9);
    }
  }
}

TEST(GraphEmbedding, BothPointsAtInfinityGiveTheSamePlaces)
{
  const shapeton::CombinatorialMap map = StackedTriangles(60);
  shapeton::GraphEmbeddingSettings options;
  const auto                       circle = shapeton::EmbedGraph(map.ToGraph(), map, options);
  options.infinity = shapeton::PointAtInfinity::EdgeNode;
  const auto edgeNode = shapeton::EmbedGraph(map.ToGraph(), map, options);
  for (std::size_t i = 0; i < circle.nodePositions.size(); ++i)
  {
    EXPECT_NEAR(circle.nodePositions[i], edgeNode.nodePositions[i], 1e-9);
  }
}

TEST(GraphEmbedding, TheSameBytesForAnyNumberOfThreads)
{
  const shapeton::CombinatorialMap torus = shapeton::TorusGridMap(70, 90, true);
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const auto certificate = shapeton::EmbedGraph(torus.ToGraph(), torus);
      return std::make_pair(certificate.nodeRadii, certificate.nodePositions);
    },
    { 3 });
}

TEST(GraphEmbedding, ALongPathKeepsItsCirclesLarge)
{
  const shapeton::CombinatorialMap map = graphtest::AnyMap(shapeton::PathGraph(80));
  const auto                       certificate = shapeton::EmbedGraph(map.ToGraph(), map);
  EXPECT_GT(Statistic(certificate, "smallestRadius"), 1e-5);
  EXPECT_LE(Statistic(certificate, "residual"), 1e-12);
}

TEST(GraphEmbedding, NestedTrianglesAreEmbeddedWithAWarning)
{
  // In nested triangles radii decrease by a constant factor.
  shapeton::Graph graph{ 60, {}, {} };
  for (int node = 0; node < graph.nodes; ++node)
  {
    graph.edges.push_back({ node, node - node % 3 + (node + 1) % 3 });
    if (node + 3 < graph.nodes)
    {
      graph.edges.push_back({ node, node + 3 });
    }
  }
  const shapeton::CombinatorialMap map = graphtest::PlanarMap(graph);
  ASSERT_EQ(map.Genus(), 0);
  const auto certificate = shapeton::EmbedGraph(graph, map);
  EXPECT_EQ(certificate.packed.nodes, graph.nodes);
  EXPECT_LE(Statistic(certificate, "residual"), 1e-12);
  EXPECT_EQ(certificate.warnings.empty(), Statistic(certificate, "smallestRadius") > shapeton::smallestLegibleRadius);
}

TEST(GraphEmbedding, BlocksOfAFaceComeOutOfIt)
{
  // Two triangles with a common node, first nested, then side by side with faces of length 3, 3 and 6.
  const shapeton::Graph            graph{ 5, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 3, 4 }, { 4, 0 } }, {} };
  const shapeton::CombinatorialMap mixed(graph, { { 0, 6, 5, 11 }, { 1, 2 }, { 3, 4 }, { 7, 8 }, { 9, 10 } });
  ASSERT_EQ(mixed.Genus(), 1);
  const shapeton::CombinatorialMap arranged = shapeton::ArrangeBlocks(mixed);
  EXPECT_EQ(arranged.Genus(), 0);
  std::vector<int> lengths = arranged.FaceLengths();
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<int>{ 3, 3, 6 }));
}

TEST(GraphEmbedding, LargerSplitComponentsComeNearerToTheMiddle)
{
  // Nodes 0 and 1 with the edge 0 and paths of 1, 2, ... 5 inner nodes between them, in this order.
  shapeton::Graph    graph{ 2, { { 0, 1 } }, {} };
  shapeton::Rotation rotation{ { 0 }, { 1 } };
  for (int inner = 1; inner <= 5; ++inner)
  {
    int last = 0;
    for (int i = 0; i <= inner; ++i)
    {
      const int next = i < inner ? graph.nodes++ : 1;
      const int h = 2 * static_cast<int>(graph.edges.size());
      rotation.resize(graph.nodes);
      graph.edges.push_back({ last, next });
      rotation[last].push_back(h);
      rotation[next].insert(next == 1 ? rotation[1].begin() : rotation[next].end(), h + 1);
      last = next;
    }
  }
  const shapeton::CombinatorialMap map(graph, rotation);
  ASSERT_EQ(map.Genus(), 0);
  const shapeton::CombinatorialMap arranged = shapeton::ArrangeSplitComponents(map);
  EXPECT_EQ(arranged.Genus(), 0);
  EXPECT_EQ(arranged.ToGraph().edges, graph.edges);
  std::vector<int> sizes; // lengths of the paths around node 0, starting at the edge
  for (const int h : arranged.Around(0))
  {
    int node = arranged.Node(h + 1);
    int size = 0;
    for (int along = h; node != 1; ++size)
    {
      along = arranged.NextAround(shapeton::CombinatorialMap::Twin(along));
      node = arranged.Node(shapeton::CombinatorialMap::Twin(along));
    }
    sizes.push_back(size);
  }
  EXPECT_EQ(sizes, (std::vector<int>{ 0, 1, 3, 5, 4, 2 }));
}

TEST(GraphEmbedding, RungsOfALadderComeToTheSameSide)
{
  constexpr int      rungs = 12;
  shapeton::Graph    ladder{ 2 * rungs, {}, {} };
  shapeton::Rotation rotation(ladder.nodes);
  for (int i = 0; i < rungs; ++i) // edges 3 i: rung, 3 i + 1 and 3 i + 2: rails
  {
    ladder.edges.push_back({ i, rungs + i });
    if (i + 1 < rungs)
    {
      ladder.edges.insert(ladder.edges.end(), { { i, i + 1 }, { rungs + i, rungs + i + 1 } });
    }
    const std::vector<int> forth = i + 1 < rungs ? std::vector<int>{ 6 * i + 2, 6 * i + 4 } : std::vector<int>{};
    const std::vector<int> back = i > 0 ? std::vector<int>{ 6 * i - 3, 6 * i - 1 } : std::vector<int>{};
    for (int side = 0; side < 2; ++side)
    {
      std::vector<int> & around = rotation[side * rungs + i];
      around.push_back(6 * i + side);
      for (const std::vector<int> & along : (i + side) % 2 == 0 ? std::array{ forth, back } : std::array{ back, forth })
      {
        around.insert(
          around.end(), along.begin() + (along.empty() ? 0 : side), along.end() - (along.empty() ? 0 : 1 - side));
      }
    }
  }
  const shapeton::CombinatorialMap map(ladder, rotation);
  ASSERT_EQ(map.Genus(), 0);
  const auto longest = [](const shapeton::CombinatorialMap & m) {
    const std::vector<int> lengths = m.FaceLengths();
    return *std::max_element(lengths.begin(), lengths.end());
  };
  ASSERT_LT(longest(map), 8);
  const shapeton::CombinatorialMap arranged = shapeton::ArrangeSplitComponents(map);
  EXPECT_EQ(arranged.Genus(), 0);
  EXPECT_EQ(longest(arranged), 2 * rungs);
}

TEST(GraphEmbedding, SplitComponentsWithEqualSidesStayAsTheyAre)
{
  const shapeton::CombinatorialMap map = StackedTriangles(40); // 3-connected
  EXPECT_EQ(shapeton::ArrangeSplitComponents(map).GetRotation(), map.GetRotation());
  const shapeton::Graph            theta{ 4, { { 0, 1 }, { 0, 2 }, { 2, 1 }, { 0, 3 }, { 3, 1 } }, {} };
  const shapeton::CombinatorialMap three(theta, { { 0, 2, 6 }, { 1, 9, 5 }, { 3, 4 }, { 7, 8 } });
  ASSERT_EQ(three.Genus(), 0);
  EXPECT_EQ(shapeton::ArrangeSplitComponents(three).GetRotation(), three.GetRotation());
}

namespace
{
/** Each generation adds a node for every edge, joined to both ends of the edge (Dorogovtsev, Goltsev and Mendes). */
struct NestedTriangles
{
  explicit NestedTriangles(int generations)
  {
    std::vector<int> first;
    std::vector<int> second;
    rotation.resize(2);
    graph.edges.push_back({ 0, 1 });
    this->Grow(0, generations, first, second);
    rotation[0] = first;
    rotation[1].assign(second.rbegin(), second.rend());
  }
  /** Half-edges of an edge and its subgraph to the left: counter-clockwise around the first node, clockwise around the
   * second. */
  void
  Grow(int edge, int generations, std::vector<int> & first, std::vector<int> & second)
  {
    first.push_back(2 * edge);
    second.push_back(2 * edge + 1);
    for (int rest = generations - 1; rest >= 0; --rest)
    {
      const int node = graph.nodes++;
      const int before = static_cast<int>(graph.edges.size());
      graph.edges.push_back({ graph.edges[edge][0], node });
      graph.edges.push_back({ node, graph.edges[edge][1] });
      std::vector<int> arriving;
      std::vector<int> leaving;
      this->Grow(before, rest, first, arriving);
      this->Grow(before + 1, rest, leaving, second);
      leaving.insert(leaving.end(), arriving.rbegin(), arriving.rend());
      rotation.resize(graph.nodes);
      rotation[node] = leaving;
    }
  }
  shapeton::Graph    graph{ 2, {}, {} };
  shapeton::Rotation rotation;
};
} // namespace

TEST(GraphEmbedding, NestedSplitComponentsComeSideBySide)
{
  const NestedTriangles            nested(5);
  const shapeton::CombinatorialMap map(nested.graph, nested.rotation);
  ASSERT_EQ(map.Genus(), 0);
  ASSERT_EQ(map.Nodes(), 123);
  shapeton::GraphEmbeddingSettings options;
  const double given = Statistic(shapeton::EmbedGraph(map.ToGraph(), map, options), "smallestRadius");
  options.isRotationFree = true;
  const auto   certificate = shapeton::EmbedGraph(map.ToGraph(), map, options);
  const double arranged = Statistic(certificate, "smallestRadius");
  EXPECT_LT(given, 1e-5);
  EXPECT_GT(arranged, 3e-4);
  EXPECT_LE(Statistic(certificate, "residual"), 1e-12);
}

TEST(GraphEmbedding, TheCanonicalOrderIsThatOfTheMapAlone)
{
  const shapeton::CombinatorialMap  map = StackedTriangles(50);
  std::vector<int>                  image;
  const shapeton::CombinatorialMap  other = Renumbered(map, image);
  const shapeton::CanonicalMapOrder one(map, true);
  const shapeton::CanonicalMapOrder two(other.Mirrored(), true);
  EXPECT_NE(one.isMirrored, two.isMirrored);
  for (int node = 0; node < map.Nodes(); ++node)
  {
    EXPECT_EQ(one.rank[node], two.rank[image[node]]);
  }
}

TEST(GraphEmbedding, IsAbortedByProgressOnEachSurface)
{
  const shapeton::CombinatorialMap sphere = StackedTriangles(400);
  const shapeton::CombinatorialMap torus = shapeton::TorusGridMap(20, 20, true);
  for (const shapeton::CombinatorialMap & map : { sphere, torus })
  {
    const auto work = [&](const shapeton::Progress & progress) {
      shapeton::GraphEmbeddingSettings options;
      options.progress = progress;
      EmbedGraph(map.ToGraph(), map, options);
    };
    shapeton::test::ExpectProgress(work, 6); // the initial radii are exact on the regular torus
  }
}
