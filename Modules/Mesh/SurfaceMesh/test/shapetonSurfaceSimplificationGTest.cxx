#include "shapetonSurfaceSimplification.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include "gtest/gtest.h"

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
Simplified(const shapeton::SurfaceMesh & mesh, int faces, shapeton::SurfaceSimplificationReport * report = nullptr)
{
  shapeton::SurfaceSimplificationSettings options;
  options.faces = faces;
  return shapeton::SimplifySurface(mesh, options, report);
}

/** Topological invariants of collapses. */
void
ExpectSameTopology(const shapeton::SurfaceMesh & before, const shapeton::SurfaceMesh & after)
{
  const shapeton::SurfaceConnectivity a(before);
  const shapeton::SurfaceConnectivity b(after);
  EXPECT_TRUE(b.IsManifold());
  EXPECT_TRUE(b.IsOriented());
  EXPECT_EQ(a.BoundaryLoops().size(), b.BoundaryLoops().size());
  ASSERT_EQ(a.Components().size(), b.Components().size());
  for (std::size_t c = 0; c < a.Components().size(); ++c)
  {
    EXPECT_EQ(a.Components()[c].genus, b.Components()[c].genus);
    EXPECT_EQ(a.Components()[c].boundaryLoops, b.Components()[c].boundaryLoops);
  }
  EXPECT_TRUE(shapeton::FindSurfaceDefects(after, b).degenerateFaces.empty());
  EXPECT_TRUE(shapeton::FindSurfaceDefects(after, b).duplicateFaces.empty());
  EXPECT_TRUE(shapeton::FindSurfaceDefects(after, b).unreferencedVertices.empty());
}

double
GreatestDistance(const shapeton::SurfaceMesh & from, const shapeton::SurfaceMesh & to)
{
  const shapeton::SurfaceLocator locator(to.V, to.F);
  double                         greatest = 0.0;
  for (int v = 0; v < from.NumberOfVertices(); ++v)
  {
    greatest = std::max(greatest, locator.FindClosest(from.V.row(v).transpose()).distance);
  }
  return greatest;
}

TEST(SurfaceSimplification, SphereStaysASphere)
{
  const double                          radius = 50.0;
  const shapeton::SurfaceMesh           sphere = Icosphere(6, radius); // 81920 faces
  shapeton::SurfaceSimplificationReport report;
  const shapeton::SurfaceMesh           simple = Simplified(sphere, 4000, &report);
  const shapeton::SurfaceQuality        quality = shapeton::InspectSurface(simple);
  EXPECT_TRUE(report.reachedTarget);
  EXPECT_EQ(simple.NumberOfFaces(), 4000);
  ExpectSameTopology(sphere, simple);
  EXPECT_GE(quality.smallestAngle.minimum, 20.0 - 1e-6);
  // An equilateral triangle of side l with corners on the sphere reaches l^2 / (6 R) below it. Twice that is allowed
  // because triangle sizes differ and optimal vertices are outside the sphere.
  const double side = std::sqrt(4.0 * Pi * radius * radius / 4000.0 * 4.0 / std::sqrt(3.0));
  const double bound = 2.0 * side * side / (6.0 * radius); // 0.12 mm
  for (int v = 0; v < simple.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(simple.V.row(v).norm(), radius, bound);
  }
  EXPECT_LE(GreatestDistance(sphere, simple), bound);
  EXPECT_NEAR(*quality.volume, 4.0 / 3.0 * Pi * std::pow(radius, 3), 4.0 * Pi * radius * radius * bound);
}

TEST(SurfaceSimplification, AskedNumbersOfFacesAreMet)
{
  const shapeton::SurfaceMesh torus = Roughened(Torus(60, 40, 20, 8), 0.05, 1);
  for (const int faces : { 4799, 3001, 1000, 200 })
  {
    shapeton::SurfaceSimplificationReport report;
    const shapeton::SurfaceMesh           simple = Simplified(torus, faces, &report);
    EXPECT_LE(simple.NumberOfFaces(), faces);
    EXPECT_GE(simple.NumberOfFaces(), faces - 1);
    EXPECT_EQ(report.faces, simple.NumberOfFaces());
    ExpectSameTopology(torus, simple);
  }
}

TEST(SurfaceSimplification, FlatPartsStayFlatAndKeepTheirCorners)
{
  const shapeton::SurfaceMesh simple = Simplified(Square(40, 10.0), 100);
  ExpectSameTopology(Square(40, 10.0), simple);
  EXPECT_LE(simple.V.col(2).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(shapeton::SurfaceArea(simple.V, simple.F), 100.0, 0.1);
}

TEST(SurfaceSimplification, BoundariesOfACylinderStay)
{
  const shapeton::SurfaceMesh    cylinder = Cylinder(100, 80, 20.0, 60.0);
  const shapeton::SurfaceMesh    simple = Simplified(cylinder, 1500);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(simple);
  ExpectSameTopology(cylinder, simple);
  ASSERT_EQ(quality.boundaryLoopLengths.size(), 2u);
  for (const double length : quality.boundaryLoopLengths)
  {
    EXPECT_NEAR(length, 2.0 * Pi * 20.0, 1.0);
  }
  EXPECT_NEAR(simple.V.col(2).minCoeff(), 0.0, 0.05);
  EXPECT_NEAR(simple.V.col(2).maxCoeff(), 60.0, 0.05);
  EXPECT_LE(GreatestDistance(cylinder, simple), 0.5);
}

TEST(SurfaceSimplification, StopsWithAReasonWhenTopologyForbidsMore)
{
  shapeton::SurfaceSimplificationReport report;
  const shapeton::SurfaceMesh           torus = Torus(24, 16, 20, 8);
  const shapeton::SurfaceMesh           simple = Simplified(torus, 1, &report);
  EXPECT_FALSE(report.reachedTarget);
  EXPECT_FALSE(report.reason.empty());
  EXPECT_GE(simple.NumberOfFaces(), 14); // the minimum for a torus (Moebius, Csaszar)
  ExpectSameTopology(torus, simple);
}

class SurfaceSimplificationToTheEnd : public testing::TestWithParam<int>
{};

// Topology must be preserved on rough surfaces simplified as far as possible.
TEST_P(SurfaceSimplificationToTheEnd, KeepsTheTopology)
{
  const int                   seed = GetParam();
  const shapeton::SurfaceMesh mesh = Roughened(
    Together({ Icosphere(1, 2), Torus(9, 7, 6, 2), Cylinder(7, 5, 3, 8), Square(5, 4.0), Octahedron() }), 0.4, seed);
  for (const int faces : { 250, 120, 60, 1 })
  {
    ExpectSameTopology(mesh, Simplified(mesh, faces));
  }
}

INSTANTIATE_TEST_SUITE_P(Random, SurfaceSimplificationToTheEnd, testing::Range(1, 16));

TEST(SurfaceSimplification, EqualInputGivesEqualOutput)
{
  const shapeton::SurfaceMesh torus = Torus(60, 40, 20, 8); // many edges have equal cost
  const shapeton::SurfaceMesh one = Simplified(torus, 700);
  const shapeton::SurfaceMesh two = Simplified(torus, 700);
  EXPECT_EQ(one.V, two.V);
  EXPECT_EQ(one.F, two.F);
}

TEST(SurfaceSimplification, PlaceDoesNotMatterMuch)
{
  const shapeton::SurfaceMesh torus = Roughened(Torus(60, 40, 20, 8), 0.05, 1);
  shapeton::SurfaceMesh       far = torus;
  far.V.rowwise() += Eigen::RowVector3d(1e4, -2e4, 5e3);
  const shapeton::SurfaceMesh near = Simplified(torus, 1000);
  const shapeton::SurfaceMesh moved = Simplified(far, 1000);
  EXPECT_NEAR(shapeton::SurfaceArea(near.V, near.F), shapeton::SurfaceArea(moved.V, moved.F), 1.0);
}

TEST(SurfaceSimplification, EnoughIsLeftAloneAndATetrahedronAndATriangleStay)
{
  shapeton::SurfaceMesh mesh = Octahedron();
  mesh.pointArrays.push_back({ "z", mesh.V.col(2), false });
  const shapeton::SurfaceMesh same = Simplified(mesh, 8);
  EXPECT_EQ(same.F, mesh.F);
  EXPECT_EQ(same.pointArrays.size(), 1u);
  const shapeton::SurfaceMesh tetrahedron = FromLists({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                                                      { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  EXPECT_EQ(Simplified(tetrahedron, 1).F, tetrahedron.F);
  EXPECT_EQ(Simplified(Icosphere(2, 3), 4).NumberOfFaces(), 4);
  EXPECT_EQ(Simplified(Square(6, 3), 1).NumberOfFaces(), 1);
}

TEST(SurfaceSimplification, WrongInputIsRefused)
{
  EXPECT_THROW(Simplified(Octahedron(), 0), shapeton::ParameterError);
  EXPECT_THROW(Simplified(MoebiusStrip(9, 3), 10), shapeton::InputError);
  EXPECT_THROW(Simplified(Together({ Octahedron(), FromLists({ { 0, 0, 0 } }, { { 0, 0, 0 } }) }), 4),
               shapeton::InputError);
  shapeton::SurfaceSimplificationSettings options;
  options.smallestAngle = 31.0;
  EXPECT_THROW(shapeton::SimplifySurface(Octahedron(), options), shapeton::ParameterError);
}
} // namespace
