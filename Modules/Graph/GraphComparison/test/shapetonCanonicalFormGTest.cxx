#include "shapetonCanonicalForm.h"
#include "shapetonGraphFamilies.h"
#include "shapetonPhiloxStream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
shapeton::Graph
Shuffled(const shapeton::Graph & graph, std::uint32_t seed)
{
  shapeton::PhiloxStream random(seed, 0, 0);
  std::vector<int>       image(graph.nodes);
  std::iota(image.begin(), image.end(), 0);
  for (int i = graph.nodes; i > 1; --i)
  {
    std::swap(image[i - 1], image[random.Below(i)]);
  }
  shapeton::Graph result = shapeton::RelabeledGraph(graph, image);
  for (int i = static_cast<int>(result.edges.size()); i > 1; --i)
  {
    std::swap(result.edges[i - 1], result.edges[random.Below(i)]);
    std::swap(result.edges[i - 1][0], result.edges[i - 1][1]);
  }
  return result;
}

std::vector<std::array<int, 2>>
Sorted(std::vector<std::array<int, 2>> edges)
{
  for (auto & edge : edges)
  {
    edge = { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) };
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void
ExpectIsomorphic(const shapeton::Graph & a, const shapeton::Graph & b)
{
  const std::vector<int> image = shapeton::Isomorphism(shapeton::CanonicalForm(a), shapeton::CanonicalForm(b));
  ASSERT_EQ(image.size(), static_cast<std::size_t>(a.nodes));
  EXPECT_EQ(Sorted(shapeton::RelabeledGraph(a, image).edges), Sorted(b.edges));
}

bool
AreIsomorphic(const shapeton::Graph & a, const shapeton::Graph & b)
{
  return !shapeton::Isomorphism(shapeton::CanonicalForm(a), shapeton::CanonicalForm(b)).empty();
}
} // namespace

TEST(CanonicalForm, ShuffledGraphsBecomeTheSame)
{
  for (const shapeton::Graph & graph : { shapeton::PathGraph(1),
                                         shapeton::PathGraph(2),
                                         shapeton::Graph{ 5, {}, {} },
                                         shapeton::PathGraph(40),
                                         shapeton::GridGraph(12, 9),
                                         shapeton::HypercubeGraph(5),
                                         shapeton::GeneralizedPetersenGraph(10, 3),
                                         shapeton::CompleteGraph(20),
                                         shapeton::TorusGridMap(8, 8).ToGraph() })
  {
    for (std::uint32_t seed = 1; seed < 4; ++seed)
    {
      ExpectIsomorphic(graph, Shuffled(graph, seed));
    }
  }
}

TEST(CanonicalForm, LoopsAndMultipleEdgesCount)
{
  const shapeton::Graph graph{ 4, { { 0, 1 }, { 1, 0 }, { 1, 2 }, { 2, 3 }, { 3, 3 }, { 2, 2 }, { 2, 2 } }, {} };
  ExpectIsomorphic(graph, Shuffled(graph, 7));
  shapeton::Graph other = graph;
  other.edges[5] = { 3, 3 };
  EXPECT_FALSE(AreIsomorphic(graph, other));
  other = graph;
  other.edges[1] = { 1, 2 };
  EXPECT_FALSE(AreIsomorphic(graph, other));
  EXPECT_FALSE(AreIsomorphic({ 2, { { 0, 1 }, { 0, 1 } }, {} }, { 2, { { 0, 1 }, { 0, 1 }, { 0, 1 } }, {} }));
  EXPECT_FALSE(AreIsomorphic({ 1, { { 0, 0 } }, {} }, { 1, { { 0, 0 }, { 0, 0 } }, {} }));
}

TEST(CanonicalForm, RegularGraphsWithEqualCountsAreToldApart)
{
  // Cubic graphs with 20 nodes and girths 5 and 6 (dodecahedron, Desargues graph), and a prism and a Moebius ladder.
  EXPECT_FALSE(AreIsomorphic(shapeton::GeneralizedPetersenGraph(10, 2), shapeton::GeneralizedPetersenGraph(10, 3)));
  shapeton::Graph ladder = shapeton::CycleGraph(8);
  for (int i = 0; i < 4; ++i)
  {
    ladder.edges.push_back({ i, i + 4 });
  }
  EXPECT_FALSE(AreIsomorphic(ladder, shapeton::GeneralizedPetersenGraph(4, 1)));
  EXPECT_TRUE(AreIsomorphic(shapeton::GeneralizedPetersenGraph(4, 1), shapeton::HypercubeGraph(3)));
}

TEST(CanonicalForm, NamesFollowTheirNodes)
{
  shapeton::Graph graph = shapeton::PathGraph(3);
  graph.names = { "end", "middle", "other end" };
  const shapeton::CanonicalForm form(graph);
  for (int v = 0; v < 3; ++v)
  {
    EXPECT_EQ(form.graph.names[form.rank[v]], graph.names[v]);
  }
}

TEST(CanonicalForm, LargeGraphsTakeNoTime)
{
  const shapeton::Graph graph = shapeton::GridGraph(200, 150);
  ExpectIsomorphic(graph, Shuffled(graph, 3));
}
