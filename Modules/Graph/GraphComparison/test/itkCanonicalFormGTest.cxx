#include "itkCanonicalForm.h"
#include "itkGraphFamilies.h"
#include "itkPhiloxStream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{
itk::Graph
Shuffled(const itk::Graph & graph, std::uint32_t seed)
{
  itk::PhiloxStream random(seed, 0, 0);
  std::vector<int>  image(graph.nodes);
  std::iota(image.begin(), image.end(), 0);
  for (int i = graph.nodes; i > 1; --i)
  {
    std::swap(image[i - 1], image[random.Below(i)]);
  }
  itk::Graph result = itk::RelabelledGraph(graph, image);
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
ExpectIsomorphic(const itk::Graph & a, const itk::Graph & b)
{
  const std::vector<int> image = itk::Isomorphism(itk::CanonicalForm(a), itk::CanonicalForm(b));
  ASSERT_EQ(image.size(), static_cast<std::size_t>(a.nodes));
  EXPECT_EQ(Sorted(itk::RelabelledGraph(a, image).edges), Sorted(b.edges));
}

bool
AreIsomorphic(const itk::Graph & a, const itk::Graph & b)
{
  return !itk::Isomorphism(itk::CanonicalForm(a), itk::CanonicalForm(b)).empty();
}
} // namespace

TEST(CanonicalForm, ShuffledGraphsBecomeTheSame)
{
  for (const itk::Graph & graph : { itk::PathGraph(1),
                                    itk::PathGraph(2),
                                    itk::Graph{ 5, {}, {} },
                                    itk::PathGraph(40),
                                    itk::GridGraph(12, 9),
                                    itk::HypercubeGraph(5),
                                    itk::GeneralizedPetersenGraph(10, 3),
                                    itk::CompleteGraph(20),
                                    itk::TorusGridMap(8, 8).ToGraph() })
  {
    for (std::uint32_t seed = 1; seed < 4; ++seed)
    {
      ExpectIsomorphic(graph, Shuffled(graph, seed));
    }
  }
}

TEST(CanonicalForm, LoopsAndMultipleEdgesCount)
{
  const itk::Graph graph{ 4, { { 0, 1 }, { 1, 0 }, { 1, 2 }, { 2, 3 }, { 3, 3 }, { 2, 2 }, { 2, 2 } }, {} };
  ExpectIsomorphic(graph, Shuffled(graph, 7));
  itk::Graph other = graph;
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
  // Both cubic with 20 nodes, girth 5 and 6: dodecahedron and Desargues; and a prism beside a Moebius ladder.
  EXPECT_FALSE(AreIsomorphic(itk::GeneralizedPetersenGraph(10, 2), itk::GeneralizedPetersenGraph(10, 3)));
  itk::Graph ladder = itk::CycleGraph(8);
  for (int i = 0; i < 4; ++i)
  {
    ladder.edges.push_back({ i, i + 4 });
  }
  EXPECT_FALSE(AreIsomorphic(ladder, itk::GeneralizedPetersenGraph(4, 1)));
  EXPECT_TRUE(AreIsomorphic(itk::GeneralizedPetersenGraph(4, 1), itk::HypercubeGraph(3)));
}

TEST(CanonicalForm, NamesFollowTheirNodes)
{
  itk::Graph graph = itk::PathGraph(3);
  graph.names = { "end", "middle", "other end" };
  const itk::CanonicalForm form(graph);
  for (int v = 0; v < 3; ++v)
  {
    EXPECT_EQ(form.graph.names[form.rank[v]], graph.names[v]);
  }
}

TEST(CanonicalForm, LargeGraphsTakeNoTime)
{
  const itk::Graph graph = itk::GridGraph(200, 150);
  ExpectIsomorphic(graph, Shuffled(graph, 3));
}
