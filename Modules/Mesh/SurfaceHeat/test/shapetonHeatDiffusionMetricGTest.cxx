#include "shapetonHeatDiffusionMetric.h"
#include "shapetonHeatKernel.h"

#include "shapetonColonTube.h"
#include "shapetonIntrinsicSurfaces.h"
#include "shapetonProgressTests.h"
#include "shapetonSurfaceSimplification.h"
#include "shapetonExceptions.h"

#include "itkMultiThreaderBase.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numeric>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

double
MeanEdge(const SurfaceMesh & mesh)
{
  return EdgeLengths(SurfaceConnectivity(mesh), mesh.V).mean();
}

double
LargestRelative(const Eigen::VectorXd & a, const Eigen::VectorXd & b)
{
  return ((a - b).array() / b.array()).abs().maxCoeff();
}

double
RelativeRms(const Eigen::VectorXd & a, const Eigen::VectorXd & b)
{
  return std::sqrt(((a - b).array() / b.array()).square().mean());
}

/** A closed prism of this width and length that replaces a vertex of a convex surface with these incident faces. */
SurfaceMesh
WithNeedle(const SurfaceMesh & body, int tip, double radius, double length)
{
  const Eigen::RowVector3d     foot = body.V.row(tip);
  const Eigen::RowVector3d     end = foot + length * foot.normalized();
  std::vector<Eigen::Vector3i> faces;
  VertexMatrix                 V = body.V;
  V.conservativeResize(2 * V.rows(), Eigen::NoChange); // each vertex has at most one foot and one top
  std::map<int, int> feet;
  const auto         footOf = [&](int v) {
    const auto [place, isNew] = feet.emplace(v, static_cast<int>(body.V.rows() + 2 * feet.size()));
    if (isNew)
    {
      const Eigen::RowVector3d out = radius * (body.V.row(v) - foot).normalized();
      V.row(place->second) = foot + out;
      V.row(place->second + 1) = end + out;
    }
    return place->second;
  };
  for (Eigen::Index f = 0; f < body.F.rows(); ++f)
  {
    Eigen::Vector3i face = body.F.row(f).transpose();
    while (face[0] != tip && (face[1] == tip || face[2] == tip))
    {
      face = Eigen::Vector3i(face[1], face[2], face[0]);
    }
    if (face[0] != tip)
    {
      faces.push_back(face);
      continue;
    }
    const int a = footOf(face[1]);
    const int b = footOf(face[2]);
    faces.insert(
      faces.end(),
      { { a, face[1], face[2] }, { a, face[2], b }, { a + 1, a, b }, { a + 1, b, b + 1 }, { tip, a + 1, b + 1 } });
  }
  V.row(tip) = end;
  SurfaceMesh mesh;
  mesh.V = V.topRows(body.V.rows() + 2 * static_cast<Eigen::Index>(feet.size()));
  mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    mesh.F.row(static_cast<Eigen::Index>(f)) = faces[f].transpose();
  }
  return mesh;
}

/** Metric from all eigenpairs, by dense decomposition. */
Eigen::VectorXd
DenseMetric(const SurfaceLaplacian & laplacian, double t)
{
  const int n = laplacian.NumberOfVertices();
  return TruncatedHeatDiffusionMetric(laplacian, ComputeSurfaceSpectrum(laplacian, n), t, n).edgeLengths;
}

TEST(HeatDiffusionMetric, IsThatOfAllEigenpairs)
{
  const SurfaceMesh meshes[] = { Icosphere(2, 10.0),
                                 Roughened(Cylinder(16, 18, 5.0, 20.0), 0.2, 1),
                                 Roughened(Torus(24, 12, 10.0, 4.0), 0.2, 2),
                                 Roughened(Square(18, 18.0), 0.2, 3) };
  for (const SurfaceMesh & mesh : meshes)
  {
    const HeatDiffusionMetricSolver solver(LaplacianOf(mesh));
    const double                    h = MeanEdge(mesh);
    for (const double factor : { 0.1, 1.0, 4.0 })
    {
      const double          t = factor * h * h;
      const Eigen::VectorXd right = DenseMetric(solver.Laplacian(), t);
      EXPECT_LT(LargestRelative(solver.Compute(t, 8).edgeLengths, right), 1e-9) << factor;
      EXPECT_LT(LargestRelative(solver.Compute(t).edgeLengths, right), 1e-6) << factor;
    }
  }
}

TEST(HeatDiffusionMetric, IsThatOfEnoughEigenpairsOnAColonOf12000Faces)
{
  const SurfaceMesh     mesh = MakeColonTube({ 12000, 0, 1, 700.0 }).mesh;
  const auto            laplacian = LaplacianOf(mesh);
  const double          t = 32.0 * std::pow(MeanEdge(mesh), 2);
  const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(laplacian, 150);
  ASSERT_GT(2.0 * t * spectrum.eigenvalues[149], 18.0);
  const auto metric = HeatDiffusionMetricSolver(laplacian).Compute(t);
  EXPECT_LT(RelativeRms(metric.edgeLengths, TruncatedHeatDiffusionMetric(laplacian, spectrum, t, 150).edgeLengths),
            1e-5);
}

TEST(HeatDiffusionMetric, KeepsItsDigitsOnASimplifiedSurface)
{
  SurfaceSimplificationSettings simplification;
  simplification.faces = 6000;
  const SurfaceMesh               mesh = SimplifySurface(MakeColonTube({ 30000 }).mesh, simplification);
  const HeatDiffusionMetricSolver solver(LaplacianOf(mesh));
  for (const double factor : { 0.5, 2.0, 4.0 })
  {
    const double t = factor * std::pow(MeanEdge(mesh), 2);
    EXPECT_LT(LargestRelative(solver.Compute(t).edgeLengths, solver.Compute(t, 8).edgeLengths), 1e-6) << factor;
  }
}

TEST(HeatDiffusionMetric, StatesItsTime)
{
  const auto mesh = Icosphere(2, 10.0);
  const auto laplacian = LaplacianOf(mesh);
  const auto exact = ComputeHeatDiffusionMetric(mesh, 1.5);
  EXPECT_EQ(exact.time, 1.5);
  EXPECT_EQ(exact.eigenpairs, 0);
  EXPECT_GT(exact.rationalError, 0.0);
  const auto truncated = TruncatedHeatDiffusionMetric(laplacian, ComputeSurfaceSpectrum(laplacian, 50), 2.5, 50);
  EXPECT_EQ(truncated.time, 2.5);
  EXPECT_EQ(truncated.eigenpairs, 50);
  EXPECT_EQ(truncated.rationalError, 0.0);
}

TEST(HeatDiffusionMetric, DoesNotChangeWithRigidMotionsAndScalesAsALength)
{
  SurfaceMesh             mesh = Roughened(Torus(30, 15, 10.0, 4.0), 0.2, 4);
  const Eigen::VectorXd   right = ComputeHeatDiffusionMetric(mesh, 2.0).edgeLengths;
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(1.0, -2.0, 0.5).normalized());
  const SurfaceMesh       original = mesh;
  mesh.V = (original.V * turn.toRotationMatrix().transpose()).rowwise() + Eigen::RowVector3d(30.0, -80.0, 11.0);
  EXPECT_LT(LargestRelative(ComputeHeatDiffusionMetric(mesh, 2.0).edgeLengths, right), 1e-10);
  mesh.V = 3.0 * original.V;
  EXPECT_LT(LargestRelative(3.0 * ComputeHeatDiffusionMetric(mesh, 18.0).edgeLengths, right), 1e-10);
}

TEST(HeatDiffusionMetric, DoesNotDependOnTheNumbersOfTheVertices)
{
  const SurfaceMesh mesh = Roughened(Cylinder(20, 30, 5.0, 20.0), 0.2, 5);
  const int         n = mesh.NumberOfVertices();
  std::vector<int>  newNumber(n);
  std::iota(newNumber.begin(), newNumber.end(), 0);
  Random random(6);
  for (int i = n - 1; i > 0; --i)
  {
    std::swap(newNumber[i], newNumber[random.Below(i + 1)]);
  }
  SurfaceMesh renumbered = mesh;
  for (int i = 0; i < n; ++i)
  {
    renumbered.V.row(newNumber[i]) = mesh.V.row(i);
  }
  for (Eigen::Index i = 0; i < mesh.F.size(); ++i)
  {
    renumbered.F.data()[i] = newNumber[mesh.F.data()[i]];
  }
  const SurfaceConnectivity connectivity(mesh), other(renumbered);
  const Eigen::VectorXd     a = ComputeHeatDiffusionMetric(mesh, 2.0).edgeLengths;
  const Eigen::VectorXd     b = ComputeHeatDiffusionMetric(renumbered, 2.0).edgeLengths;
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & ends = connectivity.VerticesOfEdge(edge);
    const int    same = other.FindEdge(newNumber[ends[0]], newNumber[ends[1]]);
    EXPECT_NEAR(b[same], a[edge], 1e-10 * a[edge]);
  }
}

TEST(HeatDiffusionMetric, MakesATriangleOfEachFace)
{
  const SurfaceMesh         mesh = MakeColonTube({ 8000, 5 }).mesh;
  const SurfaceConnectivity connectivity(mesh);
  const double              h = MeanEdge(mesh);
  const auto                metric = ComputeHeatDiffusionMetric(mesh, 4.0 * h * h);
  for (int face = 0; face < mesh.NumberOfFaces(); ++face)
  {
    double sides[3];
    for (int k = 0; k < 3; ++k)
    {
      sides[k] = metric.edgeLengths[connectivity.EdgeOfFace(face, k)];
    }
    std::sort(sides, sides + 3);
    EXPECT_LT(sides[2], sides[0] + sides[1]) << face;
  }
  EXPECT_NO_THROW(MakeSurfaceLaplacian(connectivity, metric.edgeLengths));
}

TEST(HeatDiffusionMetric, BeginsWithTheMassesAndEndsWithTheSlowestFunction)
{
  const SurfaceMesh               mesh = Icosphere(2, 10.0);
  const HeatDiffusionMetricSolver solver(LaplacianOf(mesh));
  const auto &                    laplacian = solver.Laplacian();
  const Eigen::VectorXd           early = solver.Compute(1e-9).edgeLengths;
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const auto & [p, q] = laplacian.edges[edge];
    EXPECT_NEAR(early[edge], std::sqrt(1.0 / laplacian.mass[p] + 1.0 / laplacian.mass[q]), 1e-6);
  }
  const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(laplacian, 4); // constant and a triple eigenvalue
  const double          t = 2.0 / spectrum.eigenvalues[3];               // the next add e^-8 less to the square
  const Eigen::VectorXd late = solver.Compute(t, 8).edgeLengths;
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const double right = DiffusionDistance(spectrum, laplacian.edges[edge][0], laplacian.edges[edge][1], t);
    EXPECT_NEAR(late[edge], right, 2e-3 * right);
  }
}

TEST(HeatDiffusionMetric, GivesTheSameBytesForAnyNumberOfThreads)
{
  const HeatDiffusionMetricSolver solver(LaplacianOf(MakeColonTube({ 8000 }).mesh));
  Eigen::VectorXd                 first;
  for (const unsigned int threads : { 1, 2, 3 })
  {
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
    for (const int atOnce : { 1, 2, 3 })
    {
      const Eigen::VectorXd lengths = solver.Compute(40.0, 6, atOnce).edgeLengths;
      first = first.size() == 0 ? lengths : first;
      EXPECT_EQ(lengths, first) << threads << " threads";
    }
  }
}

TEST(HeatDiffusionMetric, TruncatedLacksTheAnglesOfALongTube)
{
  // 50 pairs, as published, are not sufficient for a whole colon: they are constant around the tube.
  const SurfaceMesh         mesh = Cylinder(12, 300, 1.0, 200.0);
  const SurfaceConnectivity connectivity(mesh);
  const auto                laplacian = MakeSurfaceLaplacian(connectivity, mesh.V);
  const auto truncated = TruncatedHeatDiffusionMetric(laplacian, ComputeSurfaceSpectrum(laplacian, 50), 0.1, 50);
  const auto exact = HeatDiffusionMetricSolver(laplacian).Compute(0.1);
  const int  around = connectivity.FindEdge(12 * 150, 12 * 150 + 1);
  EXPECT_LT(truncated.edgeLengths[around], 0.05 * exact.edgeLengths[around]);
}

TEST(HeatDiffusionMetric, DefaultTimeIsThatOfTheMeshAndTheLumen)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(72.0, DefaultDiffusionTime(3.0, infinity));
  EXPECT_DOUBLE_EQ(72.0, DefaultDiffusionTime(3.0, 20.0));
  EXPECT_DOUBLE_EQ(72.0, DefaultDiffusionTime(6.0, 20.0));
  EXPECT_DOUBLE_EQ(32.0, DefaultDiffusionTime(2.0, 20.0));
  EXPECT_DOUBLE_EQ(15.0, DefaultDiffusionTime(3.0, 5.0));
  EXPECT_DOUBLE_EQ(9.0, DefaultDiffusionTime(3.0, 2.0));
  EXPECT_FALSE(IsTooCoarseForDiffusion(3.0, 2.7));
  EXPECT_TRUE(IsTooCoarseForDiffusion(3.0, 2.6));
  for (const double radius : { 0.0, -1.0, std::nan("") })
  {
    EXPECT_THROW(DefaultDiffusionTime(3.0, radius), InputError);
    EXPECT_THROW(IsTooCoarseForDiffusion(3.0, radius), InputError);
    EXPECT_THROW(FacesForDiffusion(1e5, radius), InputError);
  }
}

TEST(HeatDiffusionMetric, FacesFollowAreaAndRadius)
{
  EXPECT_EQ(55000, FacesForDiffusion(90000.0, 8.0));
  EXPECT_EQ(238095, FacesForDiffusion(400000.0, 8.0));
  EXPECT_EQ(423280, FacesForDiffusion(400000.0, 1.5));
  EXPECT_EQ(500000, FacesForDiffusion(400000.0, 0.5));
}

TEST(HeatDiffusionMetric, MeanEdgeAt55000FacesDoesNotDependOnTheMesh)
{
  const auto meanEdge = [](int faces) {
    const SurfaceMesh         mesh = MakeColonTube({ faces }).mesh;
    const SurfaceConnectivity connectivity(mesh);
    return MeanEdgeAt55000Faces(connectivity, EdgeLengths(connectivity, mesh.V));
  };
  EXPECT_NEAR(meanEdge(32000), meanEdge(8000), 0.1 * meanEdge(8000));
}

/** Heat is constant up to rounding around a needle; the rest of the surface is unaffected. */
TEST(HeatDiffusionMetric, NeedlesHaveTheLeastLengthThatCanBeTold)
{
  const SurfaceMesh         sphere = Icosphere(5, 10.0);
  const SurfaceMesh         needle = WithNeedle(sphere, 0, 0.02, 10.0);
  const SurfaceConnectivity connectivity(needle);
  const double              t = 8.0;
  const HeatDiffusionMetric metric = ComputeHeatDiffusionMetric(needle, t);
  EXPECT_GE(metric.drownedEdges, 5);
  EXPECT_LE(metric.drownedEdges, 20); // edges of the needle
  EXPECT_TRUE(AreTriangles(connectivity, metric.edgeLengths));
  const HeatDiffusionMetric whole = ComputeHeatDiffusionMetric(sphere, t);
  EXPECT_EQ(0, whole.drownedEdges);
  const SurfaceConnectivity ofSphere(sphere);
  for (int edge = 0; edge < ofSphere.NumberOfEdges(); ++edge)
  {
    const auto [p, q] = ofSphere.VerticesOfEdge(edge);
    if ((sphere.V.row(p) - sphere.V.row(0)).norm() > 5.0)
    {
      const double length = metric.edgeLengths[connectivity.FindEdge(p, q)];
      EXPECT_NEAR(whole.edgeLengths[edge], length, 0.01 * length);
    }
  }
}

TEST(HeatDiffusionMetric, RefusesBadInput)
{
  const SurfaceMesh sphere = Icosphere(2, 10.0);
  for (const double t : { 0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    EXPECT_THROW(ComputeHeatDiffusionMetric(sphere, t), InputError);
  }
  EXPECT_THROW(ComputeHeatDiffusionMetric(sphere, 1e6), InputError); // distances of 1e-12000
  EXPECT_THROW(ComputeHeatDiffusionMetric(SurfaceMesh(), 1.0), InputError);
  EXPECT_THROW(ComputeHeatDiffusionMetric(Together({ sphere, Square(3, 3.0) }), 1.0), InputError);
  SurfaceMesh mesh = sphere;
  mesh.V(3, 0) = std::nan("");
  EXPECT_THROW(ComputeHeatDiffusionMetric(mesh, 1.0), InputError);
  mesh = sphere;
  mesh.V.row(mesh.F(0, 0)) = mesh.V.row(mesh.F(0, 1));
  EXPECT_THROW(ComputeHeatDiffusionMetric(mesh, 1.0), InputError);
  mesh = sphere;
  mesh.F.conservativeResize(mesh.F.rows() + 1, Eigen::NoChange);
  mesh.F.row(mesh.F.rows() - 1) << mesh.F(0, 0), mesh.F(0, 1), mesh.F(100, 2); // a third face at an edge
  EXPECT_THROW(ComputeHeatDiffusionMetric(mesh, 1.0), InputError);
  mesh = Square(1, 3.0);
  mesh.V.row(1) << 1.5, 1.5, 0.0; // a face without area
  EXPECT_THROW(ComputeHeatDiffusionMetric(mesh, 1.0), InputError);
  const HeatDiffusionMetricSolver solver(LaplacianOf(sphere));
  EXPECT_THROW(solver.Compute(1.0, 2), InputError);
  EXPECT_THROW(solver.Compute(1.0, 9), InputError);
  const SurfaceSpectrum spectrum = ComputeSurfaceSpectrum(solver.Laplacian(), 20);
  EXPECT_THROW(TruncatedHeatDiffusionMetric(solver.Laplacian(), spectrum, 1.0, 21), InputError);
  EXPECT_THROW(TruncatedHeatDiffusionMetric(solver.Laplacian(), spectrum, -1.0, 10), InputError);
}
TEST(HeatDiffusionMetric, IsAbortedByProgress)
{
  const SurfaceMesh mesh = Roughened(Torus(96, 48, 10.0, 4.0), 0.2, 2);
  test::ExpectProgress([&](const Progress & progress) { ComputeHeatDiffusionMetric(mesh, 0.5, progress); }, 10);
}
} // namespace
