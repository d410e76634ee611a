#include "shapetonSphericalPacking.h"

#include "shapetonGraphFamilies.h"
#include "shapetonPackedMap.h"
#include "shapetonTestGraphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
double
Angle(const std::array<double, 3> & a, const std::array<double, 3> & b)
{
  return 2.0 * std::atan2(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
                          std::hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]));
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
    const shapeton::CombinatorialMap map = graphtest::PlanarMap(shapeton::WheelGraph(spokes));
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
  const shapeton::PackedMap packed =
    shapeton::MakePackedMap(graphtest::AnyMap(shapeton::PathGraph(40)), shapeton::Augmentation::Ring);
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
  // The first triangle, then that of the last node and two older ones, alternating.
  return graphtest::PlanarMap(graphtest::StackedTriangles(3 + chain + more, [chain, node = 0](int triangles) mutable {
    ++node;
    return node == 1 ? 1 : node <= chain ? triangles - 2 : 0;
  }));
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
  const shapeton::CombinatorialMap map = graphtest::PlanarMap(shapeton::GeneralizedPetersenGraph(1500, 1));
  ASSERT_EQ(map.Genus(), 0);
  const shapeton::SphericalPacking packing = shapeton::PackOnSphere(map, shapeton::PointAtInfinity::Circle);
  const auto [least, most] =
    std::minmax_element(packing.nodes.begin(), packing.nodes.end(), [](const auto & a, const auto & b) {
      return shapeton::RadiusOf(a) < shapeton::RadiusOf(b);
    });
  EXPECT_NEAR(shapeton::RadiusOf(*least) / shapeton::RadiusOf(*most), 1.0, 1e-9);
  for (const std::array<int, 2> & edge : map.ToGraph().edges)
  {
    const shapeton::SphereCircle & a = packing.nodes[edge[0]];
    const shapeton::SphereCircle & b = packing.nodes[edge[1]];
    EXPECT_NEAR(
      Angle(shapeton::CenterOf(a), shapeton::CenterOf(b)), shapeton::RadiusOf(a) + shapeton::RadiusOf(b), 1e-12);
  }
}
