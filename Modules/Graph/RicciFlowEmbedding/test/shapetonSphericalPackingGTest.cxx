#include "shapetonSphericalPacking.h"

#include "shapetonGraphFamilies.h"
#include "shapetonPackedMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace
{
double
Angle(const std::array<double, 3> & a, const std::array<double, 3> & b)
{
  double difference = 0.0;
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    difference += (a[i] - b[i]) * (a[i] - b[i]);
    sum += (a[i] + b[i]) * (a[i] + b[i]);
  }
  return 2.0 * std::atan2(std::sqrt(difference), std::sqrt(sum));
}

void
ExpectPacking(const shapeton::CombinatorialMap & map, const shapeton::SphericalPacking & packing)
{
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    const auto & node = packing.nodes[map.Node(h)];
    const auto & other = packing.nodes[map.Node(h ^ 1)];
    const auto & face = packing.faces[map.Face(h)];
    EXPECT_NEAR(Angle(shapeton::CenterOf(node), shapeton::CenterOf(other)),
                shapeton::RadiusOf(node) + shapeton::RadiusOf(other),
                1e-10);
    EXPECT_NEAR(std::cos(Angle(shapeton::CenterOf(node), shapeton::CenterOf(face))),
                std::cos(shapeton::RadiusOf(node)) * std::cos(shapeton::RadiusOf(face)),
                1e-11);
  }
}

/** A wheel with an explicit rotation system. */
shapeton::CombinatorialMap
WheelMap(int spokes)
{
  shapeton::Graph    graph;
  shapeton::Rotation rotation(spokes + 1);
  graph.nodes = spokes + 1;
  for (int i = 0; i < spokes; ++i)
  {
    graph.edges.push_back({ i, (i + 1) % spokes });
    graph.edges.push_back({ i, spokes });
  }
  for (int i = 0; i < spokes; ++i)
  {
    rotation[i] = { 4 * i, 4 * i + 2, 4 * ((i + spokes - 1) % spokes) + 1 };
    rotation[spokes].push_back(4 * i + 3);
  }
  return { graph, rotation };
}
} // namespace

TEST(SphericalPacking, WheelsHaveTheRadiiOfTheClosedForm)
{
  for (const auto & [spokes, infinity] : { std::pair(3, shapeton::PointAtInfinity::EdgeNode),
                                           { 4, shapeton::PointAtInfinity::EdgeNode },
                                           { 60, shapeton::PointAtInfinity::EdgeNode },
                                           { 3, shapeton::PointAtInfinity::Circle },
                                           { 5, shapeton::PointAtInfinity::Circle },
                                           { 60, shapeton::PointAtInfinity::Circle } })
  {
    const shapeton::CombinatorialMap map = WheelMap(spokes);
    ASSERT_EQ(map.Genus(), 0);
    shapeton::SphericalPacking packing = shapeton::PackOnSphere(map, infinity);
    EXPECT_LE(packing.residual, 1e-10);
    ExpectPacking(map, packing);
    double rim = shapeton::RadiusOf(packing.nodes[0]);
    for (int i = 1; i < spokes; ++i)
    {
      EXPECT_NEAR(shapeton::RadiusOf(packing.nodes[i]), rim, 1e-10);
    }
    // Neighbors on the rim have the same distance d from the hub: sin(r) = sin(d) sin(pi / n), d = r + hub.
    const double d = rim + shapeton::RadiusOf(packing.nodes[spokes]);
    EXPECT_NEAR(std::sin(rim), std::sin(d) * std::sin(std::acos(-1.0) / spokes), 1e-10);
  }
}

TEST(SphericalPacking, ATreeIsPackedWithDummies)
{
  const shapeton::Graph path = shapeton::PathGraph(40);
  shapeton::Rotation    rotation(40);
  for (int i = 0; i < 40; ++i)
  {
    if (i > 0)
    {
      rotation[i].push_back(2 * i - 1);
    }
    if (i < 39)
    {
      rotation[i].push_back(2 * i);
    }
  }
  const shapeton::PackedMap  packed = shapeton::MakePackedMap({ path, rotation }, shapeton::Augmentation::Ring);
  shapeton::SphericalPacking packing = shapeton::PackOnSphere(packed.map, shapeton::PointAtInfinity::Circle);
  ExpectPacking(packed.map, packing);
  double smallest = 1.0;
  for (int i = 0; i < 40; ++i)
  {
    smallest = std::min(smallest, shapeton::RadiusOf(packing.nodes[i]));
  }
  EXPECT_GT(smallest, 1e-4);
}

namespace
{
/** Nested triangles: node i is inside the triangle of the three preceding nodes, so circles shrink by a constant
 * factor. Some nodes surround the first three. */
shapeton::CombinatorialMap
NestedTriangles(int chain, int more)
{
  std::vector<std::array<int, 3>> triangles{ { 0, 1, 2 }, { 0, 2, 1 } };
  shapeton::Graph                 graph{ 3, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {} };
  const auto                      fill = [&](std::size_t triangle) {
    const auto [a, b, c] = triangles[triangle];
    const int node = graph.nodes++;
    graph.edges.insert(graph.edges.end(), { { node, a }, { node, b }, { node, c } });
    triangles[triangle] = { a, b, node };
    triangles.push_back({ b, c, node });
    triangles.push_back({ c, a, node });
  };
  for (int i = 0; i < chain; ++i)
  {
    fill(i == 0 ? 1 : triangles.size() - 2); // triangle of the last node and two older ones, alternating
  }
  for (int i = 0; i < more; ++i)
  {
    fill(0);
  }
  std::map<std::array<int, 2>, int> halfEdges;
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
  {
    const auto [a, b] = graph.edges[e];
    halfEdges[{ a, b }] = static_cast<int>(2 * e);
    halfEdges[{ b, a }] = static_cast<int>(2 * e + 1);
  }
  std::vector<int> next(2 * graph.edges.size());
  for (const auto & t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      next[halfEdges.at({ t[k], t[(k + 1) % 3] })] = halfEdges.at({ t[k], t[(k + 2) % 3] });
    }
  }
  return { graph.nodes, graph.edges, next };
}
} // namespace

TEST(SphericalPacking, VerySmallVisibleCapsAreEnlarged)
{
  const shapeton::CombinatorialMap map = NestedTriangles(14, 20);
  ASSERT_EQ(map.Genus(), 0);
  const auto smallest = [](const shapeton::SphericalPacking & packing) {
    double least = 4.0;
    for (const shapeton::SphereCircle & node : packing.nodes)
    {
      least = std::min(least, shapeton::RadiusOf(node));
    }
    return least;
  };
  const auto centered = shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle);
  const auto enlarged =
    shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle, {}, std::vector<char>(map.Nodes(), 1));
  ASSERT_LT(smallest(centered), shapeton::smallestCapOfBarycenter);
  EXPECT_GT(smallest(enlarged), 1.5 * smallest(centered));
  ExpectPacking(map, enlarged);
  // The derivative of the sum of the fourth roots of cot(r / 2) vanishes.
  std::array<double, 3> balance{};
  double                sum = 0.0;
  for (const shapeton::SphereCircle & node : enlarged.nodes)
  {
    const double weight = std::pow(std::tan(0.5 * shapeton::RadiusOf(node)), -0.25);
    sum += weight;
    for (int i = 0; i < 3; ++i)
    {
      balance[i] += weight * shapeton::CenterOf(node)[i];
    }
  }
  for (const double component : balance)
  {
    EXPECT_NEAR(component / sum, 0.0, 1e-7);
  }
  // Caps that are invisible or large enough do not change the barycenter.
  std::vector<char> firstAlone(map.Nodes(), 0);
  firstAlone[0] = 1;
  const auto same = shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle, {}, firstAlone);
  EXPECT_EQ(same.nodes, centered.nodes);
}

TEST(SphericalPacking, LongRingsKeepTheirAccuracy)
{
  // All node circles of a prism are equal; in double precision, errors would grow with the square of their number.
  constexpr int      sides = 1500;
  shapeton::Graph    graph{ 2 * sides, {}, {} };
  shapeton::Rotation rotation(graph.nodes);
  for (int i = 0; i < sides; ++i)
  {
    const int next = (i + 1) % sides;
    const int before = (i + sides - 1) % sides;
    graph.edges.insert(graph.edges.end(), { { i, next }, { sides + i, sides + next }, { i, sides + i } });
    rotation[i] = { 6 * i, 6 * i + 4, 6 * before + 1 };
    rotation[sides + i] = { 6 * before + 3, 6 * i + 5, 6 * i + 2 };
  }
  const shapeton::CombinatorialMap map(graph, rotation);
  ASSERT_EQ(map.Genus(), 0);
  const shapeton::SphericalPacking packing = shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle);
  const auto [least, most] =
    std::minmax_element(packing.nodes.begin(), packing.nodes.end(), [](const auto & a, const auto & b) {
      return shapeton::RadiusOf(a) < shapeton::RadiusOf(b);
    });
  EXPECT_NEAR(shapeton::RadiusOf(*least) / shapeton::RadiusOf(*most), 1.0, 1e-9);
  for (const std::array<int, 2> & edge : graph.edges)
  {
    const shapeton::SphereCircle & a = packing.nodes[edge[0]];
    const shapeton::SphereCircle & b = packing.nodes[edge[1]];
    EXPECT_NEAR(
      Angle(shapeton::CenterOf(a), shapeton::CenterOf(b)), shapeton::RadiusOf(a) + shapeton::RadiusOf(b), 1e-12);
  }
}
