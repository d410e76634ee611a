#include "shapetonSurfaceQuality.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include "gtest/gtest.h"
#include "shapetonJson.h"

#include <limits>
#include <numeric>

namespace
{
using namespace testsurfaces;

TEST(SurfaceQuality, AreaAndVolumeOfAPolyhedron)
{
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(Octahedron());
  EXPECT_NEAR(quality.area, 4.0 * std::sqrt(3.0), 1e-12);
  ASSERT_TRUE(quality.volume.has_value());
  EXPECT_NEAR(*quality.volume, 4.0 / 3.0, 1e-12);
  EXPECT_NEAR(quality.smallestAngle.minimum, 60.0, 1e-9);
  EXPECT_NEAR(quality.largestAngle.maximum, 60.0, 1e-9);
  EXPECT_NEAR(quality.aspectRatio.maximum, 1.0, 1e-12);
  EXPECT_NEAR(quality.edgeLength.median, std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(quality.defects.AreNone());
}

TEST(SurfaceQuality, VolumeIsNegativeInsideOutAndIndependentOfThePlace)
{
  shapeton::SurfaceMesh mesh = Icosphere(2, 5.0);
  const double          volume = shapeton::EnclosedVolume(mesh.V, mesh.F);
  mesh.V.rowwise() += Eigen::RowVector3d(1000.0, -2000.0, 500.0);
  EXPECT_NEAR(shapeton::EnclosedVolume(mesh.V, mesh.F), volume, 1e-9 * volume);
  mesh.F.col(0).swap(mesh.F.col(1));
  EXPECT_NEAR(*shapeton::InspectSurface(mesh).volume, -volume, 1e-9 * volume);
}

TEST(SurfaceQuality, NormalsOfVertices)
{
  shapeton::SurfaceMesh mesh = Octahedron();
  EXPECT_LT((shapeton::VertexNormals(mesh.V, mesh.F) - mesh.V).cwiseAbs().maxCoeff(), 1e-12); // outward, of unit length
  mesh.V.setZero();
  EXPECT_EQ(shapeton::VertexNormals(mesh.V, mesh.F).cwiseAbs().maxCoeff(), 0.0); // no area: not NaN
}

TEST(SurfaceQuality, LoopsOfACylinderHaveTheLengthOfItsPolygon)
{
  const int                      around = 12;
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(Cylinder(around, 3, 7.0, 5.0));
  ASSERT_EQ(quality.boundaryLoopLengths.size(), 2u);
  for (const double length : quality.boundaryLoopLengths)
  {
    EXPECT_NEAR(length, around * 2.0 * 7.0 * std::sin(Pi / around), 1e-10);
  }
  EXPECT_FALSE(quality.volume.has_value());
  EXPECT_EQ(quality.genus, 0);
}

TEST(SurfaceQuality, StatisticsInterpolate)
{
  std::vector<double> values(101);
  std::iota(values.rbegin(), values.rend(), 0.0);
  const shapeton::SurfaceStatistics statistics = shapeton::StatisticsOf(values);
  EXPECT_EQ(statistics.minimum, 0.0);
  EXPECT_EQ(statistics.percentile1, 1.0);
  EXPECT_EQ(statistics.median, 50.0);
  EXPECT_EQ(statistics.percentile99, 99.0);
  EXPECT_EQ(statistics.maximum, 100.0);
  EXPECT_EQ(shapeton::StatisticsOf({ 1.0, 2.0 }).median, 1.5);
}

TEST(SurfaceQuality, AnglesAndAspectOfARightTriangle)
{
  const shapeton::SurfaceQuality quality =
    shapeton::InspectSurface(FromLists({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, { { 0, 1, 2 } }));
  EXPECT_NEAR(quality.smallestAngle.minimum, std::atan(0.75) * 180.0 / Pi, 1e-12);
  EXPECT_NEAR(quality.largestAngle.minimum, 90.0, 1e-12);
  EXPECT_NEAR(quality.aspectRatio.minimum, 5.0 / (2.0 * std::sqrt(3.0)), 1e-12); // inscribed radius 1
}

TEST(SurfaceQuality, EveryDefectIsCounted)
{
  // 0 1 2 | its flipped duplicate | a degenerate face | a zero-area face | vertex 6 coincides with 0, 7 is unreferenced
  const shapeton::SurfaceMesh mesh = FromLists(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 0, 0 }, { 6, 0, 0 }, { 7, 0, 0 }, { 0, 0, 0 }, { 9, 9, 9 } },
    { { 0, 1, 2 }, { 1, 0, 2 }, { 3, 3, 4 }, { 3, 4, 5 }, { 6, 1, 5 } });
  const shapeton::SurfaceDefects defects = shapeton::FindSurfaceDefects(mesh, shapeton::SurfaceConnectivity(mesh));
  EXPECT_EQ(defects.duplicateFaces, std::vector<int>({ 1 }));
  EXPECT_EQ(defects.degenerateFaces, std::vector<int>({ 2 }));
  EXPECT_EQ(defects.zeroAreaFaces, std::vector<int>({ 3, 4 }));
  EXPECT_EQ(defects.coincidentVertices, std::vector<int>({ 6 }));
  EXPECT_EQ(defects.unreferencedVertices, std::vector<int>({ 7 }));
  EXPECT_EQ(defects.nonManifoldVertices, std::vector<int>({ 1, 5 }));
  EXPECT_TRUE(defects.nonManifoldEdges.empty());
  EXPECT_FALSE(defects.AreNone());
}

TEST(SurfaceQuality, InconsistentEdgesAreThoseAroundATurnedFace)
{
  shapeton::SurfaceMesh mesh = Octahedron();
  std::swap(mesh.F(0, 0), mesh.F(0, 1));
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(mesh);
  EXPECT_EQ(quality.defects.inconsistentEdges.size(), 3u);
  EXPECT_FALSE(quality.isOriented);
  EXPECT_FALSE(quality.volume.has_value());
  EXPECT_EQ(quality.genus, 0); // the flip can be reverted
}

TEST(SurfaceQuality, GenusIsTheSumOverComponents)
{
  const shapeton::SurfaceQuality quality =
    shapeton::InspectSurface(Together({ Torus(8, 6, 5, 1), Icosphere(1, 1), Torus(8, 6, 5, 1) }));
  EXPECT_EQ(quality.genus, 2);
  EXPECT_EQ(quality.components.size(), 3u);
  EXPECT_FALSE(shapeton::InspectSurface(Together({ Icosphere(1, 1), MoebiusStrip(9, 2) })).genus.has_value());
}

TEST(SurfaceQuality, UnsoundSurfacesAreRefused)
{
  shapeton::SurfaceMesh mesh = Octahedron();
  mesh.V(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(shapeton::InspectSurface(mesh), shapeton::InputError);
  mesh = Octahedron();
  mesh.F(2, 2) = 6;
  EXPECT_THROW(shapeton::InspectSurface(mesh), shapeton::InputError);
  mesh = Octahedron();
  mesh.F.resize(0, 3);
  EXPECT_THROW(shapeton::InspectSurface(mesh), shapeton::InputError);
  mesh = Octahedron();
  mesh.pointArrays.push_back({ "a", shapeton::SurfaceArray::ValueMatrix::Zero(5, 1), false });
  EXPECT_THROW(shapeton::InspectSurface(mesh), shapeton::InputError);
}

// A tube split into coincident halves, and two tetrahedra that share an edge.
TEST(SurfaceQuality, NumbersAfterRepairAreStatedToo)
{
  shapeton::SurfaceMesh two = Together({ Cylinder(6, 5, 3, 9), Cylinder(6, 5, 3, 9) });
  two.V.bottomRows(two.NumberOfVertices() / 2).col(2).array() += 9.0;
  const shapeton::SurfaceQuality split = shapeton::InspectSurface(two);
  EXPECT_EQ(split.components.size(), 2u);
  EXPECT_EQ(split.boundaryLoopLengths.size(), 4u);
  ASSERT_EQ(split.componentsAfterRepair.size(), 1u);
  EXPECT_EQ(split.componentsAfterRepair[0].boundaryLoops, 2);
  EXPECT_EQ(shapeton::SurfaceQualityToJson(split).at("componentsAfterRepair").size(), 1u);

  const shapeton::SurfaceQuality edge = shapeton::InspectSurface(FromLists(
    { { 0, 0, 0 }, { 0, 0, 9 }, { 5, 1, 4 }, { 5, -1, 4 }, { -5, 1, 4 }, { -5, -1, 4 } },
    { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 }, { 0, 4, 1 }, { 0, 1, 5 }, { 0, 5, 4 }, { 1, 4, 5 } }));
  ASSERT_EQ(edge.nonManifoldEdges.size(), 1u);
  EXPECT_EQ(edge.nonManifoldEdges[0][1], Eigen::Vector3d(0, 0, 9));
  EXPECT_EQ(edge.componentsAfterRepair.size(), 2u);
  const std::string text = shapeton::FormatSurfaceQuality(edge);
  EXPECT_NE(text.find("Not manifold    edge from (0, 0, 0) to (0, 0, 9) mm"), std::string::npos) << text;
  EXPECT_NE(text.find("After repair    2"), std::string::npos) << text;
}

TEST(SurfaceQuality, JsonAndTextSayTheSame)
{
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(Cylinder(6, 2, 3.0, 4.0));
  const shapeton::Json           json = shapeton::SurfaceQualityToJson(quality);
  EXPECT_EQ(json.at("faces"), 24);
  EXPECT_EQ(json.at("genus"), 0);
  EXPECT_TRUE(json.at("volume").is_null());
  EXPECT_EQ(json.at("boundaryLoops").size(), 2u);
  EXPECT_EQ(json.at("boundaryLoops").at(0).at("length"), 18.0);
  EXPECT_EQ(json.at("defects").at("nonManifoldEdges"), 0);
  const std::string text = shapeton::FormatSurfaceQuality(quality);
  EXPECT_NE(text.find("1: 6 vertices, 18 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("Defects         none"), std::string::npos) << text;
}
} // namespace
