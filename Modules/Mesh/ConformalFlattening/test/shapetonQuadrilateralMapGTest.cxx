#include "shapetonQuadrilateralMap.h"

#include "shapetonPlanarDomains.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

struct Disk
{
  explicit Disk(SurfaceMesh surface)
    : mesh(std::move(surface)), connectivity(mesh), boundary(BoundaryLoopsByLength(connectivity, mesh.V).front())
  {}
  QuadrilateralMap
  Map(const std::array<int, 4> & corners) const
  {
    return MapQuadrilateral(connectivity, EdgeLengths(connectivity, mesh.V), boundary, corners);
  }
  /** Returns the vertex at a position. */
  int
  At(double x, double y) const
  {
    Eigen::Index vertex = 0;
    (mesh.V.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().squaredNorm().minCoeff(&vertex);
    return static_cast<int>(vertex);
  }

  SurfaceMesh         mesh;
  SurfaceConnectivity connectivity;
  BoundaryLoop        boundary;
};

SurfaceMesh
Rectangle(int columns, int rows, double width, double height)
{
  return Grid(columns, rows, Wrap::None, [=](double s, double t) { return Eigen::Vector3d(width * s, height * t, 0); });
}

TEST(QuadrilateralMap, RectanglesAreTheirOwnMaps)
{
  const Disk             disk(Rectangle(12, 9, 30.0, 20.0));
  const QuadrilateralMap map = disk.Map({ disk.At(0, 0), disk.At(30, 0), disk.At(30, 20), disk.At(0, 20) });
  EXPECT_NEAR(map.modulusU, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(map.modulusV, 2.0 / 3.0, 1e-12);
  for (int i = 0; i < disk.mesh.NumberOfVertices(); ++i)
  {
    EXPECT_NEAR(map.u[i], disk.mesh.V(i, 0) / 30.0, 1e-12);
    EXPECT_NEAR(map.v[i], disk.mesh.V(i, 1) / 20.0, 1e-12);
  }
}

TEST(QuadrilateralMap, CornersRunCounterclockwiseWhateverWayTheyAreNamed)
{
  const Disk disk(Rectangle(6, 4, 30.0, 20.0));
  const auto map = disk.Map({ disk.At(30, 0), disk.At(0, 0), disk.At(0, 20), disk.At(30, 20) });
  EXPECT_EQ(map.corners, (std::array<int, 4>{ disk.At(30, 0), disk.At(30, 20), disk.At(0, 20), disk.At(0, 0) }));
  EXPECT_NEAR(map.modulusU, 1.5, 1e-12);
  EXPECT_NEAR(map.u[disk.At(30, 20)], 1.0, 1e-14);
  EXPECT_NEAR(map.v[disk.At(0, 20)], 1.0, 1e-14);
}

TEST(QuadrilateralMap, HalfDisksHaveTheModulusOfTheirCrossRatio)
{
  const Disk disk(HalfDisk(60));
  // z -> ((1 + z) / (1 - z))^2 takes -1, 1, exp(i a), exp(i b) to 0, infinity, -cot(a/2)^2, -cot(b/2)^2.
  for (const double a : { Pi / 3.0, Pi / 6.0 })
  {
    const double b = Pi - a;
    const double third = -std::pow(std::tan(0.5 * a), -2);
    const double fourth = -std::pow(std::tan(0.5 * b), -2);
    // Their ascending order is third, fourth, first, second; the width is the side from the first to the second.
    const double modulus = ModulusOfCrossRatio(1.0 - fourth / third);
    const auto   map =
      disk.Map({ disk.At(-1, 0), disk.At(1, 0), disk.At(std::cos(a), std::sin(a)), disk.At(std::cos(b), std::sin(b)) });
    EXPECT_NEAR(std::sqrt(map.modulusU * map.modulusV) / modulus, 1.0, 3e-3) << a;
    EXPECT_GT(map.modulusU, modulus * 0.999);
    EXPECT_LT(map.modulusV, modulus * 1.001);
  }
}

TEST(QuadrilateralMap, DisksWithSymmetricCornersAreSquares)
{
  const Disk   disk(Grid(40, 40, Wrap::None, [](double s, double t) {
    // A square mapped to a disk, with corners on the diagonals.
    const double x = 2 * s - 1, y = 2 * t - 1;
    return Eigen::Vector3d(x * std::sqrt(1 - 0.5 * y * y), y * std::sqrt(1 - 0.5 * x * x), 0.0);
  }));
  const double c = std::sqrt(0.5);
  const auto   map = disk.Map({ disk.At(-c, -c), disk.At(c, -c), disk.At(c, c), disk.At(-c, c) });
  EXPECT_NEAR(std::sqrt(map.modulusU * map.modulusV), 1.0, 1e-10); // because the grid is symmetric
  EXPECT_GT(map.modulusU, 1.0);
  EXPECT_LT(map.modulusV, 1.0);
}

TEST(QuadrilateralMap, RefusesCornersThatAreNone)
{
  const Disk disk(Rectangle(6, 4, 30.0, 20.0));
  const int  a = disk.At(0, 0), b = disk.At(30, 0), c = disk.At(30, 20), d = disk.At(0, 20);
  EXPECT_THROW(disk.Map({ a, b, c, c }), InputError);
  EXPECT_THROW(disk.Map({ a, c, b, d }), InputError);
  EXPECT_THROW(disk.Map({ a, b, disk.At(15, 10), d }), InputError);
  EXPECT_THROW(disk.Map({ a, b, c, 1000 }), InputError);
}

TEST(QuadrilateralMap, SpreadCornersAreThoseOfARectangle)
{
  const Disk               disk(Rectangle(12, 5, 60.0, 20.0));
  const std::array<int, 4> corners = SpreadCorners(disk.boundary, disk.mesh.V);
  const std::array<int, 4> expected{ disk.At(0, 0), disk.At(60, 0), disk.At(60, 20), disk.At(0, 20) };
  EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), expected.begin()));
  EXPECT_NO_THROW(disk.Map(corners));
  BoundaryLoop triangle{ { 0, 1, 2 }, 3.0 };
  EXPECT_THROW(SpreadCorners(triangle, disk.mesh.V), InputError);
}
} // namespace
