#include "shapetonColonFlattening.h"

#include "shapetonColonTube.h"
#include "shapetonJson.h"
#include "shapetonProgressTests.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
Tube(int handles = 0)
{
  return MakeColonTube({ 6000, handles, 1, 750.0 }).mesh;
}

/** A straight line of `number` points with 10 mm spacing. */
shapeton::CurveSet
Line(int points, bool isDownwards = false)
{
  shapeton::CurveSet line;
  line.V = shapeton::VertexMatrix::Zero(points, 3);
  line.curves.emplace_back();
  for (int i = 0; i < points; ++i)
  {
    line.V(i, 2) = 10.0 * (isDownwards ? points - 1 - i : i);
    line.curves[0].push_back(i);
  }
  return line;
}
} // namespace

TEST(ColonFlattening, ASeamChangesNothing)
{
  shapeton::ColonFlatteningSettings options;
  options.metric = shapeton::FlatMetric::Euclidean;
  const shapeton::SurfaceMesh     tube = Tube();
  const shapeton::ColonFlattening whole = shapeton::FlattenColon(tube, "it", options);
  const auto                      isBeyond = [&](int f) { return tube.V(tube.F(f, 0), 2) > 300.0; };
  const shapeton::ColonFlattening seam = shapeton::FlattenColon(WithSeam(tube, isBeyond), "it", options);
  EXPECT_EQ(whole.map.modulusU, seam.map.modulusU);
  EXPECT_EQ(whole.map.modulusV, seam.map.modulusV);
  EXPECT_EQ(whole.map.flat.V, seam.map.flat.V);
}

TEST(ColonFlattening, StatesItsMetricAndTime)
{
  shapeton::ColonFlatteningSettings options;
  const shapeton::ColonFlattening   automatic = shapeton::FlattenColon(Tube(), "it", options);
  EXPECT_GT(automatic.time, 0.0);
  EXPECT_GT(automatic.narrowestRadius, 10.0);
  options.time = 33.0;
  EXPECT_EQ(33.0, shapeton::FlattenColon(Tube(), "it", options).time);
  options.metric = shapeton::FlatMetric::TruncatedHeatDiffusion;
  options.eigenpairs = 20;
  const shapeton::ColonFlattening truncated = shapeton::FlattenColon(Tube(), "it", options);
  EXPECT_EQ(20, truncated.eigenpairs);
  // These few eigenpairs do not resolve the angle around the tube (see the README).
  EXPECT_GT(std::abs(truncated.map.modulusU / automatic.map.modulusU - 1.0), 0.3);
  options.metric = shapeton::FlatMetric::Euclidean;
  EXPECT_EQ(0.0, shapeton::FlattenColon(Tube(), "it", options).time);
}

TEST(ColonFlattening, RemovesHandlesOnRequest)
{
  shapeton::ColonFlatteningSettings options;
  options.time = 40.0;
  const shapeton::ColonFlattening with = shapeton::FlattenColon(Tube(5), "it", options);
  EXPECT_EQ(5, with.genusBefore);
  EXPECT_EQ(5, with.genusAfter);
  EXPECT_EQ(5, with.handles.genus);
  EXPECT_GT(with.distortion.flips, 0);
  EXPECT_EQ(0, with.flipsAwayFromHandles);
  const shapeton::ColonFlattening plain = shapeton::FlattenColon(Tube(), "it", options);
  for (const auto topology : { shapeton::SurfaceTopology::Denoised, shapeton::SurfaceTopology::Published })
  {
    options.topology = topology;
    const shapeton::ColonFlattening without = shapeton::FlattenColon(Tube(5), "it", options);
    EXPECT_EQ(5, without.genusBefore);
    EXPECT_EQ(0, without.genusAfter);
    EXPECT_EQ(5U, without.handles.handles.size());
    EXPECT_EQ(0, without.distortion.flips);
    EXPECT_EQ(40.0, without.time);
    EXPECT_NEAR(1.0, without.map.modulusU / plain.map.modulusU, 0.005);
    EXPECT_NEAR(1.0, without.map.modulusV / plain.map.modulusV, 0.005);
    const shapeton::Json json = shapeton::ColonFlatteningToJson(without);
    EXPECT_EQ(5U, json["handles"].size());
    EXPECT_EQ(0, json["genusAfter"]);
    EXPECT_TRUE(json["eigenpairs"].is_null());
    EXPECT_NEAR(without.map.modulusU, json["modulusU"].get<double>(), 1e-9);
    // On the final map the handle is at the nearest vertex.
    for (const shapeton::SurfaceHandle & handle : without.handles.handles)
    {
      EXPECT_GT(handle.flatPlace.x(), 0.0);
      EXPECT_LT(handle.flatPlace.x(), without.map.length);
    }
  }
}

TEST(ColonFlattening, PublishedRouteIsWarnedOf)
{
  shapeton::ColonFlatteningSettings options;
  options.metric = shapeton::FlatMetric::Euclidean;
  options.method = shapeton::TubeConjugate::Published;
  const shapeton::ColonFlattening result = shapeton::FlattenColon(Tube(5), "it", options);
  EXPECT_GT(result.distortion.flips, 50);
  const shapeton::ColonFlattening good = shapeton::FlattenColon(Tube(5), "it", {});
  EXPECT_LT(good.distortion.flips, 50);
}

TEST(ColonFlattening, CenterlineTellsTheRectum)
{
  shapeton::ColonFlatteningSettings options;
  options.centerline = Line(9, true);
  const shapeton::SurfaceMesh     cylinder = Cylinder(30, 30, 20.0, 80.0);
  const shapeton::ColonFlattening result = shapeton::FlattenColon(cylinder, "it", options);
  EXPECT_EQ("centerline", result.rectumFrom);
  EXPECT_NEAR(1.0, result.map.u[0], 1e-12); // at height 0, the end of the line
  options.centerline = Line(9);
  EXPECT_NEAR(0.0, shapeton::FlattenColon(cylinder, "it", options).map.u[0], 1e-12);
  EXPECT_EQ("firstLoop", shapeton::FlattenColon(cylinder, "it", {}).rectumFrom);
}

TEST(ColonFlattening, BridgedFacesAreNotTheNarrowestPlace)
{
  // A cylinder with a waist of radius 3.
  shapeton::SurfaceMesh mesh = Grid(30, 60, Wrap::Around, [](double s, double t) {
    const double r = std::abs(t - 0.5) < 0.1 ? 3.0 : 20.0;
    return Eigen::Vector3d(r * std::cos(2 * Pi * s), r * std::sin(2 * Pi * s), 100.0 * t);
  });
  EXPECT_NEAR(3.0, shapeton::FlattenColon(mesh, "it", {}).narrowestRadius, 0.1);
  shapeton::SurfaceArray bridged{ "bridged", shapeton::SurfaceArray::ValueMatrix::Zero(mesh.NumberOfFaces(), 1), true };
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const double z = mesh.V(mesh.F(f, 0), 2);
    bridged.values(f, 0) = z > 37.0 && z < 63.0 ? 1.0 : 0.0;
  }
  mesh.cellArrays.push_back(bridged);
  EXPECT_NEAR(20.0, shapeton::FlattenColon(mesh, "it", {}).narrowestRadius, 0.3);
}

TEST(ColonFlattening, FacesWithoutAreaAreTakenForThinOnes)
{
  shapeton::SurfaceMesh mesh = Cylinder(30, 30, 20.0, 80.0);
  // A vertex is at the midpoint of an edge, so one of its faces has zero area.
  mesh.V.row(mesh.F(400, 1)) = 0.5 * (mesh.V.row(mesh.F(400, 0)) + mesh.V.row(mesh.F(400, 2)));
  const shapeton::ColonFlattening result = shapeton::FlattenColon(mesh, "it", {});
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string & warning) {
    return warning.find("face 400, were treated as thin faces") != std::string::npos;
  }));
  EXPECT_TRUE(shapeton::FlatCoordinates(result.map.flat, "it").allFinite());
}

TEST(ColonFlattening, RefusesTimesThatAreNone)
{
  shapeton::ColonFlatteningSettings options;
  for (const double time : { -1.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    options.time = time;
    EXPECT_THROW(shapeton::FlattenColon(Tube(), "it", options), shapeton::ParameterError);
  }
}

TEST(ColonFlattening, OnlyCurveRefusesOthers)
{
  shapeton::CurveSet line = Line(3);
  EXPECT_EQ(3U, shapeton::OnlyCurve(line, "it").size());
  line.curves.push_back({ 0, 2 });
  EXPECT_THROW(shapeton::OnlyCurve(line, "it"), shapeton::InputError);
  line.curves = { { 1 } };
  EXPECT_THROW(shapeton::OnlyCurve(line, "it"), shapeton::InputError);
}

TEST(ColonFlattening, IsAbortedByProgressWhateverTheMetric)
{
  const shapeton::SurfaceMesh tube = Tube(2);
  for (const auto metric : { shapeton::FlatMetric::HeatDiffusion,
                             shapeton::FlatMetric::TruncatedHeatDiffusion,
                             shapeton::FlatMetric::Euclidean })
  {
    const auto work = [&](const shapeton::Progress & progress) {
      shapeton::ColonFlatteningSettings options;
      options.metric = metric;
      options.topology = shapeton::SurfaceTopology::Published;
      options.progress = progress;
      FlattenColon(tube, "it", options);
    };
    shapeton::test::ExpectProgress(work, 20);
  }
}
