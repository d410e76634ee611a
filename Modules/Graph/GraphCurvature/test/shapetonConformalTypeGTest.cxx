#include "shapetonConformalType.h"
#include "shapetonExceptions.h"
#include "shapetonGraphFamilies.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphReader.h"
#include "shapetonPi.h"
#include "shapetonTestGraphs.h"
#include "shapetonTestThreads.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using shapeton::ConformalType;
using shapeton::Graph;
using shapeton::JudgeGrowth;
using shapeton::RegularTilingGraph;

namespace
{
shapeton::ConformalTypeResult
TypeOf(const Graph & graph, int root = -1)
{
  shapeton::ConformalTypeSettings settings;
  settings.root = root;
  return shapeton::FindConformalType(graph, settings);
}

/** By Schwarz's lemma and Rayleigh's principle. */
void
ExpectMonotone(const shapeton::ConformalTypeResult & result)
{
  for (std::size_t i = 1; i < result.balls.size(); ++i)
  {
    EXPECT_LT(result.balls[i].rootRadius, result.balls[i - 1].rootRadius) << result.balls[i].radius;
    EXPECT_GT(result.balls[i].resistance, result.balls[i - 1].resistance) << result.balls[i].radius;
    EXPECT_GT(result.balls[i].nodes, result.balls[i - 1].nodes);
  }
}

void
ExpectSameBalls(const shapeton::ConformalTypeResult & a, const shapeton::ConformalTypeResult & b)
{
  ASSERT_EQ(a.balls.size(), b.balls.size());
  for (std::size_t i = 0; i < a.balls.size(); ++i)
  {
    EXPECT_EQ(a.balls[i].nodes, b.balls[i].nodes);
    EXPECT_NEAR(a.balls[i].rootRadius, b.balls[i].rootRadius, 1e-10);
    EXPECT_NEAR(a.balls[i].resistance, b.balls[i].resistance, 1e-12);
  }
}

/** Hyperbolic radius of the circle of a node of the tiling {p, q}. */
double
RadiusInTiling(int p, int q)
{
  return std::acosh(std::cos(shapeton::Pi / p) / std::sin(shapeton::Pi / q));
}
} // namespace

/** The verdicts have a margin: the decay is below half or above twice its bound. */
TEST(ConformalType, EuclideanTilingsAreParabolic)
{
  for (const auto & [p, q, rings] : { std::array<int, 3>{ 3, 6, 30 }, { 4, 4, 25 }, { 6, 3, 20 } })
  {
    const auto result = TypeOf(RegularTilingGraph(p, q, rings));
    EXPECT_EQ(ConformalType::Parabolic, result.type) << p << ' ' << q;
    EXPECT_LT(result.packing.decay, shapeton::mostDecayOfParabolic / 2.0);
    EXPECT_LT(result.resistance.decay, shapeton::mostDecayOfParabolic / 2.0);
    EXPECT_EQ(0.0, result.limitRadius);
    EXPECT_EQ(0, result.root);
    ExpectMonotone(result);
  }
}

TEST(ConformalType, HyperbolicTilingsAreHyperbolic)
{
  for (const auto & [p, q, rings] : { std::array<int, 3>{ 3, 7, 7 }, { 3, 8, 5 }, { 4, 5, 6 }, { 7, 3, 8 } })
  {
    const auto result = TypeOf(RegularTilingGraph(p, q, rings));
    EXPECT_EQ(ConformalType::Hyperbolic, result.type) << p << ' ' << q;
    EXPECT_GT(result.packing.decay, 2.0 * shapeton::leastDecayOfHyperbolic);
    EXPECT_GT(result.resistance.decay, 2.0 * shapeton::leastDecayOfHyperbolic);
    EXPECT_NEAR(RadiusInTiling(p, q), result.limitRadius, 3e-4);
    EXPECT_GT(RadiusInTiling(p, q), result.leastLimitRadius);
    EXPECT_LT(RadiusInTiling(p, q), result.balls.back().rootRadius); // balls are larger circles by Schwarz
    ExpectMonotone(result);
  }
}

TEST(ConformalType, ASquareGridIsParabolic)
{
  const auto result = TypeOf(shapeton::GridGraph(41, 41));
  EXPECT_EQ(20 * 41 + 20, result.root);
  EXPECT_EQ(18, result.balls.back().radius); // 1 to 8, 10, 12, 15, 18, at most 20
  EXPECT_EQ(ConformalType::Parabolic, result.type);
  EXPECT_EQ(0, result.balls.back().dummies);
  EXPECT_DOUBLE_EQ(0.25, result.balls.front().resistance);
}

/** A circle of radius r in the center of the unit disk and q equal circles around it that touch the rim:
 * (r + s) sin(pi / q) = s, r + 2 s = 1. */
TEST(ConformalType, TheFirstBallIsAFlower)
{
  for (int q = 4; q < 12; ++q)
  {
    const auto   ball = TypeOf(shapeton::WheelGraph(q)).balls.at(0);
    const double sine = std::sin(shapeton::Pi / q);
    const double r = (1.0 - sine) / (1.0 + sine);
    EXPECT_NEAR(r, std::tanh(ball.rootRadius / 2.0), 1e-12);
    EXPECT_NEAR(-std::log(r), ball.modulus, 1e-11);
    EXPECT_NEAR(1.0 / q, ball.resistance, 1e-15);
    EXPECT_EQ(q, ball.boundaryNodes);
    EXPECT_EQ(q + 1, ball.nodes);
  }
}

TEST(ConformalType, AFewBallsDecideNothing)
{
  const auto result = TypeOf(RegularTilingGraph(3, 7, 3));
  EXPECT_EQ(3u, result.balls.size());
  EXPECT_EQ(ConformalType::NotDecided, result.type);
  EXPECT_TRUE(std::isnan(result.limitRadius));
  EXPECT_TRUE(std::isnan(result.packing.decay));
}

TEST(ConformalType, GrowthLaws)
{
  std::vector<double> n, logarithm, root, square, exponential;
  for (int i = 2; i < 24; i += 2)
  {
    n.push_back(i);
    logarithm.push_back(std::log(i));
    root.push_back(3.0 - std::pow(i, -0.5));
    square.push_back(3.0 - std::pow(i, -2.0));
    exponential.push_back(3.0 - std::pow(0.5, i));
  }
  EXPECT_EQ(ConformalType::Parabolic, JudgeGrowth(n, logarithm).type);
  EXPECT_NEAR(0.0, JudgeGrowth(n, logarithm).decay, 1e-9);
  EXPECT_EQ(ConformalType::NotDecided, JudgeGrowth(n, root).type); // too slow for these radii
  EXPECT_NEAR(0.5, JudgeGrowth(n, root).decay, 0.01);
  EXPECT_EQ(ConformalType::Hyperbolic, JudgeGrowth(n, square).type);
  EXPECT_NEAR(3.0, JudgeGrowth(n, square).farLimit, 5e-4);
  EXPECT_EQ(ConformalType::Hyperbolic, JudgeGrowth(n, exponential).type);
  EXPECT_NEAR(3.0, JudgeGrowth(n, exponential).limit, 1e-9);
  std::reverse(root.begin(), root.end());
  EXPECT_EQ(ConformalType::NotDecided, JudgeGrowth(n, root).type); // shrinks
}

TEST(ConformalType, NumberingAndThreadsDoNotMatter)
{
  const Graph graph = RegularTilingGraph(4, 5, 4);
  basetest::ExpectSameWithAnyThreads(
    [&] {
      std::vector<std::pair<double, double>> balls;
      const auto                             result = TypeOf(graph);
      for (const auto & ball : result.balls)
      {
        balls.emplace_back(ball.rootRadius, ball.resistance);
      }
      return balls;
    },
    { 4 });
  const auto other = TypeOf(graphtest::Shuffled(graph));
  EXPECT_EQ(11, other.root); // node 0 by its new number
  ExpectSameBalls(TypeOf(graph), other);
}

/** Graphs of a sequence are the balls of the last one. */
TEST(ConformalType, ASequenceOfGraphs)
{
  std::vector<Graph> graphs;
  for (int rings = 1; rings < 6; ++rings)
  {
    graphs.push_back(RegularTilingGraph(3, 7, rings));
  }
  const auto sequence = shapeton::FindConformalType(graphs, std::vector<int>(graphs.size(), 0));
  const auto balls = TypeOf(graphs.back());
  ASSERT_EQ(graphs.size(), sequence.balls.size());
  ExpectSameBalls(balls, sequence);
  EXPECT_EQ(ConformalType::Hyperbolic, sequence.type);
  std::swap(graphs[1], graphs[2]);
  EXPECT_THROW(shapeton::FindConformalType(graphs, std::vector<int>(graphs.size(), 0)), shapeton::InputError);
}

/** Pendant paths outside the disk do not count; those in a face do not change the resistance. */
TEST(ConformalType, TreesInFaces)
{
  const Graph plain = RegularTilingGraph(4, 4, 3);
  Graph       graph = plain;
  for (const int node : { 0, 5, plain.nodes - 1 })
  {
    graph.edges.push_back({ node, graph.nodes });
    graph.edges.push_back({ graph.nodes, graph.nodes + 1 });
    graph.nodes += 2;
  }
  const auto expected = TypeOf(plain, 0);
  const auto result = TypeOf(graph, 0);
  ASSERT_EQ(3u, result.balls.size());
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(expected.balls[i].resistance, result.balls[i].resistance, 1e-12);
    EXPECT_GT(result.balls[i].dummies, 0);
    EXPECT_GT(result.balls[i].rootRadius, 0.0);
  }
}

/** Nodes of three rings: 3 k^2 + 3 k + 1 for {3, 6}, (2 k + 1)^2 for {4, 4}, 6 k^2 + 6 k + 1 for {6, 3}, and the growth
 * series 1, 8, 29, 85 of {3, 7}; no closed form (0) for the others. */
TEST(ConformalType, TilingsHaveTheirDegreesAndFaces)
{
  for (const auto & [p, q, nodes] : { std::array<int, 3>{ 3, 6, 37 },
                                      { 3, 7, 85 },
                                      { 4, 4, 49 },
                                      { 6, 3, 73 },
                                      { 4, 5, 0 },
                                      { 5, 4, 0 },
                                      { 7, 3, 0 } })
  {
    const Graph                graph = RegularTilingGraph(p, q, 3);
    shapeton::CombinatorialMap map;
    ASSERT_TRUE(shapeton::FindPlanarEmbedding(graph, map));
    const auto lengths = map.FaceLengths();
    EXPECT_EQ(map.Faces() - 1, std::count(lengths.begin(), lengths.end(), p)) << p << ' ' << q;
    const int         outer = static_cast<int>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    std::vector<bool> isOuter(graph.nodes, false);
    for (const int h : map.Boundary(outer))
    {
      isOuter[map.Node(h)] = true;
    }
    for (int v = 0; v < graph.nodes; ++v)
    {
      EXPECT_TRUE(isOuter[v] ? map.Degrees()[v] <= q : map.Degrees()[v] == q);
    }
    EXPECT_EQ(nodes == 0 ? graph.nodes : nodes, graph.nodes) << p << ' ' << q;
  }
  EXPECT_THROW(RegularTilingGraph(3, 5, 2), shapeton::ParameterError);
  EXPECT_THROW(RegularTilingGraph(2, 9, 2), shapeton::ParameterError);
  EXPECT_THROW(RegularTilingGraph(4, 4, 0), shapeton::ParameterError);
}

TEST(ConformalType, Refusals)
{
  EXPECT_THROW(TypeOf(shapeton::CompleteGraph(5)), shapeton::InputError);
  EXPECT_THROW(TypeOf(shapeton::PathGraph(5)), shapeton::InputError);
  EXPECT_THROW(TypeOf(shapeton::CycleGraph(5)), shapeton::InputError); // all nodes on the outer face
  EXPECT_THROW(TypeOf(shapeton::GridGraph(5, 5), 0), shapeton::InputError);
  EXPECT_THROW(TypeOf(shapeton::GridGraph(5, 5), 25), shapeton::ParameterError);
  Graph two = shapeton::GridGraph(5, 5);
  ++two.nodes;
  EXPECT_THROW(TypeOf(two), shapeton::InputError);
  shapeton::ConformalTypeSettings settings;
  settings.maximumRadius = 0;
  EXPECT_THROW(shapeton::FindConformalType(shapeton::GridGraph(5, 5), settings), shapeton::ParameterError);
}

/** Eight faces of seven nodes around the root: its balls of radius 1, 2 and 3 are the same, with the boundary at
 * distance 3. */
TEST(ConformalType, EqualBallsCountOnce)
{
  Graph graph{ 1 + 3 * 8, {}, {} };
  for (int i = 0; i < 8; ++i)
  {
    const int next = (i + 1) % 8;
    graph.edges.push_back({ 0, 1 + i });
    graph.edges.push_back({ 1 + i, 9 + i });
    graph.edges.push_back({ 9 + i, 17 + i });
    graph.edges.push_back({ 17 + i, 17 + next });
  }
  const auto result = TypeOf(graph, 0);
  ASSERT_EQ(1u, result.balls.size());
  EXPECT_EQ(3, result.balls[0].radius);
  EXPECT_EQ(25, result.balls[0].nodes);
  EXPECT_NEAR(3.0 / 8.0, result.balls[0].resistance, 1e-12);
}

/** A mesh around an airfoil, with long faces and 4720 nodes; the planar part of a power grid. */
TEST(ConformalType, RealNetworks)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (folder == nullptr || *folder == '\0')
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  const auto result = TypeOf(shapeton::ReadGraph(std::string(folder) + "/graphs/3elt.graph").graph);
  EXPECT_LT(10u, result.balls.size());
  ExpectMonotone(result);
  const Graph grid = shapeton::ReadGraph(std::string(folder) + "/graphs/power/case300.m").graph;
  const auto  planar = TypeOf(shapeton::GraphWithEdges(grid, shapeton::PlanarEdges(grid)));
  EXPECT_LT(4u, planar.balls.size());
  ExpectMonotone(planar);
}
