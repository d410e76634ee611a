#include "itkSurfaceSimplification.h"
#include "itkSurfaceLocator.h"
#include "itkSurfaceQuality.h"
#include "itkTestSurfaces.h"
#include "itkExceptions.h"

#include "gtest/gtest.h"

namespace
{
using namespace testsurfaces;

itk::SurfaceMesh
Simplified(const itk::SurfaceMesh & mesh, int faces, itk::SurfaceSimplificationReport * report = nullptr)
{
  itk::SurfaceSimplificationOptions options;
  options.targetFaces = faces;
  return itk::SimplifySurface(mesh, options, report);
}

/** What no collapse may change. */
void
ExpectSameTopology(const itk::SurfaceMesh & before, const itk::SurfaceMesh & after)
{
  const itk::SurfaceConnectivity a(before);
  const itk::SurfaceConnectivity b(after);
  EXPECT_TRUE(b.IsManifold());
  EXPECT_TRUE(b.IsOriented());
  EXPECT_EQ(a.BoundaryLoops().size(), b.BoundaryLoops().size());
  ASSERT_EQ(a.Components().size(), b.Components().size());
  for (std::size_t c = 0; c < a.Components().size(); ++c)
  {
    EXPECT_EQ(a.Components()[c].genus, b.Components()[c].genus);
    EXPECT_EQ(a.Components()[c].boundaryLoops, b.Components()[c].boundaryLoops);
  }
  EXPECT_TRUE(itk::FindSurfaceDefects(after, b).degenerateFaces.empty());
  EXPECT_TRUE(itk::FindSurfaceDefects(after, b).duplicateFaces.empty());
  EXPECT_TRUE(itk::FindSurfaceDefects(after, b).unreferencedVertices.empty());
}

double
GreatestDistance(const itk::SurfaceMesh & from, const itk::SurfaceMesh & to)
{
  const itk::SurfaceLocator locator(to.V, to.F);
  double                    greatest = 0.0;
  for (int v = 0; v < from.NumberOfVertices(); ++v)
  {
    greatest = std::max(greatest, locator.FindClosest(from.V.row(v).transpose()).distance);
  }
  return greatest;
}

TEST(SurfaceSimplification, SphereStaysASphere)
{
  const double                     radius = 50.0;
  const itk::SurfaceMesh           sphere = Icosphere(6, radius); // 81920 faces
  itk::SurfaceSimplificationReport report;
  const itk::SurfaceMesh           simple = Simplified(sphere, 4000, &report);
  const itk::SurfaceQuality        quality = itk::InspectSurface(simple);
  EXPECT_TRUE(report.reachedTarget);
  EXPECT_EQ(simple.NumberOfFaces(), 4000);
  ExpectSameTopology(sphere, simple);
  EXPECT_GE(quality.smallestAngle.minimum, 20.0 - 1e-6);
  // An equilateral triangle of side l with corners on the sphere reaches l^2 / (6 R) below it. Triangles differ in size
  // and the optimal vertices lie outside, so twice that is allowed.
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
  const itk::SurfaceMesh torus = Roughened(Torus(60, 40, 20, 8), 0.05, 1);
  for (const int faces : { 4799, 3001, 1000, 200 })
  {
    itk::SurfaceSimplificationReport report;
    const itk::SurfaceMesh           simple = Simplified(torus, faces, &report);
    EXPECT_LE(simple.NumberOfFaces(), faces);
    EXPECT_GE(simple.NumberOfFaces(), faces - 1);
    EXPECT_EQ(report.faces, simple.NumberOfFaces());
    ExpectSameTopology(torus, simple);
  }
}

TEST(SurfaceSimplification, FlatPartsStayFlatAndKeepTheirCorners)
{
  const itk::SurfaceMesh simple = Simplified(Square(40, 10.0), 100);
  ExpectSameTopology(Square(40, 10.0), simple);
  EXPECT_LE(simple.V.col(2).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(itk::SurfaceArea(simple.V, simple.F), 100.0, 0.1);
}

TEST(SurfaceSimplification, BoundariesOfACylinderStay)
{
  const itk::SurfaceMesh    cylinder = Cylinder(100, 80, 20.0, 60.0);
  const itk::SurfaceMesh    simple = Simplified(cylinder, 1500);
  const itk::SurfaceQuality quality = itk::InspectSurface(simple);
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
  itk::SurfaceSimplificationReport report;
  const itk::SurfaceMesh           torus = Torus(24, 16, 20, 8);
  const itk::SurfaceMesh           simple = Simplified(torus, 1, &report);
  EXPECT_FALSE(report.reachedTarget);
  EXPECT_FALSE(report.reason.empty());
  EXPECT_GE(simple.NumberOfFaces(), 14); // no torus has fewer (Moebius, Csaszar)
  ExpectSameTopology(torus, simple);
}

class SurfaceSimplificationToTheEnd : public testing::TestWithParam<int>
{};

// Rough surfaces of every kind, as far down as it goes: whatever the geometry, the topology stays.
TEST_P(SurfaceSimplificationToTheEnd, KeepsTheTopology)
{
  const int              seed = GetParam();
  const itk::SurfaceMesh mesh = Roughened(
    Together({ Icosphere(1, 2), Torus(9, 7, 6, 2), Cylinder(7, 5, 3, 8), Square(5, 4.0), Octahedron() }), 0.4, seed);
  for (const int faces : { 250, 120, 60, 1 })
  {
    ExpectSameTopology(mesh, Simplified(mesh, faces));
  }
}

INSTANTIATE_TEST_SUITE_P(Random, SurfaceSimplificationToTheEnd, testing::Range(1, 16));

TEST(SurfaceSimplification, EqualInputGivesEqualOutput)
{
  const itk::SurfaceMesh torus = Torus(60, 40, 20, 8); // many equal costs
  const itk::SurfaceMesh one = Simplified(torus, 700);
  const itk::SurfaceMesh two = Simplified(torus, 700);
  EXPECT_EQ(one.V, two.V);
  EXPECT_EQ(one.F, two.F);
}

TEST(SurfaceSimplification, PlaceDoesNotMatterMuch)
{
  const itk::SurfaceMesh torus = Roughened(Torus(60, 40, 20, 8), 0.05, 1);
  itk::SurfaceMesh       far = torus;
  far.V.rowwise() += Eigen::RowVector3d(1e4, -2e4, 5e3);
  const itk::SurfaceMesh near = Simplified(torus, 1000);
  const itk::SurfaceMesh moved = Simplified(far, 1000);
  EXPECT_NEAR(itk::SurfaceArea(near.V, near.F), itk::SurfaceArea(moved.V, moved.F), 1.0);
}

TEST(SurfaceSimplification, EnoughIsLeftAlone)
{
  itk::SurfaceMesh mesh = Octahedron();
  mesh.pointArrays.push_back({ "z", mesh.V.col(2), false });
  const itk::SurfaceMesh same = Simplified(mesh, 8);
  EXPECT_EQ(same.F, mesh.F);
  EXPECT_EQ(same.pointArrays.size(), 1u);
}

TEST(SurfaceSimplification, ATetrahedronAndATriangleStay)
{
  const itk::SurfaceMesh tetrahedron = FromLists({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                                                 { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } });
  EXPECT_EQ(Simplified(tetrahedron, 1).F, tetrahedron.F);
  EXPECT_EQ(Simplified(Icosphere(2, 3), 4).NumberOfFaces(), 4);
  EXPECT_EQ(Simplified(Square(6, 3), 1).NumberOfFaces(), 1);
}

TEST(SurfaceSimplification, WrongInputIsRefused)
{
  EXPECT_THROW(Simplified(Octahedron(), 0), itk::ParameterError);
  EXPECT_THROW(Simplified(MoebiusStrip(9, 3), 10), itk::InputError);
  EXPECT_THROW(Simplified(Together({ Octahedron(), FromLists({ { 0, 0, 0 } }, { { 0, 0, 0 } }) }), 4), itk::InputError);
  itk::SurfaceSimplificationOptions options;
  options.smallestAngle = 31.0;
  EXPECT_THROW(itk::SimplifySurface(Octahedron(), options), itk::ParameterError);
}
} // namespace
