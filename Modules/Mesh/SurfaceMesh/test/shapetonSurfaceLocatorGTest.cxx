#include "shapetonSurfaceLocator.h"
#include "shapetonTestSurfaces.h"

#include "gtest/gtest.h"

#include <stdexcept>

namespace
{
using namespace testsurfaces;

// Dense sampling yields a tight upper bound; the point must be inside the triangle.
TEST(SurfaceLocator, ClosestPointOfATriangleIsNoFartherThanAnySample)
{
  Random    random(1);
  const int samples = 60;
  for (int trial = 0; trial < 200; ++trial)
  {
    Eigen::Vector3d c[4];
    for (auto & corner : c)
    {
      corner = Eigen::Vector3d(random.Signed(), random.Signed(), random.Signed());
    }
    const Eigen::Vector3d closest = shapeton::ClosestPointOfTriangle(c[3], c[0], c[1], c[2]);
    double                best = 10.0;
    for (int i = 0; i <= samples; ++i)
    {
      for (int j = 0; i + j <= samples; ++j)
      {
        const double u = double(i) / samples;
        const double v = double(j) / samples;
        best = std::min(best, (c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]) - c[3]).norm());
      }
    }
    const double distance = (closest - c[3]).norm();
    EXPECT_LE(distance, best + 1e-12);
    EXPECT_GE(distance, best - 4.0 / samples);
    const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
    EXPECT_NEAR(normal.dot(closest - c[0]), 0.0, 1e-12);
  }
}

TEST(SurfaceLocator, TrianglesWithoutAreaAreSegmentsAndPoints)
{
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(2, 0, 0);
  const Eigen::Vector3d middle(1, 0, 0);
  const Eigen::Vector3d p(1.5, 1, 0);
  EXPECT_NEAR((shapeton::ClosestPointOfTriangle(p, a, b, middle) - Eigen::Vector3d(1.5, 0, 0)).norm(), 0.0, 1e-15);
  EXPECT_EQ(shapeton::ClosestPointOfTriangle(p, b, b, b), b);
}

TEST(SurfaceLocator, TreeAgreesWithAllFaces)
{
  const shapeton::SurfaceMesh    mesh = Roughened(Torus(20, 12, 5, 2), 0.2, 4);
  const shapeton::SurfaceLocator locator(mesh.V, mesh.F);
  Random                         random(2);
  for (int trial = 0; trial < 300; ++trial)
  {
    const Eigen::Vector3d p(8 * random.Signed(), 8 * random.Signed(), 4 * random.Signed());
    double                best = 100.0;
    for (int f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      const Eigen::Vector3d q = shapeton::ClosestPointOfTriangle(
        p, mesh.V.row(mesh.F(f, 0)), mesh.V.row(mesh.F(f, 1)), mesh.V.row(mesh.F(f, 2)));
      best = std::min(best, (q - p).norm());
    }
    const auto closest = locator.FindClosest(p);
    EXPECT_EQ(closest.distance, best);
    EXPECT_NEAR((closest.point - p).norm(), best, 1e-14);
  }
}

TEST(SurfaceLocator, NeedsFaces)
{
  const shapeton::SurfaceMesh mesh = Octahedron();
  EXPECT_THROW(shapeton::SurfaceLocator(mesh.V, shapeton::FaceMatrix(0, 3)), std::invalid_argument);
  EXPECT_THROW(shapeton::SurfaceLocator(mesh.V.topRows(3), mesh.F), std::invalid_argument);
}
} // namespace
