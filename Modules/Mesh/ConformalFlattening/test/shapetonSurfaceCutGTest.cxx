#include "shapetonSurfaceCut.h"

#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace testsurfaces;

constexpr int around = 12;
constexpr int along = 6;

/** Column 0 of a cylinder, from bottom to top. */
std::vector<int>
Meridian()
{
  std::vector<int> path;
  for (int j = 0; j <= along; ++j)
  {
    path.push_back(j * around);
  }
  return path;
}

shapeton::CutSurface
Cut(const shapeton::SurfaceMesh & mesh, const std::vector<std::vector<int>> & paths)
{
  return shapeton::CutAlongPaths(mesh, shapeton::SurfaceConnectivity(mesh), paths);
}

/** For a vertex function with a unit jump at these corners: its largest difference within any one face. */
double
GreatestStep(const shapeton::SurfaceMesh & mesh,
             const std::vector<double> &   values,
             const std::vector<int> &      leftCorners)
{
  double greatest = 0.0;
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    std::array<double, 3> lifted;
    for (int k = 0; k < 3; ++k)
    {
      const bool isLeft = std::binary_search(leftCorners.begin(), leftCorners.end(), 3 * f + k);
      lifted[k] = values[mesh.F(f, k)] + (isLeft ? 1.0 : 0.0);
    }
    const auto [low, high] = std::minmax_element(lifted.begin(), lifted.end());
    greatest = std::max(greatest, *high - *low);
  }
  return greatest;
}

void
ExpectSamePlaces(const shapeton::SurfaceMesh & mesh, const shapeton::CutSurface & cut)
{
  ASSERT_EQ(mesh.NumberOfFaces(), cut.mesh.NumberOfFaces());
  ASSERT_EQ(cut.mesh.NumberOfVertices(), static_cast<int>(cut.sourcePointId.size()));
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_EQ(mesh.F(f, k), cut.sourcePointId[cut.mesh.F(f, k)]);
      ASSERT_EQ(mesh.V.row(mesh.F(f, k)), cut.mesh.V.row(cut.mesh.F(f, k)));
    }
  }
}
} // namespace

TEST(SurfaceCut, CylinderBecomesADisk)
{
  shapeton::SurfaceMesh mesh = Cylinder(around, along, 10.0, 60.0);
  mesh.pointArrays.push_back({ "height", mesh.V.col(2), false });
  const shapeton::CutSurface          cut = Cut(mesh, { Meridian() });
  const shapeton::SurfaceConnectivity after(cut.mesh);
  ExpectSamePlaces(mesh, cut);
  EXPECT_EQ(mesh.NumberOfVertices() + along + 1, cut.mesh.NumberOfVertices());
  ASSERT_EQ(1U, after.Components().size());
  EXPECT_EQ(1, after.Components()[0].eulerCharacteristic);
  EXPECT_EQ(1, after.Components()[0].boundaryLoops);
  EXPECT_TRUE(after.IsManifold());
  ASSERT_EQ(1U, cut.mesh.pointArrays.size());
  EXPECT_EQ(cut.mesh.V.col(2), cut.mesh.pointArrays[0].values.col(0));
}

TEST(SurfaceCut, TurnsAroundACylinderAreContinuousWithTheJumpOnTheLeft)
{
  const shapeton::SurfaceMesh mesh = Cylinder(around, along, 10.0, 60.0);
  std::vector<double>         turns;
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    turns.push_back(double(v % around) / around);
  }
  // Seen from outside with the axis up, the last columns are left of the meridian. The downward path has the first
  // column on its left, the upward path the last one.
  const std::vector<int> left = Cut(mesh, { Meridian() }).leftCorners[0];
  EXPECT_GT(GreatestStep(mesh, turns, {}), 0.5);
  EXPECT_NEAR(1.0 / around, GreatestStep(mesh, turns, left), 1e-12);
  std::vector<int> down = Meridian();
  std::reverse(down.begin(), down.end());
  const std::vector<int> right = Cut(mesh, { down }).leftCorners[0];
  EXPECT_GT(GreatestStep(mesh, turns, right), 0.5);
  EXPECT_EQ(6U * along, left.size() + right.size());
}

TEST(SurfaceCut, PathInsideOpensASlit)
{
  const shapeton::SurfaceMesh         mesh = Square(6, 6.0);
  const std::vector<int>              path{ 16, 17, 18 }; // row 2 of 7 x 7 vertices
  const shapeton::CutSurface          cut = Cut(mesh, { path });
  const shapeton::SurfaceConnectivity after(cut.mesh);
  ExpectSamePlaces(mesh, cut);
  EXPECT_EQ(mesh.NumberOfVertices() + 1, cut.mesh.NumberOfVertices());
  EXPECT_EQ(17, cut.sourcePointId.back());
  ASSERT_EQ(2U, after.BoundaryLoops().size());
  EXPECT_EQ(4U, std::min(after.BoundaryLoops()[0].size(), after.BoundaryLoops()[1].size()));
  ASSERT_EQ(1U, cut.leftCorners.size());
  ASSERT_FALSE(cut.leftCorners[0].empty());
  for (const int corner : cut.leftCorners[0])
  {
    EXPECT_EQ(17, mesh.F(corner / 3, corner % 3));
    // Seen from +z, the left side of a path along +x is +y.
    EXPECT_GT((mesh.V(mesh.F(corner / 3, 0), 1) + mesh.V(mesh.F(corner / 3, 1), 1) + mesh.V(mesh.F(corner / 3, 2), 1)),
              3 * mesh.V(17, 1));
  }
}

TEST(SurfaceCut, CrossingLoopsOpenATorus)
{
  const shapeton::SurfaceMesh mesh = Torus(8, 5, 30.0, 10.0);
  const std::vector<int>      ring{ 0, 1, 2, 3, 4, 5, 6, 7, 0 };
  const std::vector<int>      across{ 0, 8, 16, 24, 32, 0 };
  const shapeton::CutSurface  one = Cut(mesh, { ring });
  ExpectSamePlaces(mesh, one);
  EXPECT_EQ(2U, shapeton::SurfaceConnectivity(one.mesh).BoundaryLoops().size());
  EXPECT_EQ(3U * 8U, one.leftCorners[0].size());
  const shapeton::CutSurface          two = Cut(mesh, { ring, across });
  const shapeton::SurfaceConnectivity after(two.mesh);
  ExpectSamePlaces(mesh, two);
  ASSERT_EQ(1U, after.Components().size());
  EXPECT_EQ(1, after.Components()[0].eulerCharacteristic);
  EXPECT_EQ(4, std::count(two.sourcePointId.begin(), two.sourcePointId.end(), 0));
  EXPECT_TRUE(after.IsManifold());
}

TEST(SurfaceCut, LeftGoesOnBehindABoundary)
{
  // A path from the inside to the rim of a square and back: the region between its edges is on its left or right.
  const shapeton::SurfaceMesh         mesh = Square(4, 4.0);
  const shapeton::SurfaceConnectivity connectivity(mesh);
  const std::vector<int>              left = shapeton::LeftCorners(mesh.F, connectivity, { 7, 2, 8 });
  const std::vector<int>              right = shapeton::LeftCorners(mesh.F, connectivity, { 8, 2, 7 });
  EXPECT_EQ(1U, std::min(left.size(), right.size()));
  EXPECT_EQ(static_cast<std::size_t>(connectivity.FacesOfVertex(2).size()), left.size() + right.size());
}

TEST(SurfaceCut, RefusesPathsThatAreNone)
{
  const shapeton::SurfaceMesh mesh = Square(4, 4.0);
  EXPECT_THROW(Cut(mesh, { { 0, 24 } }), shapeton::InputError);
  EXPECT_THROW(Cut(mesh, { { 0, 99 } }), shapeton::InputError);
  EXPECT_THROW(Cut(mesh, { { -1, 0 } }), shapeton::InputError);
  shapeton::SurfaceMesh turned = mesh;
  std::swap(turned.F(9, 0), turned.F(9, 1));
  const int a = turned.F(9, 0);
  const int b = turned.F(9, 1);
  const int c = turned.F(9, 2);
  EXPECT_THROW(Cut(turned, { { a, b, c } }), shapeton::InputError);
  EXPECT_EQ(mesh.F, Cut(mesh, { { 3 } }).mesh.F);
}
