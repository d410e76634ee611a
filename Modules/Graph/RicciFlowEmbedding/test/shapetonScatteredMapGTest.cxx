#include "shapetonCirclePacking.h"
#include "shapetonGraphFamilies.h"
#include "shapetonSphericalPacking.h"
#include "shapetonTestGraphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
/** Scatters number i over 0 ... n - 1; `n` is not a multiple of 7919. */
int
Scattered(long i, long n)
{
  return static_cast<int>((i * 7919 + 13) % n);
}

/** The map with nodes and edges in an order without locality. */
shapeton::CombinatorialMap
ScatteredMap(const shapeton::CombinatorialMap & map)
{
  const auto                      halfEdgeOf = [&](int h) { return 2 * Scattered(h / 2, map.Edges()) + h % 2; };
  std::vector<std::array<int, 2>> edges(map.Edges());
  std::vector<int>                next(map.HalfEdges());
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    edges[halfEdgeOf(h) / 2][h % 2] = Scattered(map.Node(h), map.Nodes());
    next[halfEdgeOf(h)] = halfEdgeOf(map.NextAround(h));
  }
  return { map.Nodes(), edges, next };
}

/** A torus of squares with every 13th edge removed, so that circles differ; each node loses at most one edge. */
shapeton::CombinatorialMap
TorusWithHoles(int columns, int rows)
{
  return graphtest::MapOfEdges(shapeton::TorusGridMap(columns, rows), [](int edge) { return edge % 13 != 0; });
}

/** A tube of squares with a node at each end: genus 0, 3-connected. */
shapeton::CombinatorialMap
ClosedTube(int columns, int rows)
{
  const int       south = columns * rows;
  shapeton::Graph graph{ south + 2, {}, {} };
  const auto      at = [=](int c, int r) { return r < 0 ? south : r == rows ? south + 1 : r * columns + c % columns; };
  for (int r = -1; r < rows; ++r)
  {
    for (int c = 0; c < columns; ++c)
    {
      graph.edges.push_back({ at(c, r), at(c, r + 1) });
      if (r >= 0)
      {
        graph.edges.push_back({ at(c, r), at(c + 1, r) });
      }
    }
  }
  return graphtest::PlanarMap(graph);
}

double
Angle(const std::array<double, 3> & a, const std::array<double, 3> & b)
{
  return 2.0 * std::atan2(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
                          std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]));
}
} // namespace

/** Large maps are packed in another order of nodes and edges; results use the original order. */
TEST(ScatteredMap, RadiiAreThoseOfTheirCircles)
{
  const shapeton::CombinatorialMap map = ScatteredMap(TorusWithHoles(330, 340));
  ASSERT_EQ(map.Genus(), 1);
  ASSERT_GT(map.Edges(), 200'000);
  const shapeton::CirclePacking packing = shapeton::PackCircles(map, shapeton::FlowGeometry::Euclidean);
  const std::vector<double>     curvatures = shapeton::CurvaturesOf(map, packing);
  const auto [least, most] = std::minmax_element(packing.nodeRadii.begin(), packing.nodeRadii.end());
  EXPECT_GT(*most / *least, 1.1);
  EXPECT_LT(*std::max_element(curvatures.begin(), curvatures.end()), 1e-10);
  EXPECT_GT(*std::min_element(curvatures.begin(), curvatures.end()), -1e-10);
}

TEST(ScatteredMap, CirclesOfTheSphereTouch)
{
  const shapeton::CombinatorialMap map = ScatteredMap(ClosedTube(460, 230));
  ASSERT_EQ(map.Genus(), 0);
  ASSERT_GT(map.Edges(), 200'000);
  const shapeton::SphericalPacking sphere = shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle);
  double                           worst = 0.0;
  for (int edge = 0; edge < map.Edges(); ++edge)
  {
    const shapeton::SphereCircle & one = sphere.nodes[map.Node(2 * edge)];
    const shapeton::SphereCircle & other = sphere.nodes[map.Node(2 * edge + 1)];
    const shapeton::SphereCircle & left = sphere.faces[map.Face(2 * edge)];
    const shapeton::SphereCircle & right = sphere.faces[map.Face(2 * edge + 1)];
    for (const auto & [a, b] : { std::pair(one, other), std::pair(left, right) })
    {
      worst = std::max(
        worst,
        std::abs(Angle(shapeton::CenterOf(a), shapeton::CenterOf(b)) - shapeton::RadiusOf(a) - shapeton::RadiusOf(b)));
    }
    const double touch = Angle(shapeton::CenterOf(one), sphere.touchPoints[edge]) - shapeton::RadiusOf(one);
    worst = std::max(worst, std::abs(touch));
  }
  EXPECT_LT(worst, 1e-9);
}

TEST(ScatteredMap, AHubIsFarFromItsNeighborsInAnyOrder)
{
  // A wheel with its hub first.
  constexpr int   spokes = 101'000;
  shapeton::Graph graph{ spokes + 1, {}, {} };
  for (int i = 0; i < spokes; ++i)
  {
    graph.edges.insert(graph.edges.end(), { { 0, 1 + i }, { 1 + i, 1 + (i + 1) % spokes } });
  }
  const shapeton::CombinatorialMap map = graphtest::PlanarMap(graph);
  ASSERT_EQ(map.Genus(), 0);
  ASSERT_GT(map.Edges(), 200'000);
  const shapeton::SphericalPacking sphere = shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle);
  const double                     rim = shapeton::RadiusOf(sphere.nodes[1]);
  // As in the closed form for wheels, see shapetonSphericalPackingGTest.cxx.
  EXPECT_NEAR(std::sin(rim) / std::sin(rim + shapeton::RadiusOf(sphere.nodes[0])) / std::sin(std::acos(-1.0) / spokes),
              1.0,
              1e-7);
}
