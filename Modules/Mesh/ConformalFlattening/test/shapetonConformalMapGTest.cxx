#include "shapetonConformalMap.h"
#include "shapetonProgressTests.h"

#include "shapetonJson.h"
#include "shapetonPlanarDomains.h"
#include "shapetonRoughTube.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

ConformalMap
MapTo(ConformalDomain domain, const SurfaceMesh & mesh, int outer = 0, int inner = 0)
{
  ConformalMapSettings options;
  options.domain = domain;
  options.outerBoundary = outer;
  options.innerBoundary = inner;
  return MapConformally(mesh, options, "the test");
}

/** Returns the error message of MapConformally() for a rejected surface. */
std::string
Refusal(const SurfaceMesh & mesh, const ConformalMapSettings & options)
{
  return basetest::ErrorOf([&] { MapConformally(mesh, options, "the test"); });
}

/** A hemisphere with three holes around vertices. */
SurfaceMesh
Face()
{
  const SurfaceMesh sphere = Icosphere(4, 50.0);
  return FacesWhere(sphere, [&](int face) {
    const Eigen::RowVector3d center =
      (sphere.V.row(sphere.F(face, 0)) + sphere.V.row(sphere.F(face, 1)) + sphere.V.row(sphere.F(face, 2))) / 3.0;
    const auto isHole = [&](double x, double y, double size) {
      return std::hypot(center.x() - x, center.y() - y) < size;
    };
    return center.z() > 0.0 && !isHole(-18, 15, 7) && !isHole(18, 15, 7) && !isHole(0, -20, 9);
  });
}

TEST(ConformalMap, OfAFaceToAllSlitMaps)
{
  const SurfaceMesh  mesh = Face();
  const ConformalMap map = MapTo(ConformalDomain::Slit, mesh);
  ASSERT_EQ(map.loops.size(), 4u);
  ASSERT_EQ(map.slitMaps.size(), 3u);
  EXPECT_EQ(map.outer, 0);
  EXPECT_EQ(map.inner, 1);
  EXPECT_EQ(map.flips, 0);
  EXPECT_FALSE(map.distortion.isClockwise);
  EXPECT_LT(map.dilatation.median, 1.05);
  EXPECT_EQ(map.flat.NumberOfVertices(), mesh.NumberOfVertices());
  EXPECT_NEAR(map.distortion.areaScale.size(), mesh.NumberOfFaces(), 0);
  for (const char * name : { "slitMap2", "slitMap3", "slitMap4" })
  {
    ASSERT_NE(FindSurfaceArray(map.flat.pointArrays, name), nullptr) << name;
  }
  const auto uv = FlatCoordinates(map.flat, "");
  for (const BoundaryLoop & loop : map.loops)
  {
    for (const int vertex : loop.vertices)
    {
      EXPECT_NEAR(uv.row(vertex).norm(), uv.row(loop.vertices[0]).norm(), 1e-11);
    }
  }
}

TEST(ConformalMap, OfACylinderToAnnulusAndStrip)
{
  const SurfaceMesh  mesh = Cylinder(48, 30, 10.0, 25.0);
  const double       modulus = 2.0 * 48 * 10.0 * std::sin(Pi / 48) / 25.0; // the developed prism is planar
  const ConformalMap annulus = MapTo(ConformalDomain::Annulus, mesh);
  EXPECT_NEAR(annulus.modulusU, modulus, 1e-10);
  EXPECT_NEAR(annulus.modulusV, modulus, 1e-10);
  EXPECT_EQ(annulus.flips, 0);
  const ConformalMap strip = MapTo(ConformalDomain::Rectangle, mesh);
  EXPECT_NEAR(FlatLength(strip.flat, ""), 25.0, 1e-9);
  EXPECT_NEAR(FlatCircumference(strip.flat, ""), 25.0 * modulus, 1e-9);
  EXPECT_NEAR(strip.dilatation.p99, 1.0, 1e-6);
  EXPECT_EQ(strip.flips, 0);
  EXPECT_FALSE(strip.distortion.isClockwise);
  EXPECT_EQ(strip.flat.NumberOfVertices(), mesh.NumberOfVertices() + 31);
  const auto uv = FlatCoordinates(strip.flat, "");
  EXPECT_NEAR(uv.col(0).minCoeff(), 0.0, 1e-12);
  EXPECT_NEAR(uv.col(0).maxCoeff(), 25.0, 1e-9);
  EXPECT_NEAR(strip.distortion.areaScale.mean(), 1.0, 1e-9);
}

TEST(ConformalMap, OfAnAnnulusHasItsArea)
{
  const SurfaceMesh  mesh = Moebius(PolarGrid().Mesh(), 0.3);
  const ConformalMap map = MapTo(ConformalDomain::Annulus, mesh);
  const auto         uv = FlatCoordinates(map.flat, "");
  SurfaceMesh        plane = map.flat;
  plane.V.leftCols(2) = uv;
  plane.V.col(2).setZero();
  EXPECT_NEAR(SurfaceArea(plane.V, plane.F) / SurfaceArea(mesh.V, mesh.F), 1.0, 0.01);
}

TEST(ConformalMap, TheInnerAndTheOuterBoundaryMayBeSwapped)
{
  const SurfaceMesh  mesh = Moebius(PolarGrid().Mesh(), 0.3);
  const ConformalMap map = MapTo(ConformalDomain::Annulus, mesh);
  const ConformalMap swapped = MapTo(ConformalDomain::Annulus, mesh, 2, 1);
  EXPECT_EQ(swapped.outer, 1);
  EXPECT_EQ(swapped.inner, 0);
  EXPECT_NEAR(swapped.modulusU, map.modulusU, 1e-10);
  EXPECT_EQ(swapped.flips, 0);
  EXPECT_FALSE(swapped.distortion.isClockwise);
}

TEST(ConformalMap, OfASphericalPatchToARectangle)
{
  // Longitude and Mercator's latitude are conformal: a patch between meridians and parallels is a rectangle.
  const double         lambda = 1.0, phi = 0.7;
  const SurfaceMesh    mesh = Grid(60, 60, Wrap::None, [&](double s, double t) {
    const double l = lambda * s, p = phi * t;
    return Eigen::Vector3d(30 * std::cos(p) * std::cos(l), 30 * std::cos(p) * std::sin(l), 30 * std::sin(p));
  });
  ConformalMapSettings options;
  options.domain = ConformalDomain::Rectangle;
  options.corners = { 0, 60, 61 * 61 - 1, 60 * 61 };
  const ConformalMap map = MapConformally(mesh, options, "");
  const double       modulus = std::asinh(std::tan(phi)) / lambda;
  EXPECT_NEAR(map.modulusU, modulus, 1e-3 * modulus);
  EXPECT_NEAR(map.modulusV, modulus, 1e-3 * modulus);
  EXPECT_EQ(map.flips, 0);
  EXPECT_LT(map.dilatation.p99, 1.02);
  EXPECT_NEAR(map.distortion.areaScale.mean(), 1.0, 0.2);
}

TEST(ConformalMap, OfASurfaceWithAHandleSaysSo)
{
  const SurfaceMesh  torus = Torus(40, 30, 30.0, 12.0);
  const ConformalMap map = MapTo(ConformalDomain::Rectangle, FacesWhere(torus, [](int face) { return face >= 8; }));
  EXPECT_EQ(map.genus, 1);
  EXPECT_GT(map.ModulusGap(), 0.05); // the handle is most of the surface
  ASSERT_FALSE(map.warnings.empty());
  EXPECT_NE(map.warnings[0].find("1 handle"), std::string::npos);
}

TEST(ConformalMap, RefusesWithTheReason)
{
  ConformalMapSettings slit;
  ConformalMapSettings rectangle;
  rectangle.domain = ConformalDomain::Rectangle;
  EXPECT_NE(Refusal(Icosphere(2, 50.0), rectangle).find("no boundary"), std::string::npos);
  EXPECT_NE(Refusal(Square(4, 50.0), slit).find("1 boundary"), std::string::npos);
  EXPECT_NE(Refusal(Together({ Square(4, 50.0), Square(3, 20.0) }), rectangle).find("component"), std::string::npos);
  const SurfaceMesh    face = Face();
  ConformalMapSettings annulus;
  annulus.domain = ConformalDomain::Annulus;
  EXPECT_NE(Refusal(face, annulus).find("slits"), std::string::npos);
  slit.innerBoundary = 1;
  EXPECT_NE(Refusal(face, slit).find("outer and the inner"), std::string::npos);
  slit.innerBoundary = 5;
  EXPECT_NE(Refusal(face, slit).find("boundary 5, chosen as the"), std::string::npos);
  rectangle.corners = { 0, 1, 2, 3 };
  EXPECT_NE(Refusal(face, rectangle).find("corners"), std::string::npos);
  rectangle.corners = { 0, 1, 2 };
  EXPECT_NE(Refusal(Square(4, 50.0), rectangle).find("4 corners"), std::string::npos);
  SurfaceMesh turned = Square(4, 50.0);
  std::swap(turned.F(5, 0), turned.F(5, 1));
  EXPECT_NE(Refusal(turned, {}).find("opposite orientations"), std::string::npos);
}

TEST(ConformalMap, StatisticsHaveTheirKeys)
{
  const Json json = ConformalMapToJson(MapTo(ConformalDomain::Slit, Face()));
  EXPECT_EQ(json["domain"], "slit");
  EXPECT_EQ(json["boundaries"].size(), 4u);
  EXPECT_EQ(json["boundaries"][0]["role"], "outer");
  EXPECT_EQ(json["boundaries"][1]["role"], "inner");
  EXPECT_EQ(json["boundaries"][2]["role"], "slit");
  EXPECT_EQ(json["slitMaps"][0]["turns"], (Json{ 1.0, -1.0, 0.0, 0.0 }));
  for (const char * key : { "faces", "genus", "modulusU", "modulusV", "modulusGap", "flips", "ears", "dilatation" })
  {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}
} // namespace

TEST(ConformalMap, NoiseDoesNotFoldMaps)
{
  int folded = 0;
  for (const std::uint64_t seed : { 1, 2, 3, 4, 5, 6 })
  {
    RoughTubeOptions rough;
    rough.seed = seed;
    rough.noise = 0.8;
    const shapeton::SurfaceMesh tube = MakeRoughTube(rough);
    // Removing the faces of two columns leaves one boundary.
    const shapeton::SurfaceMesh    sheet = FacesWhere(tube, [&](int face) { return face % (2 * rough.around) > 3; });
    shapeton::ConformalMapSettings options;
    for (const auto domain :
         { shapeton::ConformalDomain::Rectangle, shapeton::ConformalDomain::Annulus, shapeton::ConformalDomain::Slit })
    {
      options.domain = domain;
      const shapeton::ConformalMap map = shapeton::MapConformally(tube, options, "the tube");
      EXPECT_EQ(0, map.flips) << seed;
      folded += map.solves > 1;
    }
    options.domain = shapeton::ConformalDomain::Rectangle;
    const shapeton::ConformalMap map = shapeton::MapConformally(sheet, options, "the sheet");
    EXPECT_EQ(0, map.flips) << seed;
    EXPECT_GE(map.ModulusGap(), 0.0);
    folded += map.solves > 1;
  }
  EXPECT_GE(folded, 6);
}

TEST(ConformalMap, IsAbortedByProgress)
{
  const SurfaceMesh mesh = Cylinder(48, 30, 10.0, 25.0);
  for (const ConformalDomain domain : { ConformalDomain::Slit, ConformalDomain::Rectangle })
  {
    const auto work = [&](const shapeton::Progress & progress) {
      shapeton::ConformalMapSettings options;
      options.domain = domain;
      options.progress = progress;
      MapConformally(mesh, options, "it");
    };
    shapeton::test::ExpectProgress(work, 8);
  }
}
