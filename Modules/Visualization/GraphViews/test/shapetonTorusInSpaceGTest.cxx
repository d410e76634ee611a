#include "shapetonTorusInSpace.h"

#include "shapetonGraphEmbedding.h"
#include "shapetonGraphFamilies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
double
Distance(const shapeton::TorusInSpace::Point & a, const shapeton::TorusInSpace::Point & b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** The differential of the map by finite differences: lengths of the images of both axes, and their product. */
std::array<double, 3>
Metric(const shapeton::TorusInSpace & torus, const std::complex<double> & z)
{
  constexpr double h = 1e-5;
  const auto       difference = [&](const std::complex<double> & step) {
    const auto                    ahead = torus(z + step);
    const auto                    behind = torus(z - step);
    shapeton::TorusInSpace::Point d{};
    for (int i = 0; i < 3; ++i)
    {
      d[i] = (ahead[i] - behind[i]) / (2.0 * h);
    }
    return d;
  };
  const auto x = difference(h);
  const auto y = difference(std::complex<double>(0.0, h));
  const auto dot = [](const auto & a, const auto & b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  return { dot(x, x), dot(y, y), dot(x, y) };
}
} // namespace

TEST(TorusInSpace, ARectangularLatticeIsMappedConformally)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(5, 8);
  const auto                       certificate = shapeton::EmbedGraph(map.ToGraph(), map);
  const shapeton::TorusInSpace     torus(certificate);
  EXPECT_NEAR(torus.Dilatation(), 1.0, 1e-9);
  EXPECT_NEAR(torus.TubeRadius() / std::sqrt(1.0 - torus.TubeRadius() * torus.TubeRadius()), 5.0 / 8.0, 1e-12);
  for (const std::complex<double> & z : { std::complex<double>(0.3, 0.1), { 2.0, 3.0 }, { -1.0, 4.5 } })
  {
    const auto metric = Metric(torus, z);
    EXPECT_NEAR(metric[1] / metric[0], 1.0, 1e-6);
    EXPECT_NEAR(metric[2] / metric[0], 0.0, 1e-6);
  }
}

TEST(TorusInSpace, AnObliqueLatticeHasTheStatedDilatation)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(6, 6, true);
  const auto                       certificate = shapeton::EmbedGraph(map.ToGraph(), map);
  const shapeton::TorusInSpace     torus(certificate);
  const auto                       metric = Metric(torus, { 0.4, -0.7 });
  const double                     mean = 0.5 * (metric[0] + metric[1]);
  const double                     half = std::hypot(0.5 * (metric[0] - metric[1]), metric[2]);
  EXPECT_GT(torus.Dilatation(), 1.5);
  EXPECT_NEAR(std::sqrt((mean + half) / (mean - half)), torus.Dilatation(), 1e-5);
}

TEST(TorusInSpace, NodesAndEdgesLieOnTheTorusAndMeet)
{
  const shapeton::CombinatorialMap map = shapeton::TorusGridMap(7, 4, true);
  const auto                       certificate = shapeton::EmbedGraph(map.ToGraph(), map);
  const shapeton::TorusInSpace     torus(certificate);
  const auto                       nodes = torus.Nodes();
  const auto                       edges = torus.Edges(8);
  ASSERT_EQ(nodes.size(), 28U);
  ASSERT_EQ(edges.size(), certificate.graph.edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    EXPECT_LT(Distance(edges[e].front(), nodes[certificate.graph.edges[e][0]]), 1e-9);
    EXPECT_LT(Distance(edges[e].back(), nodes[certificate.graph.edges[e][1]]), 1e-9);
    for (const auto & p : edges[e])
    {
      EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]), torus.TubeRadius(), 1e-12);
    }
  }
}
