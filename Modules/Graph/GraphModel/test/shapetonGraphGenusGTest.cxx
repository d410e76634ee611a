#include "shapetonGraphFamilies.h"
#include "shapetonProgressTests.h"
#include "shapetonTestGraphs.h"
#include "itkMultiThreaderBase.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
/** Checks that the map has the edges of the graph in the same order. Returns its genus. */
int
GenusOf(const shapeton::Graph & graph, const shapeton::SurfaceEmbedding & embedding)
{
  EXPECT_EQ(embedding.map.Nodes(), graph.nodes);
  EXPECT_EQ(embedding.map.ToGraph().edges, graph.edges);
  EXPECT_LE(embedding.lowerBound, embedding.map.Genus());
  EXPECT_EQ(embedding.minimal, embedding.map.Genus() == embedding.lowerBound);
  return embedding.map.Genus();
}

int
GenusOf(const shapeton::Graph & graph, const shapeton::GenusSettings & options = shapeton::GenusSettings())
{
  return GenusOf(graph, shapeton::FindEmbedding(graph, options));
}

/** Disjoint union of both graphs, or their union with one shared node. */
shapeton::Graph
Together(const shapeton::Graph & a, const shapeton::Graph & b, int common)
{
  shapeton::Graph result = a;
  result.nodes += b.nodes - common;
  for (const auto & edge : b.edges)
  {
    result.edges.push_back({ edge[0] + a.nodes - common, edge[1] + a.nodes - common });
  }
  return result;
}

/** Replaces each edge by a path of `pieces` edges and adds a leaf to each node and a parallel edge to each edge. */
shapeton::Graph
Decorated(const shapeton::Graph & graph, int pieces)
{
  shapeton::Graph result;
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
  for (const shapeton::Graph & graph :
       { shapeton::PathGraph(1),
         shapeton::PathGraph(2),
         shapeton::PathGraph(30),
         shapeton::CycleGraph(1),
         shapeton::CycleGraph(2),
         shapeton::CycleGraph(3),
         shapeton::Graph{ 4, {}, {} },
         shapeton::Graph{ 3, { { 0, 1 }, { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, 1 }, { 0, 0 } }, {} },
         shapeton::Graph{ 1, { { 0, 0 }, { 0, 0 }, { 0, 0 } }, {} },
         shapeton::GridGraph(9, 7),
         shapeton::WheelGraph(12) })
  {
    const shapeton::SurfaceEmbedding embedding = shapeton::FindEmbedding(graph);
    EXPECT_EQ(GenusOf(graph, embedding), 0);
    EXPECT_TRUE(embedding.minimal);
  }
}

TEST(GraphGenus, KnownGeneraOfSmallGraphs)
{
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(4)), 0);
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(5)), 1);
  EXPECT_EQ(GenusOf(shapeton::CompleteBipartiteGraph(3, 3)), 1);
  EXPECT_EQ(GenusOf(shapeton::CompleteBipartiteGraph(4, 4)), 1);
  EXPECT_EQ(GenusOf(shapeton::CompleteBipartiteGraph(5, 5)), 3);
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(7)), 1);
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(8)), 2);
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(9)), 3);
  EXPECT_EQ(GenusOf(shapeton::GeneralizedPetersenGraph(5, 2)), 1);
  EXPECT_EQ(GenusOf(shapeton::GeneralizedPetersenGraph(10, 3)), 2); // Desargues
  EXPECT_EQ(GenusOf(shapeton::HypercubeGraph(4)), 1);
  EXPECT_EQ(GenusOf(shapeton::HypercubeGraph(5)), 5);
}

TEST(GraphGenus, CompleteGraphsReachTheFormulaOfRingelAndYoungs)
{
  for (const int n : { 10, 12, 13 })
  {
    const shapeton::SurfaceEmbedding embedding = shapeton::FindEmbedding(shapeton::CompleteGraph(n));
    EXPECT_EQ(embedding.map.Genus(), ((n - 3) * (n - 4) + 11) / 12) << n;
    EXPECT_TRUE(embedding.minimal) << n;
  }
}

TEST(GraphGenus, ComponentsAndBlocksAddUp)
{
  const shapeton::Graph k5 = shapeton::CompleteGraph(5);
  EXPECT_EQ(GenusOf(Together(k5, shapeton::CompleteGraph(7), 0)), 2);
  EXPECT_EQ(GenusOf(Together(k5, shapeton::CompleteBipartiteGraph(3, 3), 1)), 2);
  shapeton::Graph mixed = Together(Together(k5, shapeton::GridGraph(4, 4), 1), shapeton::CompleteGraph(5), 1);
  mixed.edges.insert(mixed.edges.begin() + 3, { { 2, 2 }, { 0, 1 } });
  mixed.nodes += 2;
  const shapeton::SurfaceEmbedding embedding = shapeton::FindEmbedding(mixed);
  EXPECT_EQ(GenusOf(mixed, embedding), 2);
  EXPECT_TRUE(embedding.minimal);
  EXPECT_EQ(embedding.map.Components(), 3);
}

TEST(GraphGenus, DecorationsChangeNoGenus)
{
  for (int pieces = 1; pieces < 4; ++pieces)
  {
    EXPECT_EQ(GenusOf(Decorated(shapeton::GridGraph(4, 4), pieces)), 0);
    EXPECT_EQ(GenusOf(Decorated(shapeton::CompleteGraph(5), pieces)), 1);
    EXPECT_EQ(GenusOf(Decorated(shapeton::CompleteGraph(8), pieces)), 2);
  }
}

TEST(GraphGenus, GenusThatIsAskedForIsReachedOrRefused)
{
  shapeton::GenusSettings options;
  for (const int genus : { 1, 2, 3 }) // 3 is the maximum genus of K5
  {
    options.genus = genus;
    EXPECT_EQ(GenusOf(shapeton::CompleteGraph(5), options), genus);
  }
  options.genus = 4;
  EXPECT_THROW(shapeton::FindEmbedding(shapeton::CompleteGraph(5), options), shapeton::InputError);
  options.genus = 0;
  EXPECT_THROW(shapeton::FindEmbedding(shapeton::CompleteGraph(5), options), shapeton::InputError);
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(4), options), 0);
  options.genus = 1;
  EXPECT_EQ(GenusOf(shapeton::CompleteGraph(4), options), 1);
  EXPECT_THROW(shapeton::FindEmbedding(shapeton::PathGraph(5), options), shapeton::InputError);
}

TEST(GraphGenus, WrongOptionsAreRefused)
{
  shapeton::GenusSettings options;
  options.restarts = 0;
  EXPECT_THROW(shapeton::FindEmbedding(shapeton::PathGraph(2), options), shapeton::ParameterError);
  options = shapeton::GenusSettings();
  options.effort = 0.0;
  EXPECT_THROW(shapeton::FindEmbedding(shapeton::PathGraph(2), options), shapeton::ParameterError);
  options = shapeton::GenusSettings();
  options.genus = -2;
  EXPECT_THROW(shapeton::FindEmbedding(shapeton::PathGraph(2), options), shapeton::ParameterError);
  EXPECT_THROW(shapeton::FindEmbedding({}, shapeton::GenusSettings()), shapeton::InputError);
}

TEST(GraphGenus, ThreadsAndRunsAgreeAndSeedsDiffer)
{
  const auto nextAround = [](unsigned int threads, std::uint64_t seed) {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    shapeton::GenusSettings options;
    options.seed = seed;
    options.effort = 0.05;
    return shapeton::FindEmbedding(Together(shapeton::CompleteGraph(9), shapeton::CompleteGraph(8), 1), options)
      .map.GetRotation();
  };
  const auto one = nextAround(1, 1);
  EXPECT_EQ(nextAround(4, 1), one);
  EXPECT_EQ(nextAround(2, 1), one);
  EXPECT_NE(nextAround(1, 2), one);
}

TEST(GraphGenus, LowerBoundsOfKnownGraphs)
{
  EXPECT_EQ(shapeton::GenusLowerBound(shapeton::CompleteGraph(4)), 0);
  EXPECT_EQ(shapeton::GenusLowerBound(shapeton::CompleteGraph(8)), 2);
  EXPECT_EQ(shapeton::GenusLowerBound(shapeton::CompleteBipartiteGraph(5, 5)), 3);
  EXPECT_EQ(shapeton::GenusLowerBound(shapeton::GeneralizedPetersenGraph(5, 2)), 1);
  EXPECT_EQ(shapeton::GenusLowerBound(shapeton::GeneralizedPetersenGraph(10, 3)), 1);
}

TEST(GraphGenus, LargeTiledSurfacesAreFound)
{
  EXPECT_EQ(GenusOf(graphtest::Shuffled(shapeton::TorusGridMap(100, 100).ToGraph())), 1);
  EXPECT_EQ(GenusOf(graphtest::Shuffled(shapeton::TorusGridMap(70, 50, true).ToGraph())), 1);
}

TEST(GraphGenus, SearchesAreAbortedByProgress)
{
  for (const unsigned int threads : { 1U, 3U })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    const auto work = [](const shapeton::Progress & progress) {
      shapeton::GenusSettings options;
      options.restarts = 3;
      options.effort = 0.2;
      options.progress = progress;
      shapeton::FindEmbedding(shapeton::CompleteGraph(16), options); // far from its bound
    };
    shapeton::test::ExpectProgress(work, threads == 1 ? 20 : 2); // only one thread reports progress
  }
}
