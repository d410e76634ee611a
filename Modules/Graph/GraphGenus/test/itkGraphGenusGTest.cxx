#include "itkGraphFamilies.h"
#include "itkGraphGenus.h"
#include "itkMultiThreaderBase.h"
#include "itkExceptions.h"

#include <gtest/gtest.h>

namespace
{
/** The map is one of the graph: same edges in the same order. Returns its genus. */
int
GenusOf(const itk::Graph & graph, const itk::SurfaceEmbedding & embedding)
{
  EXPECT_EQ(embedding.map.Nodes(), graph.nodes);
  EXPECT_EQ(embedding.map.ToGraph().edges, graph.edges);
  EXPECT_LE(embedding.lowerBound, embedding.map.Genus());
  EXPECT_EQ(embedding.minimal, embedding.map.Genus() == embedding.lowerBound);
  return embedding.map.Genus();
}

int
GenusOf(const itk::Graph & graph, const itk::GenusOptions & options = itk::GenusOptions())
{
  return GenusOf(graph, itk::FindEmbedding(graph, options));
}

/** Both graphs side by side, or with one node in common. */
itk::Graph
Together(const itk::Graph & a, const itk::Graph & b, int common)
{
  itk::Graph result = a;
  result.nodes += b.nodes - common;
  for (const auto & edge : b.edges)
  {
    result.edges.push_back({ edge[0] + a.nodes - common, edge[1] + a.nodes - common });
  }
  return result;
}

/** Each edge as a path of `pieces` edges, each node with a leaf, each edge with a parallel one. */
itk::Graph
Decorated(const itk::Graph & graph, int pieces)
{
  itk::Graph result;
  result.nodes = 2 * graph.nodes;
  for (int v = 0; v < graph.nodes; ++v)
  {
    result.edges.push_back({ v, graph.nodes + v });
  }
  for (const auto & edge : graph.edges)
  {
    int last = edge[0];
    for (int i = 1; i < pieces; ++i)
    {
      result.edges.push_back({ result.nodes, last });
      last = result.nodes++;
    }
    result.edges.push_back({ last, edge[1] });
    result.edges.push_back({ edge[1], edge[0] });
  }
  return result;
}
} // namespace

TEST(GraphGenus, TrivialGraphsArePlanar)
{
  for (const itk::Graph & graph : { itk::PathGraph(1),
                                    itk::PathGraph(2),
                                    itk::PathGraph(30),
                                    itk::CycleGraph(1),
                                    itk::CycleGraph(2),
                                    itk::CycleGraph(3),
                                    itk::Graph{ 4, {}, {} },
                                    itk::Graph{ 3, { { 0, 1 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, 1 }, { 0, 0 } }, {} },
                                    itk::Graph{ 1, { { 0, 0 }, { 0, 0 }, { 0, 0 } }, {} },
                                    itk::GridGraph(9, 7),
                                    itk::WheelGraph(12) })
  {
    const itk::SurfaceEmbedding embedding = itk::FindEmbedding(graph);
    EXPECT_EQ(GenusOf(graph, embedding), 0);
    EXPECT_TRUE(embedding.minimal);
  }
}

TEST(GraphGenus, KnownGeneraOfSmallGraphs)
{
  EXPECT_EQ(GenusOf(itk::CompleteGraph(4)), 0);
  EXPECT_EQ(GenusOf(itk::CompleteGraph(5)), 1);
  EXPECT_EQ(GenusOf(itk::CompleteBipartiteGraph(3, 3)), 1);
  EXPECT_EQ(GenusOf(itk::CompleteBipartiteGraph(4, 4)), 1);
  EXPECT_EQ(GenusOf(itk::CompleteBipartiteGraph(5, 5)), 3);
  EXPECT_EQ(GenusOf(itk::CompleteGraph(7)), 1);
  EXPECT_EQ(GenusOf(itk::CompleteGraph(8)), 2);
  EXPECT_EQ(GenusOf(itk::CompleteGraph(9)), 3);
  EXPECT_EQ(GenusOf(itk::GeneralizedPetersenGraph(5, 2)), 1);
  EXPECT_EQ(GenusOf(itk::GeneralizedPetersenGraph(10, 3)), 2); // Desargues
  EXPECT_EQ(GenusOf(itk::HypercubeGraph(4)), 1);
  EXPECT_EQ(GenusOf(itk::HypercubeGraph(5)), 5);
}

TEST(GraphGenus, CompleteGraphsReachTheFormulaOfRingelAndYoungs)
{
  for (const int n : { 10, 12, 13 })
  {
    const itk::SurfaceEmbedding embedding = itk::FindEmbedding(itk::CompleteGraph(n));
    EXPECT_EQ(embedding.map.Genus(), ((n - 3) * (n - 4) + 11) / 12) << n;
    EXPECT_TRUE(embedding.minimal) << n;
  }
}

TEST(GraphGenus, ComponentsAndBlocksAddUp)
{
  const itk::Graph k5 = itk::CompleteGraph(5);
  EXPECT_EQ(GenusOf(Together(k5, itk::CompleteGraph(7), 0)), 2);
  EXPECT_EQ(GenusOf(Together(k5, itk::CompleteBipartiteGraph(3, 3), 1)), 2);
  itk::Graph mixed = Together(Together(k5, itk::GridGraph(4, 4), 1), itk::CompleteGraph(5), 1);
  mixed.edges.insert(mixed.edges.begin() + 3, { { 2, 2 }, { 0, 1 } });
  mixed.nodes += 2;
  const itk::SurfaceEmbedding embedding = itk::FindEmbedding(mixed);
  EXPECT_EQ(GenusOf(mixed, embedding), 2);
  EXPECT_TRUE(embedding.minimal);
  EXPECT_EQ(embedding.map.Components(), 3);
}

TEST(GraphGenus, DecorationsChangeNoGenus)
{
  for (int pieces = 1; pieces < 4; ++pieces)
  {
    EXPECT_EQ(GenusOf(Decorated(itk::GridGraph(4, 4), pieces)), 0);
    EXPECT_EQ(GenusOf(Decorated(itk::CompleteGraph(5), pieces)), 1);
    EXPECT_EQ(GenusOf(Decorated(itk::CompleteGraph(8), pieces)), 2);
  }
}

TEST(GraphGenus, GenusThatIsAskedForIsReachedOrRefused)
{
  itk::GenusOptions options;
  for (options.genus = 1; options.genus <= 3; ++options.genus) // 3 is the greatest one of K5
  {
    EXPECT_EQ(GenusOf(itk::CompleteGraph(5), options), options.genus);
  }
  EXPECT_THROW(itk::FindEmbedding(itk::CompleteGraph(5), options), itk::InputError);
  options.genus = 0;
  EXPECT_THROW(itk::FindEmbedding(itk::CompleteGraph(5), options), itk::InputError);
  EXPECT_EQ(GenusOf(itk::CompleteGraph(4), options), 0);
  options.genus = 1;
  EXPECT_EQ(GenusOf(itk::CompleteGraph(4), options), 1);
  EXPECT_THROW(itk::FindEmbedding(itk::PathGraph(5), options), itk::InputError);
}

TEST(GraphGenus, WrongOptionsAreRefused)
{
  itk::GenusOptions options;
  options.restarts = 0;
  EXPECT_THROW(itk::FindEmbedding(itk::PathGraph(2), options), itk::ParameterError);
  options = itk::GenusOptions();
  options.effort = 0.0;
  EXPECT_THROW(itk::FindEmbedding(itk::PathGraph(2), options), itk::ParameterError);
  options = itk::GenusOptions();
  options.genus = -2;
  EXPECT_THROW(itk::FindEmbedding(itk::PathGraph(2), options), itk::ParameterError);
  EXPECT_THROW(itk::FindEmbedding({}, itk::GenusOptions()), itk::InputError);
}

TEST(GraphGenus, GeneticAlgorithmGivesAMapOfTheGraph)
{
  itk::GenusOptions options;
  options.method = itk::GenusMethod::Genetic;
  EXPECT_LE(GenusOf(itk::CompleteGraph(5), options), 2);
  EXPECT_LE(GenusOf(itk::CompleteGraph(7), options), 5);
  EXPECT_EQ(GenusOf(itk::PathGraph(5), options), 0);
  EXPECT_EQ(GenusOf(itk::Graph{ 3, { { 0, 1 } }, {} }, options), 0);
}

TEST(GraphGenus, ThreadsAndRunsAgreeAndSeedsDiffer)
{
  const auto nextAround = [](unsigned int threads, std::uint64_t seed) {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    itk::GenusOptions options;
    options.seed = seed;
    options.effort = 0.05;
    return itk::FindEmbedding(Together(itk::CompleteGraph(9), itk::CompleteGraph(8), 1), options).map.GetRotation();
  };
  const auto one = nextAround(1, 1);
  EXPECT_EQ(nextAround(4, 1), one);
  EXPECT_EQ(nextAround(2, 1), one);
  EXPECT_NE(nextAround(1, 2), one);
}

TEST(GraphGenus, LowerBoundsOfKnownGraphs)
{
  EXPECT_EQ(itk::GenusLowerBound(itk::CompleteGraph(4)), 0);
  EXPECT_EQ(itk::GenusLowerBound(itk::CompleteGraph(8)), 2);
  EXPECT_EQ(itk::GenusLowerBound(itk::CompleteBipartiteGraph(5, 5)), 3);
  EXPECT_EQ(itk::GenusLowerBound(itk::GeneralizedPetersenGraph(5, 2)), 1);
  EXPECT_EQ(itk::GenusLowerBound(itk::GeneralizedPetersenGraph(10, 3)), 1);
}

TEST(GraphGenus, PlanarGraphOfManyNodes)
{
  const itk::Graph      graph = itk::GridGraph(300, 300);
  itk::CombinatorialMap map;
  ASSERT_TRUE(itk::FindPlanarEmbedding(graph, map));
  EXPECT_EQ(map.Genus(), 0);
  EXPECT_FALSE(itk::FindPlanarEmbedding(itk::CompleteGraph(5), map));
}

TEST(GraphGenus, LargeTiledSurfacesAreFound)
{
  const auto shuffled = [](const itk::Graph & graph) {
    std::vector<int> image(graph.nodes);
    for (int v = 0; v < graph.nodes; ++v)
    {
      image[v] = static_cast<int>((7919LL * v + 11) % graph.nodes); // 7919 is a prime
    }
    return itk::RelabelledGraph(graph, image);
  };
  EXPECT_EQ(GenusOf(shuffled(itk::TorusGridMap(100, 100).ToGraph())), 1);
  EXPECT_EQ(GenusOf(shuffled(itk::TorusGridMap(70, 50, true).ToGraph())), 1);
}
