#include "shapetonSurfaceRicciFlow.h"

#include "shapetonPlainNewton.h"
#include "shapetonPlanarDomains.h"
#include "shapetonGenusSurfaces.h"
#include "shapetonTestErrors.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

using namespace shapeton;
using namespace testsurfaces;

namespace
{
SurfaceRicciFlowSettings
Published()
{
  SurfaceRicciFlowSettings options;
  options.scheme = RicciScheme::InversiveDistance;
  return options;
}

void
ExpectExactCurvature(const SurfaceRicciFlow & flow)
{
  EXPECT_LE(flow.residual, 1e-10);
  EXPECT_LE((flow.curvatures - flow.targetCurvatures).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LE(flow.steps, 20);
}

/** A wavy tube of nearly equilateral faces: rows are shifted by half an edge. */
SurfaceMesh
WavyTube(int around, int along, Wrap wrap)
{
  const double row = std::sqrt(0.75) / around; // height of a row over the circumference
  return Grid(around, along, wrap, [=](double s, double t) {
    const double j = t * along;
    const double angle = 2 * Pi * (s - 0.5 * j / around);
    const double r = 1.0 + 0.1 * std::cos(2 * Pi * t) + 0.1 * std::cos(2 * angle);
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 2 * Pi * row * j);
  });
}

/** Largest relative difference of two vectors up to a common scale. */
double
Deviation(const Eigen::VectorXd & a, const Eigen::VectorXd & b)
{
  const Eigen::ArrayXd quotient = a.array() / b.array();
  return (quotient / quotient.mean() - 1.0).abs().maxCoeff();
}

/** Angle sums of a flat surface with straight boundaries. */
Eigen::VectorXd
FlatAngleSums(const SurfaceMesh & mesh)
{
  const SurfaceConnectivity connectivity(mesh);
  Eigen::VectorXd           sums(mesh.NumberOfVertices());
  for (int v = 0; v < sums.size(); ++v)
  {
    sums[v] = connectivity.IsBoundaryVertex(v) ? Pi : 2 * Pi;
  }
  return sums;
}
} // namespace

TEST(SurfaceRicciFlow, ACylinderIsFlatAlready)
{
  const SurfaceMesh      mesh = Cylinder(24, 20, 1.0, 3.0);
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the cylinder");
  const double           circumference = 48.0 * std::sin(Pi / 24.0);
  EXPECT_EQ(flow.steps, 0);
  EXPECT_NEAR(flow.modulus, circumference / 3.0, 1e-12);
  EXPECT_NEAR(FlatCircumference(flow.flat, "the map"), circumference, 1e-12);
  EXPECT_NEAR(FlatLength(flow.flat, "the map"), 3.0, 1e-12);
  const Eigen::MatrixX2d uv = FlatCoordinates(flow.flat, "the map");
  for (int v = 0; v < flow.flat.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(uv(v, 0), flow.flat.V(v, 2), 1e-12); // u is along the axis, from the first boundary
  }
  EXPECT_NEAR(uv.col(1).minCoeff(), 0.0, 1e-12);
  EXPECT_EQ(MeasureFlatDistortion(flow.flat.F, uv, SidesOfFaces(mesh.V, mesh.F)).flips, 0);
}

TEST(SurfaceRicciFlow, ModulusOfAnAnnulusIsOfSecondOrder)
{
  const double exact = 2 * Pi / std::log(1.0 / 0.3);
  for (const SurfaceRicciFlowSettings & options : { SurfaceRicciFlowSettings(), Published() })
  {
    std::vector<double> errors;
    for (const int around : { 24, 48, 96 })
    {
      const SurfaceRicciFlow flow = FlowSurface(PolarGrid{ around, around / 4, 0.3 }.Mesh(), options, "the annulus");
      ExpectExactCurvature(flow);
      errors.push_back(std::abs(flow.modulus - exact));
    }
    EXPECT_LT(errors[2], 2e-3);
    EXPECT_GT(errors[0] / errors[1], 3.5);
    EXPECT_GT(errors[1] / errors[2], 3.5);
  }
}

TEST(SurfaceRicciFlow, AZoneOfASphereIsAMercatorMap)
{
  const double first = 0.4, last = 2.2; // polar angles
  const auto   mercator = [](double theta) { return std::log(std::tan(0.5 * theta)); };
  const double exact = 2 * Pi / (mercator(last) - mercator(first));
  for (const SurfaceRicciFlowSettings & options : { SurfaceRicciFlowSettings(), Published() })
  {
    std::vector<double> errors, deviations;
    for (const int around : { 40, 80 })
    {
      const int              along = around * 2 / 5;
      const SurfaceMesh      mesh = Grid(around, along, Wrap::Around, [&](double s, double t) {
        const double theta = last + (first - last) * t;
        return Eigen::Vector3d(
          std::sin(theta) * std::cos(2 * Pi * s), std::sin(theta) * std::sin(2 * Pi * s), std::cos(theta));
      });
      const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the zone");
      ExpectExactCurvature(flow);
      errors.push_back(std::abs(flow.modulus - exact));
      const Eigen::MatrixX2d uv = FlatCoordinates(flow.flat, "the map");
      double                 deviation = 0.0;
      for (int v = 0; v < flow.flat.NumberOfVertices(); ++v)
      {
        const double theta = std::acos(flow.flat.V(v, 2));
        const double share = (mercator(last) - mercator(theta)) / (mercator(last) - mercator(first));
        deviation = std::max(deviation, std::abs(uv(v, 0) / FlatLength(flow.flat, "the map") - share));
      }
      deviations.push_back(deviation);
    }
    EXPECT_GT(errors[0] / errors[1], 3.5);
    EXPECT_GT(deviations[0] / deviations[1], 3.2); // tends to 4
    EXPECT_LT(deviations[1], 2e-4);
  }
}

TEST(SurfaceRicciFlow, LatticeOfATorusOfRevolutionIsOfSecondOrder)
{
  // Conformal to the rectangle of sides r and sqrt(R^2 - r^2), up to scale.
  for (const SurfaceRicciFlowSettings & options : { SurfaceRicciFlowSettings(), Published() })
  {
    std::vector<double> errors;
    for (const int across : { 16, 32 })
    {
      const SurfaceRicciFlow flow = FlowSurface(Torus(2 * across, across, 2.0, 1.0), options, "the torus");
      ExpectExactCurvature(flow);
      EXPECT_EQ(flow.geometry, RicciGeometry::Euclidean);
      EXPECT_NEAR(flow.tau.real(), 0.0, 1e-9);
      ASSERT_EQ(flow.periods.size(), 2u);
      EXPECT_NEAR(flow.periods[0].x() * flow.periods[1].y(), flow.area, 1e-9 * flow.area);
      errors.push_back(std::abs(flow.tau.imag() - std::sqrt(3.0)));
    }
    EXPECT_LT(errors[1], 0.01);
    EXPECT_GT(errors[0] / errors[1], 3.5);
  }
}

TEST(SurfaceRicciFlow, WithoutFlipsAgreesWithNewtonOfCETM)
{
  for (const SurfaceMesh & mesh : { WavyTube(24, 30, Wrap::Around), Torus(48, 24, 2.0, 1.0) })
  {
    const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the surface");
    ExpectExactCurvature(flow);
    ASSERT_EQ(flow.delaunayFlips + flow.flips, 0);
    const auto lengths = PlainNewton(mesh, FlatAngleSums(mesh));
    ASSERT_TRUE(lengths);
    EXPECT_LT(Deviation(flow.edgeLengths, *lengths), 1e-8);
    EXPECT_EQ(flow.triangles, mesh.F);
    EXPECT_EQ(flow.flippedFaces, 0);
  }
}

TEST(SurfaceRicciFlow, ScalesAreThoseOfTheLengths)
{
  const SurfaceMesh         mesh = WavyTube(24, 30, Wrap::Around);
  const SurfaceConnectivity connectivity(mesh);
  const SurfaceRicciFlow    flow = FlowSurface(mesh, {}, "the tube");
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    const auto & [a, b] = connectivity.VerticesOfEdge(e);
    const double length = (mesh.V.row(a) - mesh.V.row(b)).norm();
    EXPECT_NEAR(flow.edgeLengths[e], length * std::exp(0.5 * (flow.logScales[a] + flow.logScales[b])), 1e-12);
  }
}

TEST(SurfaceRicciFlow, MoebiusImagesHaveTheSameModulus)
{
  // A Moebius transformation scales chords by factors at their ends: the image is in the same discrete class, although
  // it needs other flips.
  const SurfaceMesh      mesh = Roughened(PolarGrid{ 48, 12, 0.3 }.Mesh(), 0.0, 1);
  const SurfaceRicciFlow before = FlowSurface(mesh, {}, "the annulus");
  const SurfaceRicciFlow after = FlowSurface(Moebius(mesh, 0.5), {}, "the image");
  ExpectExactCurvature(after);
  EXPECT_GT(after.flips + after.delaunayFlips, 0);
  EXPECT_NEAR(after.modulus, before.modulus, 1e-9);
}

TEST(SurfaceRicciFlow, ConvergesWhereNewtonWithoutFlipsStalls)
{
  const SurfaceMesh mesh = Roughened(Torus(40, 20, 2.0, 1.0), 0.2, 7);
  EXPECT_FALSE(PlainNewton(mesh, FlatAngleSums(mesh)));
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the torus");
  ExpectExactCurvature(flow);
  EXPECT_GT(flow.flips, 0);
  EXPECT_LE(DefectsOfResult(flow, mesh.NumberOfVertices()).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(flow.layoutResidual, 1e-8);
}

TEST(SurfaceRicciFlow, CornersMakeARectangleOfKnownModulus)
{
  // The half disk with four boundary vertices: z -> (z + 1 / z) / 2 maps it to the lower half plane.
  const SurfaceMesh           mesh = HalfDisk(24);
  const std::array<double, 4> angles{ 0.0, Pi / 3, 2 * Pi / 3, Pi };
  std::array<int, 4>          corners{};
  SurfaceRicciFlowSettings    options;
  options.targetCurvatures = Eigen::VectorXd::Zero(mesh.NumberOfVertices());
  for (int i = 0; i < 4; ++i)
  {
    const Eigen::RowVector3d place(std::cos(angles[i]), std::sin(angles[i]), 0.0);
    (mesh.V.rowwise() - place).rowwise().squaredNorm().minCoeff(&corners[i]);
    options.targetCurvatures[corners[i]] = 0.5 * Pi;
  }
  const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the half disk");
  ExpectExactCurvature(flow);
  const Eigen::MatrixX2d uv = FlatCoordinates(flow.flat, "the map");
  const double           width = (uv.row(corners[2]) - uv.row(corners[1])).norm();
  const double           height = (uv.row(corners[1]) - uv.row(corners[0])).norm();
  EXPECT_NEAR((uv.row(corners[3]) - uv.row(corners[2])).norm(), height, 1e-3 * height);
  // The images of the corners are 1, 1/2, -1/2, -1.
  const double lambda = (1.0 - 0.5) / (1.0 + 0.5) * (1.0 - 0.5) / (1.0 + 0.5);
  EXPECT_NEAR(width / height, ModulusOfCrossRatio(lambda), 1e-3);
}

TEST(SurfaceRicciFlow, ASquareKeepsItsShapeWithItsCorners)
{
  const int                cells = 12;
  const SurfaceMesh        mesh = Square(cells, 2.0);
  SurfaceRicciFlowSettings options;
  options.targetCurvatures = Eigen::VectorXd::Zero(mesh.NumberOfVertices());
  for (const int v : { 0, cells, cells * (cells + 1), (cells + 1) * (cells + 1) - 1 })
  {
    options.targetCurvatures[v] = 0.5 * Pi;
  }
  const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the square");
  EXPECT_LT(flow.logScales.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(flow.triangles.rows(), mesh.F.rows());
  EXPECT_NEAR(flow.area, 4.0, 1e-12);
  for (int v = 1; v < mesh.NumberOfVertices(); ++v)
  {
    const Eigen::MatrixX2d uv = FlatCoordinates(flow.flat, "the map");
    EXPECT_NEAR((uv.row(v) - uv.row(0)).norm(), (mesh.V.row(v) - mesh.V.row(0)).norm(), 1e-12);
  }
}

TEST(SurfaceRicciFlow, BoundariesShareTheirCurvatureByLength)
{
  const SurfaceMesh         mesh = Square(10, 1.0);
  const SurfaceRicciFlow    flow = FlowSurface(mesh, {}, "the square");
  const SurfaceConnectivity connectivity(mesh);
  ExpectExactCurvature(flow);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(flow.curvatures[v], connectivity.IsBoundaryVertex(v) ? 2 * Pi / 40 : 0.0, 1e-10);
  }
  EXPECT_NEAR(flow.area, 1.0, 1e-12);
}

TEST(SurfaceRicciFlow, FinalTriangulationOfASurfaceWithBoundariesCoversIt)
{
  const SurfaceMesh      mesh = Moebius(PolarGrid{ 48, 12, 0.3 }.Mesh(), 0.7);
  const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the annulus");
  EXPECT_EQ(flow.triangles.rows(), mesh.F.rows());
  const Eigen::VectorXd     defects = DefectsOfResult(flow, mesh.NumberOfVertices());
  const SurfaceConnectivity connectivity(mesh);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(defects[v], connectivity.IsBoundaryVertex(v) ? Pi : 0.0, 1e-7);
  }
}

TEST(SurfaceRicciFlow, ConesCarryTheCurvature)
{
  const SurfaceMesh        mesh = Icosphere(3, 1.0);
  SurfaceRicciFlowSettings options;
  options.cones = { 0, 3, 5, 7 };
  const SurfaceRicciFlow flow = FlowSurface(mesh, options, "the sphere");
  ExpectExactCurvature(flow);
  EXPECT_EQ(flow.geometry, RicciGeometry::Euclidean);
  const Eigen::VectorXd defects = DefectsOfResult(flow, mesh.NumberOfVertices());
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(defects[v], v == 0 || v == 3 || v == 5 || v == 7 ? Pi : 0.0, 1e-6);
  }
  options.coneCurvatures = { 0.5 * Pi, 1.5 * Pi, Pi, Pi };
  EXPECT_NEAR(FlowSurface(mesh, options, "the sphere").curvatures[3], 1.5 * Pi, 1e-10);
}

TEST(SurfaceRicciFlow, EqualBytesForAnyNumberOfThreads)
{
  const SurfaceMesh mesh = Roughened(Torus(60, 40, 2.0, 1.0), 0.03, 7);
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const SurfaceRicciFlow flow = FlowSurface(mesh, {}, "the torus");
      return std::make_tuple(FlatCoordinates(flow.flat, "the map"), flow.triangles, flow.sides);
    },
    { 3 });
}

TEST(SurfaceRicciFlow, RejectsWhatHasNoSuchMetric)
{
  const SurfaceMesh sphere = Icosphere(1, 1.0), disk = Square(4, 1.0);
  const auto refuses = [](const SurfaceMesh & mesh, const SurfaceRicciFlowSettings & options, const char * text) {
    EXPECT_TRUE(basetest::Refuses<Exception>([&] { FlowSurface(mesh, options, "it"); }, text));
  };
  SurfaceRicciFlowSettings flat;
  flat.geometry = RicciGeometry::Euclidean;
  refuses(sphere, flat, "the surface requires 4 pi");
  SurfaceRicciFlowSettings hyperbolic;
  hyperbolic.geometry = RicciGeometry::Hyperbolic;
  refuses(sphere, hyperbolic, "must be more than 4 pi");
  SurfaceRicciFlowSettings spherical;
  spherical.geometry = RicciGeometry::Spherical;
  refuses(disk, spherical, "requires a closed surface of genus 0");
  spherical.scheme = RicciScheme::InversiveDistance;
  refuses(sphere, spherical, "not available");
  SurfaceRicciFlowSettings cones;
  cones.cones = { 0, 0 };
  refuses(sphere, cones, "vertex 0 is repeated");
  cones.cones = { 1000 };
  refuses(sphere, cones, "does not exist");
  cones.cones = { 0, 1 };
  refuses(sphere, cones, "must be below 2 pi");
  cones.coneCurvatures = { 1.0 };
  refuses(sphere, cones, "1 values for 2 cones");
  SurfaceRicciFlowSettings given;
  given.targetCurvatures = Eigen::VectorXd::Zero(3);
  refuses(disk, given, "3 target curvatures");
  refuses(Together({ sphere, sphere }), {}, "component");
}
