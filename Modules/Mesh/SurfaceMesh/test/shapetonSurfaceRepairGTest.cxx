#include "shapetonSurfaceRepair.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonTestSurfaces.h"
#include "shapetonTestErrors.h"

#include "gtest/gtest.h"

#include <set>

namespace
{
using namespace testsurfaces;

TEST(SurfaceRepair, SixSquaresBecomeACube)
{
  shapeton::SurfaceRepairReport  report;
  const shapeton::SurfaceMesh    cube = shapeton::RepairSurface(CubeOfSixSquares(2.0), {}, &report);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(cube);
  EXPECT_EQ(report.mergedVertices, 16);
  EXPECT_EQ(report.turnedFaces, 0);
  EXPECT_EQ(cube.NumberOfVertices(), 8);
  EXPECT_TRUE(quality.isClosed);
  EXPECT_EQ(quality.genus, 0);
  EXPECT_NEAR(*quality.volume, 8.0, 1e-12);
  EXPECT_EQ(report.Words(), std::vector<std::string>({ "16 coincident vertices were merged" }));
}

TEST(SurfaceRepair, LeavesASoundSurfaceAlone)
{
  shapeton::SurfaceMesh mesh = Torus(9, 7, 5, 2);
  mesh.pointArrays.push_back({ "z", mesh.V.col(2), false });
  shapeton::SurfaceRepairReport report;
  const shapeton::SurfaceMesh   repaired = shapeton::RepairSurface(mesh, {}, &report);
  EXPECT_TRUE(report.Words().empty());
  EXPECT_EQ(repaired.V, mesh.V);
  EXPECT_EQ(repaired.F, mesh.F);
  ASSERT_EQ(repaired.pointArrays.size(), 1u);
  EXPECT_EQ(repaired.pointArrays[0].values, mesh.pointArrays[0].values);
}

TEST(SurfaceRepair, MergesWithinADistanceWhateverTheCell)
{
  shapeton::SurfaceMesh cube = Roughened(CubeOfSixSquares(2.0), 0.01, 7);
  EXPECT_EQ(shapeton::RepairSurface(cube).NumberOfVertices(), 24);
  shapeton::SurfaceRepairOptions options;
  options.mergeDistance = 0.05; // more than 0.02 sqrt(3)
  EXPECT_EQ(shapeton::RepairSurface(cube, options).NumberOfVertices(), 8);
  options.mergeVertices = false;
  EXPECT_EQ(shapeton::RepairSurface(cube, options).NumberOfVertices(), 24);
  options.mergeDistance = -1.0;
  EXPECT_THROW(shapeton::RepairSurface(cube, options), shapeton::ParameterError);
}

TEST(SurfaceRepair, TurnsClosedSurfacesOutwards)
{
  shapeton::SurfaceMesh mesh = Together({ Icosphere(2, 3.0), Torus(8, 6, 50, 2) });
  Random                random(3);
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    if (random.Below(3) > 0)
    {
      std::swap(mesh.F(f, 1), mesh.F(f, 2));
    }
  }
  const double expected = shapeton::EnclosedVolume(Icosphere(2, 3.0).V, Icosphere(2, 3.0).F) +
                          shapeton::EnclosedVolume(Torus(8, 6, 50, 2).V, Torus(8, 6, 50, 2).F);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(shapeton::RepairSurface(mesh));
  EXPECT_TRUE(quality.isOriented);
  EXPECT_NEAR(*quality.volume, expected, 1e-9 * expected);
}

TEST(SurfaceRepair, TurnsTheFewerFacesOfAnOpenSurface)
{
  shapeton::SurfaceMesh mesh = Cylinder(9, 4, 3, 5);
  for (const int f : { 0, 1, 30, 41 })
  {
    std::swap(mesh.F(f, 1), mesh.F(f, 2));
  }
  shapeton::SurfaceRepairReport report;
  const shapeton::SurfaceMesh   repaired = shapeton::RepairSurface(mesh, {}, &report);
  EXPECT_EQ(report.turnedFaces, 4);
  EXPECT_TRUE(shapeton::SurfaceConnectivity(repaired).IsOriented());
  const Eigen::Vector3d a = repaired.V.row(repaired.F(0, 0));
  const Eigen::Vector3d normal =
    (repaired.V.row(repaired.F(0, 1)).transpose() - a).cross(repaired.V.row(repaired.F(0, 2)).transpose() - a);
  EXPECT_GT(normal.dot(Eigen::Vector3d(a[0], a[1], 0.0)), 0.0); // outward, like most of the faces
}

TEST(SurfaceRepair, LeavesAMoebiusStripAndSaysSo)
{
  shapeton::SurfaceRepairReport report;
  const shapeton::SurfaceMesh   strip = MoebiusStrip(10, 2);
  const shapeton::SurfaceMesh   repaired = shapeton::RepairSurface(strip, {}, &report);
  EXPECT_EQ(report.nonOrientableComponents, 1);
  EXPECT_EQ(repaired.F, strip.F);
}

TEST(SurfaceRepair, TwoCubesThatShareAnEdgeOrACornerComeApart)
{
  for (const double height : { 0.0, 2.0 })
  {
    shapeton::SurfaceMesh second = CubeOfSixSquares(2.0);
    second.V.rowwise() += Eigen::RowVector3d(2.0, 2.0, height);
    shapeton::SurfaceRepairReport report;
    const shapeton::SurfaceMesh   repaired =
      shapeton::RepairSurface(Together({ CubeOfSixSquares(2.0), second }), {}, &report);
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(repaired);
    EXPECT_TRUE(quality.isManifold);
    EXPECT_TRUE(quality.isClosed);
    EXPECT_NEAR(*quality.volume, 16.0, 1e-12);
    EXPECT_EQ(repaired.NumberOfVertices(), 16);
    EXPECT_EQ(report.addedVertices, height > 0.0 ? 1 : 2);
  }
}

class SurfaceRepairOfRandomFaces : public testing::TestWithParam<int>
{};

// For any faces, the result is manifold and has the same triangles.
TEST_P(SurfaceRepairOfRandomFaces, IsManifoldAndKeepsTheTriangles)
{
  Random                          random(GetParam());
  const int                       vertices = 5 + GetParam() % 20;
  std::vector<Eigen::Vector3d>    points;
  std::vector<std::array<int, 3>> faces;
  for (int v = 0; v < vertices; ++v)
  {
    points.emplace_back(random.Signed(), random.Signed(), random.Signed());
  }
  for (int f = 0; f < 3 + GetParam() % 40; ++f)
  {
    faces.push_back({ random.Below(vertices), random.Below(vertices), random.Below(vertices) });
  }
  faces.push_back({ 0, 1, 2 });
  const shapeton::SurfaceMesh         mesh = FromLists(points, faces);
  shapeton::SurfaceRepairReport       report;
  const shapeton::SurfaceMesh         repaired = shapeton::RepairSurface(mesh, {}, &report);
  const shapeton::SurfaceConnectivity connectivity(repaired);
  EXPECT_TRUE(connectivity.IsManifold());
  EXPECT_EQ(connectivity.IsOriented(), report.nonOrientableComponents == 0);
  EXPECT_EQ(repaired.NumberOfFaces(), mesh.NumberOfFaces() - report.degenerateFaces - report.duplicateFaces);
  const shapeton::SurfaceDefects defects = shapeton::FindSurfaceDefects(repaired, connectivity);
  EXPECT_TRUE(defects.degenerateFaces.empty());
  EXPECT_TRUE(defects.duplicateFaces.empty());
  EXPECT_TRUE(defects.unreferencedVertices.empty());
  std::set<std::set<std::array<double, 3>>> wanted;
  std::set<std::set<std::array<double, 3>>> got;
  const auto                                collect = [](const shapeton::SurfaceMesh & from, auto & into) {
    for (int f = 0; f < from.NumberOfFaces(); ++f)
    {
      std::set<std::array<double, 3>> triangle;
      for (int k = 0; k < 3; ++k)
      {
        const int v = from.F(f, k);
        triangle.insert({ from.V(v, 0), from.V(v, 1), from.V(v, 2) });
      }
      if (triangle.size() == 3)
      {
        into.insert(triangle);
      }
    }
  };
  collect(mesh, wanted);
  collect(repaired, got);
  EXPECT_EQ(got, wanted);
}

INSTANTIATE_TEST_SUITE_P(Random, SurfaceRepairOfRandomFaces, testing::Range(1, 61));

TEST(SurfaceRepair, NothingButDegenerateFacesIsRefused)
{
  const shapeton::SurfaceMesh mesh = FromLists({ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } }, { { 0, 1, 2 } });
  EXPECT_THROW(shapeton::RepairSurface(mesh), shapeton::InputError);
}

TEST(SurfaceRepair, RequireManifoldNamesTheFault)
{
  const auto messageOf = [](const shapeton::SurfaceMesh & mesh) -> std::string {
    return basetest::ErrorOf([&] { shapeton::RequireManifold(mesh, "wall.vtp"); });
  };
  EXPECT_EQ(messageOf(Octahedron()), "");
  EXPECT_EQ(messageOf(MoebiusStrip(9, 2)).find("wall.vtp: "), 0u);
  EXPECT_NE(messageOf(MoebiusStrip(9, 2)).find("opposite orientation"), std::string::npos);
}
} // namespace
