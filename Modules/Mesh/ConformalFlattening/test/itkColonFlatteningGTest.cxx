#include "itkColonFlattening.h"

#include "itkColonTube.h"
#include "itkHeatDiffusionMetric.h"
#include "itkTestSurfaces.h"
#include "itkToolError.h"

#include <gtest/gtest.h>

namespace
{
using namespace testsurfaces;

itk::SurfaceMesh
Tube(int handles = 0)
{
  ColonTubeOptions options;
  options.faces = 6000;
  options.length = 750.0;
  options.handles = handles;
  return MakeColonTube(options).mesh;
}

/** A straight line in `axis` direction with a radius at each of its points, 10 mm apart. */
itk::CurveSet
Line(const std::vector<double> & radii, bool isDownwards = false)
{
  itk::CurveSet line;
  const auto    n = static_cast<Eigen::Index>(radii.size());
  line.V = itk::VertexMatrix::Zero(n, 3);
  itk::SurfaceArray radius{ "radius", itk::SurfaceArray::ValueMatrix(n, 1), false };
  line.curves.emplace_back();
  for (Eigen::Index i = 0; i < n; ++i)
  {
    line.V(i, 2) = 10.0 * static_cast<double>(isDownwards ? n - 1 - i : i);
    radius.values(i, 0) = radii[i];
    line.curves[0].push_back(static_cast<int>(i));
  }
  line.pointArrays.push_back(radius);
  return line;
}
} // namespace

TEST(ColonFlattening, StatesItsMetricAndTime)
{
  itk::ColonFlatteningOptions options;
  const itk::ColonFlattening  automatic = itk::FlattenColon(Tube(), "it", options);
  EXPECT_GT(automatic.time, 0.0);
  EXPECT_EQ("surface", automatic.narrowestRadiusFrom);
  options.time = 33.0;
  EXPECT_EQ(33.0, itk::FlattenColon(Tube(), "it", options).time);
  options.metric = itk::FlatMetric::TruncatedHeatDiffusion;
  options.eigenpairs = 20;
  const itk::ColonFlattening truncated = itk::FlattenColon(Tube(), "it", options);
  EXPECT_EQ(20, truncated.eigenpairs);
  // So few do not tell the angle around the tube (see the README).
  EXPECT_GT(std::abs(truncated.map.modulusU / automatic.map.modulusU - 1.0), 0.3);
  options.metric = itk::FlatMetric::Euclidean;
  EXPECT_EQ(0.0, itk::FlattenColon(Tube(), "it", options).time);
}

TEST(ColonFlattening, RemovesHandlesOnRequest)
{
  itk::ColonFlatteningOptions options;
  options.time = 40.0;
  const itk::ColonFlattening with = itk::FlattenColon(Tube(5), "it", options);
  EXPECT_EQ(5, with.genusBefore);
  EXPECT_EQ(5, with.genusAfter);
  EXPECT_EQ(5, with.handles.genus);
  EXPECT_GT(with.distortion.flips, 0);
  EXPECT_EQ(0, with.flipsAwayFromHandles);
  options.removeHandles = true;
  const itk::ColonFlattening without = itk::FlattenColon(Tube(5), "it", options);
  EXPECT_EQ(5, without.genusBefore);
  EXPECT_EQ(0, without.genusAfter);
  EXPECT_EQ(5U, without.handles.handles.size());
  EXPECT_EQ(0, without.distortion.flips);
  EXPECT_EQ(40.0, without.time);
  const itk::Json json = itk::ColonFlatteningToJson(without);
  EXPECT_EQ(5U, json["handles"].size());
  EXPECT_EQ(0, json["genusAfter"]);
  EXPECT_TRUE(json["eigenpairs"].is_null());
  EXPECT_EQ(without.map.modulusU, json["modulusU"]);
}

TEST(ColonFlattening, PublishedRouteIsWarnedOf)
{
  itk::ColonFlatteningOptions options;
  options.metric = itk::FlatMetric::Euclidean;
  options.tube.conjugate = itk::TubeConjugate::Published;
  const itk::ColonFlattening result = itk::FlattenColon(Tube(5), "it", options);
  EXPECT_GT(result.distortion.flips, 50);
  const itk::ColonFlattening good = itk::FlattenColon(Tube(5), "it", {});
  EXPECT_LT(good.distortion.flips, 50);
}

TEST(ColonFlattening, CentrelineTellsRadiusAndRectum)
{
  itk::ColonFlatteningOptions options;
  options.centreline = Line({ 1, 9, 9, 12, 7, 8, 9, 2, 1 }, true);
  const itk::SurfaceMesh     cylinder = Cylinder(30, 30, 20.0, 80.0);
  const itk::ColonFlattening result = itk::FlattenColon(cylinder, "it", options);
  EXPECT_EQ("centreline", result.narrowestRadiusFrom);
  EXPECT_EQ(7.0, result.narrowestRadius);
  EXPECT_EQ("centreline", result.rectumFrom);
  EXPECT_NEAR(1.0, result.map.u[0], 1e-12); // at the height 0, where the line ends
  options.centreline = Line({ 1, 9, 9, 12, 7, 8, 9, 2, 1 });
  EXPECT_NEAR(0.0, itk::FlattenColon(cylinder, "it", options).map.u[0], 1e-12);
  EXPECT_EQ("firstLoop", itk::FlattenColon(cylinder, "it", {}).rectumFrom);
}

TEST(ColonFlattening, NarrowestRadiusLeavesGapsAndEndsOut)
{
  itk::CurveSet line = Line({ 1, 1, 9, 3, 7, 8, 9, 2, 1 });
  EXPECT_EQ(3.0, itk::NarrowestRadiusOfCentreline(line));
  itk::SurfaceArray gap{ "gap", itk::SurfaceArray::ValueMatrix::Zero(9, 1), true };
  gap.values(3, 0) = 1.0;
  line.pointArrays.push_back(gap);
  EXPECT_EQ(7.0, itk::NarrowestRadiusOfCentreline(line));
  EXPECT_THROW(itk::NarrowestRadiusOfCentreline(Line({ 5, 5, 5 })), itk::InputError);
  line.pointArrays.clear();
  EXPECT_THROW(itk::NarrowestRadiusOfCentreline(line), itk::InputError);
}

TEST(ColonFlattening, FacesWithoutAreaAreTakenForThinOnes)
{
  itk::SurfaceMesh mesh = Cylinder(30, 30, 20.0, 80.0);
  // A vertex on the middle of an edge: one of the faces at it has no area.
  mesh.V.row(mesh.F(400, 1)) = 0.5 * (mesh.V.row(mesh.F(400, 0)) + mesh.V.row(mesh.F(400, 2)));
  const itk::ColonFlattening result = itk::FlattenColon(mesh, "it", {});
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string & warning) {
    return warning.find("face 400, were taken for thin ones") != std::string::npos;
  }));
  EXPECT_TRUE(itk::FlatCoordinates(result.map.flat, "it").allFinite());
}

TEST(ColonFlattening, OnlyCurveRefusesOthers)
{
  itk::CurveSet line = Line({ 1, 2, 3 });
  EXPECT_EQ(3U, itk::OnlyCurve(line, "it").size());
  line.curves.push_back({ 0, 2 });
  EXPECT_THROW(itk::OnlyCurve(line, "it"), itk::InputError);
  line.curves = { { 1 } };
  EXPECT_THROW(itk::OnlyCurve(line, "it"), itk::InputError);
}
