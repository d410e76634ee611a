#include "shapetonGraphCurvature.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphReader.h"
#include "shapetonGraphStructure.h"
#include "shapetonTestErrors.h"
#include "shapetonTestGraphs.h"
#include "shapetonTestThreads.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>

using shapeton::CurvatureMethod;
using shapeton::Graph;

namespace
{
shapeton::GraphCurvature
Curvature(const Graph & graph, CurvatureMethod method = CurvatureMethod::Ollivier, double idleness = 0.0)
{
  shapeton::GraphCurvatureSettings settings;
  settings.method = method;
  settings.idleness = idleness;
  return MeasureCurvature(graph, settings);
}

std::vector<std::vector<int>>
AllDistances(const Graph & graph)
{
  constexpr int                 far = 1000000;
  std::vector<std::vector<int>> d(graph.nodes, std::vector<int>(graph.nodes, far));
  for (int v = 0; v < graph.nodes; ++v)
  {
    d[v][v] = 0;
  }
  for (const auto & [a, b] : graph.edges)
  {
    if (a != b)
    {
      d[a][b] = d[b][a] = 1;
    }
  }
  for (int k = 0; k < graph.nodes; ++k)
  {
    for (int i = 0; i < graph.nodes; ++i)
    {
      for (int j = 0; j < graph.nodes; ++j)
      {
        d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
      }
    }
  }
  return d;
}

/** Minimum cost of an n-to-n assignment, by the Hungarian algorithm with potentials. */
long
Assignment(const std::vector<std::vector<int>> & cost)
{
  const int         n = static_cast<int>(cost.size());
  const long        infinite = std::numeric_limits<long>::max() / 4;
  std::vector<long> u(n + 1, 0), v(n + 1, 0);
  std::vector<int>  match(n + 1, 0), way(n + 1, 0);
  for (int i = 1; i <= n; ++i)
  {
    match[0] = i;
    int               column = 0;
    std::vector<long> least(n + 1, infinite);
    std::vector<bool> isUsed(n + 1, false);
    do
    {
      isUsed[column] = true;
      const int row = match[column];
      long      delta = infinite;
      int       next = 0;
      for (int j = 1; j <= n; ++j)
      {
        if (!isUsed[j])
        {
          const long reduced = cost[row - 1][j - 1] - u[row] - v[j];
          if (reduced < least[j])
          {
            least[j] = reduced;
            way[j] = column;
          }
          if (least[j] < delta)
          {
            delta = least[j];
            next = j;
          }
        }
      }
      for (int j = 0; j <= n; ++j)
      {
        if (isUsed[j])
        {
          u[match[j]] += delta;
          v[j] -= delta;
        }
        else
        {
          least[j] -= delta;
        }
      }
      column = next;
    } while (match[column] != 0);
    do
    {
      const int before = way[column];
      match[column] = match[before];
      column = before;
    } while (column != 0);
  }
  return -v[0];
}

/** The walk from a node as a list of equally heavy atoms: `units` in all, a fraction p / q of them idle. */
std::vector<int>
Atoms(const Graph & graph, int node, long units, long p, long q)
{
  std::vector<int> ends;
  for (const auto & [a, b] : graph.edges)
  {
    if (a == node)
    {
      ends.push_back(b);
    }
    if (b == node)
    {
      ends.push_back(a);
    }
  }
  std::vector<int> atoms(units / q * p, node);
  const long       each = (units - static_cast<long>(atoms.size())) / static_cast<long>(ends.size());
  for (const int end : ends)
  {
    atoms.insert(atoms.end(), each, end);
  }
  return atoms;
}

/** Number of equally heavy atoms that both walks can be cut into; `q` is the denominator of the idleness. */
long
Units(const Graph & graph, int a, int b, long q)
{
  const shapeton::Incidence incidence(graph);
  return q * std::lcm(static_cast<long>(incidence.Degree(a)), static_cast<long>(incidence.Degree(b)));
}

/** Unreduced numerator and denominator of 1 - W, found by assigning atoms with distances in the whole graph. */
std::pair<long, long>
BruteForce(const Graph & graph, const std::vector<std::vector<int>> & d, int a, int b, long p, long q)
{
  const long                    units = Units(graph, a, b, q);
  const std::vector<int>        from = Atoms(graph, a, units, p, q);
  const std::vector<int>        to = Atoms(graph, b, units, p, q);
  std::vector<std::vector<int>> cost(from.size(), std::vector<int>(to.size()));
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    for (std::size_t j = 0; j < to.size(); ++j)
    {
      cost[i][j] = d[from[i]][to[j]];
    }
  }
  return { units - Assignment(cost), units };
}

/** Compares all edges exactly; returns the number of edges. */
int
ExpectBruteForce(const Graph & graph, long p, long q, long mostUnits)
{
  const auto curvature = Curvature(graph, CurvatureMethod::Ollivier, static_cast<double>(p) / static_cast<double>(q));
  const auto d = AllDistances(graph);
  int        compared = 0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    const auto [a, b] = graph.edges[e];
    const auto & number = curvature.edges[e];
    if (a == b)
    {
      EXPECT_FALSE(number.IsDefined());
      continue;
    }
    if (Units(graph, a, b, q) > mostUnits)
    {
      continue; // the brute force takes the cube of this
    }
    const auto [numerator, denominator] = BruteForce(graph, d, a, b, p, q);
    EXPECT_EQ(numerator * number.denominator, number.numerator * denominator)
      << "edge " << a << ' ' << b << ": " << number.Text();
    ++compared;
  }
  return compared;
}

/** Each pair of nodes is an edge with equal probability; `degree` is the expected degree. */
Graph
RandomGraph(int nodes, double degree, unsigned int seed)
{
  std::mt19937 random(seed);
  Graph        graph{ nodes, {}, {} };
  const auto   most = static_cast<double>(std::mt19937::max());
  for (int i = 0; i < nodes; ++i)
  {
    for (int j = i + 1; j < nodes; ++j)
    {
      if (random() / most * (nodes - 1) < degree)
      {
        graph.edges.push_back({ i, j });
      }
    }
  }
  return graph;
}

void
ExpectAll(const Graph & graph, CurvatureMethod method, const std::string & value, double idleness = 0.0)
{
  for (const auto & number : Curvature(graph, method, idleness).edges)
  {
    ASSERT_EQ(value, number.Text());
  }
}
} // namespace

TEST(GraphCurvature, EqualsBruteForceOnRandomGraphs)
{
  const Graph large = RandomGraph(200, 4.0, 1);
  EXPECT_EQ(static_cast<int>(large.edges.size()), ExpectBruteForce(large, 0, 1, 150)); // every edge
  EXPECT_LT(150, ExpectBruteForce(RandomGraph(120, 5.0, 2), 1, 2, 200));
  EXPECT_LT(80, ExpectBruteForce(RandomGraph(60, 4.0, 3), 1, 10, 200));
  EXPECT_LT(20, ExpectBruteForce(RandomGraph(14, 9.0, 4), 1, 3, 200));
  EXPECT_LT(50, ExpectBruteForce(RandomGraph(16, 8.0, 5), 0, 1, 150));
}

TEST(GraphCurvature, EqualsBruteForceWithLoopsAndParallelEdges)
{
  std::mt19937 random(7);
  Graph        graph{ 20, {}, {} };
  for (int e = 0; e < 45; ++e)
  {
    const int a = static_cast<int>(random() % 20);
    const int b = static_cast<int>((a + random() % 4) % 20);
    graph.edges.push_back({ a, b });
  }
  graph.edges.push_back({ 3, 3 });
  graph.edges.push_back({ 5, 6 });
  graph.edges.push_back({ 6, 5 });
  EXPECT_LT(20, ExpectBruteForce(graph, 0, 1, 200));
  EXPECT_LT(20, ExpectBruteForce(graph, 1, 2, 200));
}

/** The limit is reached before idleness 1: (1 - W) / (1 - a) for a = 9/10, by brute force. */
TEST(GraphCurvature, LinLuYauIsTheLimit)
{
  for (const Graph & graph : { RandomGraph(14, 5.0, 11), shapeton::WheelGraph(6), shapeton::GridGraph(3, 3) })
  {
    const auto limit = Curvature(graph, CurvatureMethod::LinLuYau);
    const auto late = Curvature(graph, CurvatureMethod::Ollivier, 0.99);
    const auto d = AllDistances(graph);
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
    {
      EXPECT_NEAR(late.edges[e].Value() * 100.0, limit.edges[e].Value(), 1e-12);
      const auto [numerator, denominator] = BruteForce(graph, d, graph.edges[e][0], graph.edges[e][1], 3, 4);
      if (denominator <= 240)
      {
        EXPECT_EQ(4 * numerator * limit.edges[e].denominator, limit.edges[e].numerator * denominator);
      }
    }
  }
}

TEST(GraphCurvature, ClosedForms)
{
  for (int n = 3; n < 12; ++n)
  {
    ExpectAll(
      shapeton::CompleteGraph(n), CurvatureMethod::Ollivier, std::to_string(n - 2) + "/" + std::to_string(n - 1));
    ExpectAll(shapeton::CompleteGraph(n), CurvatureMethod::LinLuYau, std::to_string(n) + "/" + std::to_string(n - 1));
    ExpectAll(shapeton::CompleteGraph(n), CurvatureMethod::Forman, std::to_string(6 - 2 * n));
    ExpectAll(shapeton::CompleteGraph(n), CurvatureMethod::AugmentedForman, std::to_string(n));
  }
  for (int n = 6; n < 10; ++n)
  {
    ExpectAll(shapeton::CycleGraph(n), CurvatureMethod::Ollivier, "0");
    ExpectAll(shapeton::CycleGraph(n), CurvatureMethod::LinLuYau, "0");
    ExpectAll(shapeton::CycleGraph(n), CurvatureMethod::Forman, "0");
  }
  ExpectAll(shapeton::CycleGraph(5), CurvatureMethod::LinLuYau, "1/2");
  ExpectAll(shapeton::CycleGraph(4), CurvatureMethod::LinLuYau, "1");
  ExpectAll(shapeton::CycleGraph(3), CurvatureMethod::LinLuYau, "3/2");
  for (int n = 2; n < 8; ++n)
  {
    ExpectAll(shapeton::HypercubeGraph(n),
              CurvatureMethod::LinLuYau,
              n == 2       ? "1"
              : n % 2 == 0 ? "1/" + std::to_string(n / 2)
                           : "2/" + std::to_string(n));
    ExpectAll(shapeton::HypercubeGraph(n), CurvatureMethod::Ollivier, "0");
  }
  ExpectAll(shapeton::TorusGridMap(8, 9).ToGraph(), CurvatureMethod::Ollivier, "0");
  ExpectAll(shapeton::TorusGridMap(8, 9).ToGraph(), CurvatureMethod::LinLuYau, "0");
  ExpectAll(shapeton::GeneralizedPetersenGraph(5, 2), CurvatureMethod::LinLuYau, "0"); // Lin, Lu, Yau 2011
}

/** Jost and Liu 2014: -2 (1 - 1/dx - 1/dy)+ for trees. */
TEST(GraphCurvature, Trees)
{
  std::mt19937 random(5);
  Graph        tree{ 150, {}, {} };
  for (int v = 1; v < tree.nodes; ++v)
  {
    tree.edges.push_back({ v, static_cast<int>(random() % std::min(v, 12)) });
  }
  const shapeton::Incidence incidence(tree);
  const auto                curvature = Curvature(tree);
  for (std::size_t e = 0; e < tree.edges.size(); ++e)
  {
    const double x = incidence.Degree(tree.edges[e][0]);
    const double y = incidence.Degree(tree.edges[e][1]);
    EXPECT_NEAR(-2.0 * std::max(0.0, 1.0 - 1.0 / x - 1.0 / y), curvature.edges[e].Value(), 1e-15);
    EXPECT_EQ(0, curvature.triangles[e]);
  }
}

/** Edges of a star of n leaves: 0, and 2 / n for Lin, Lu and Yau, since the mass (n - 1) / (2 n) moves by 2. */
TEST(GraphCurvature, Stars)
{
  for (const int leaves : { 2, 3, 10, 1000 })
  {
    const Graph star = shapeton::CompleteBipartiteGraph(1, leaves);
    ExpectAll(star, CurvatureMethod::Ollivier, "0");
    const auto limit = Curvature(star, CurvatureMethod::LinLuYau).edges.front();
    EXPECT_EQ(2 * limit.denominator, limit.numerator * leaves);
  }
}

/** Bounds of Jost and Liu 2014 (theorems 3 and 4) in terms of degrees and triangles. */
TEST(GraphCurvature, BoundsOfJostAndLiu)
{
  for (const Graph & graph :
       { RandomGraph(200, 12.0, 21), RandomGraph(40, 20.0, 22), shapeton::WheelGraph(50), shapeton::GridGraph(9, 8) })
  {
    const shapeton::Incidence incidence(graph);
    const auto                curvature = Curvature(graph);
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
    {
      const double x = incidence.Degree(graph.edges[e][0]);
      const double y = incidence.Degree(graph.edges[e][1]);
      const double triangles = curvature.triangles[e];
      const double free = 1.0 - 1.0 / x - 1.0 / y;
      const double most = triangles / std::max(x, y);
      const double least = -std::max(0.0, free - triangles / std::min(x, y)) - std::max(0.0, free - most) + most;
      EXPECT_LE(least - 1e-12, curvature.edges[e].Value());
      EXPECT_GE(most + 1e-12, curvature.edges[e].Value());
    }
  }
}

TEST(GraphCurvature, FormanCountsDegreesAndTriangles)
{
  const Graph graph = RandomGraph(100, 9.0, 31);
  const auto  d = AllDistances(graph);
  const auto  plain = Curvature(graph, CurvatureMethod::Forman);
  const auto  augmented = Curvature(graph, CurvatureMethod::AugmentedForman);
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    const auto [a, b] = graph.edges[e];
    long degrees = 0;
    long triangles = 0;
    for (int v = 0; v < graph.nodes; ++v)
    {
      degrees += (d[a][v] == 1 ? 1 : 0) + (d[b][v] == 1 ? 1 : 0);
      triangles += d[a][v] == 1 && d[b][v] == 1 ? 1 : 0;
    }
    EXPECT_EQ(4 - degrees, plain.edges[e].numerator);
    EXPECT_EQ(4 - degrees + 3 * triangles, augmented.edges[e].numerator);
    EXPECT_EQ(1, augmented.edges[e].denominator);
  }
}

TEST(GraphCurvature, NodesHaveMeanAndSumOfTheirEdges)
{
  Graph graph = shapeton::PathGraph(4); // leaf edges 0, the middle edge 0 as well: 1 - 1/2 - 1/2
  graph.nodes = 6;
  graph.edges.push_back({ 1, 4 });
  graph.edges.push_back({ 4, 4 });
  const auto forman = Curvature(graph, CurvatureMethod::Forman); // degrees 1, 3, 2, 1, 3, 0
  EXPECT_EQ(std::vector<double>({ 0.0, -3.0, 0.0, 1.0, -2.0, 0.0 }), forman.nodeSums);
  EXPECT_EQ(-1.0, forman.nodeMeans[1]);
  EXPECT_EQ(-2.0, forman.nodeMeans[4]);
  EXPECT_TRUE(std::isnan(forman.nodeMeans[5]));
  EXPECT_EQ("", forman.edges[4].Text());
  EXPECT_TRUE(std::isnan(forman.edges[4].Value()));
}

TEST(GraphCurvature, NumberingAndThreadsDoNotMatter)
{
  const Graph graph = RandomGraph(150, 10.0, 41);
  const auto  curvaturesOf = [](const Graph & of) {
    std::vector<std::string> texts;
    const auto               curvature = Curvature(of);
    for (const auto & edge : curvature.edges)
    {
      texts.push_back(edge.Text());
    }
    return std::make_pair(texts, curvature.nodeSums);
  };
  basetest::ExpectSameWithAnyThreads([&] { return curvaturesOf(graph); }, { 4 });
  EXPECT_EQ(curvaturesOf(graph).first, curvaturesOf(graphtest::Shuffled(graph)).first);
}

/** Each edge of a social network and of a power grid with parallel lines. */
TEST(GraphCurvature, EqualsBruteForceOnRealNetworks)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (folder == nullptr || *folder == '\0')
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  for (const char * const name : { "karate.gml", "power/case118.m" })
  {
    const Graph    graph = shapeton::ReadGraph(std::string(folder) + "/graphs/" + name).graph;
    constexpr long anyUnits = 1000;
    EXPECT_EQ(static_cast<int>(graph.edges.size()), ExpectBruteForce(graph, 0, 1, anyUnits)) << name;
  }
}

TEST(GraphCurvature, Refusals)
{
  const auto messageOf = [](CurvatureMethod method, double idleness) {
    return basetest::ErrorOf<std::exception>([&] { Curvature(shapeton::CompleteGraph(4), method, idleness); });
  };
  EXPECT_EQ("", messageOf(CurvatureMethod::Ollivier, 0.123456789));
  EXPECT_NE(std::string::npos, messageOf(CurvatureMethod::Ollivier, 1.0).find("idleness"));
  EXPECT_NE(std::string::npos, messageOf(CurvatureMethod::Ollivier, -0.1).find("idleness"));
  EXPECT_NE(std::string::npos, messageOf(CurvatureMethod::Ollivier, 1e-300).find("fewer digits"));
  EXPECT_NE(std::string::npos, messageOf(CurvatureMethod::LinLuYau, 0.5).find("idleness"));
}
