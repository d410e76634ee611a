#include "itkSphericalPacking.h"

#include "itkGraphFamilies.h"
#include "itkPackedMap.h"

#include <gtest/gtest.h>

#include <cmath>
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
ExpectPacking(const itk::CombinatorialMap & map, const itk::SphericalPacking & packing)
{
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    const auto & node = packing.nodes[map.Node(h)];
    const auto & other = packing.nodes[map.Node(h ^ 1)];
    const auto & face = packing.faces[map.Face(h)];
    EXPECT_NEAR(Angle(itk::CentreOf(node), itk::CentreOf(other)), itk::RadiusOf(node) + itk::RadiusOf(other), 1e-10);
    EXPECT_NEAR(std::cos(Angle(itk::CentreOf(node), itk::CentreOf(face))),
                std::cos(itk::RadiusOf(node)) * std::cos(itk::RadiusOf(face)),
                1e-11);
  }
}

/** Wheels are planar in the order of their construction: rim and spokes by hand. */
itk::CombinatorialMap
WheelMap(int spokes)
{
  itk::Graph    graph;
  itk::Rotation rotation(spokes + 1);
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
  for (const auto & [spokes, infinity] : { std::pair(3, itk::PointAtInfinity::EdgeNode),
                                           { 4, itk::PointAtInfinity::EdgeNode },
                                           { 60, itk::PointAtInfinity::EdgeNode },
                                           { 3, itk::PointAtInfinity::Circle },
                                           { 5, itk::PointAtInfinity::Circle },
                                           { 60, itk::PointAtInfinity::Circle } })
  {
    const itk::CombinatorialMap map = WheelMap(spokes);
    ASSERT_EQ(map.Genus(), 0);
    itk::SphericalPacking packing = itk::PackOnSphere(map, infinity);
    EXPECT_LE(packing.residual, 1e-10);
    ExpectPacking(map, packing);
    double rim = itk::RadiusOf(packing.nodes[0]);
    for (int i = 1; i < spokes; ++i)
    {
      EXPECT_NEAR(itk::RadiusOf(packing.nodes[i]), rim, 1e-10);
    }
    // Neighbours on the rim lie at the same distance d from the hub: sin(r) = sin(d) sin(pi / n), d = r + hub.
    const double d = rim + itk::RadiusOf(packing.nodes[spokes]);
    EXPECT_NEAR(std::sin(rim), std::sin(d) * std::sin(std::acos(-1.0) / spokes), 1e-10);
  }
}

TEST(SphericalPacking, ATreeIsPackedWithDummies)
{
  const itk::Graph path = itk::PathGraph(40);
  itk::Rotation    rotation(40);
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
  const itk::PackedMap  packed = itk::MakePackedMap({ path, rotation }, itk::Augmentation::Ring);
  itk::SphericalPacking packing = itk::PackOnSphere(packed.map, itk::PointAtInfinity::Circle);
  ExpectPacking(packed.map, packing);
  double smallest = 1.0;
  for (int i = 0; i < 40; ++i)
  {
    smallest = std::min(smallest, itk::RadiusOf(packing.nodes[i]));
  }
  EXPECT_GT(smallest, 1e-4);
}
