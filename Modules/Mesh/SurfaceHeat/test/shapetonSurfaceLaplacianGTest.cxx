#include "shapetonSurfaceLaplacian.h"

#include "shapetonColonTube.h"
#include "shapetonIntrinsicSurfaces.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

TEST(SurfaceLaplacian, MassAddsUpToTheArea)
{
  const SurfaceMesh mesh = Roughened(Cylinder(20, 15, 5.0, 12.0), 0.4, 1);
  const double      area = SurfaceArea(mesh.V, mesh.F);
  for (const auto lumping : { MassLumping::Barycentric, MassLumping::MixedVoronoi })
  {
    SurfaceLaplacianOptions options;
    options.lumping = lumping;
    const SurfaceLaplacian laplacian = LaplacianOf(mesh, options);
    EXPECT_NEAR(laplacian.mass.sum(), area, 1e-11 * area);
    EXPECT_GT(laplacian.mass.minCoeff(), 0.0);
  }
}

TEST(SurfaceLaplacian, VoronoiCellsOfARightGridAreItsCells)
{
  SurfaceLaplacianOptions options;
  options.lumping = MassLumping::MixedVoronoi;
  const SurfaceLaplacian laplacian = LaplacianOf(Square(4, 4.0), options);
  EXPECT_NEAR(laplacian.mass[12], 1.0, 1e-14); // the center
  EXPECT_NEAR(laplacian.mass[0], 0.25, 1e-14); // a corner
}

TEST(SurfaceLaplacian, IsSymmetricAndSemidefiniteWithRowSumsOfZero)
{
  const SurfaceMesh     mesh = Roughened(Square(14, 14.0), 0.45, 2); // including obtuse angles
  const auto            laplacian = LaplacianOf(mesh);
  const Eigen::MatrixXd L = StiffnessMatrix(laplacian);
  EXPECT_LT(laplacian.weights.minCoeff(), 0.0);
  EXPECT_EQ(L, L.transpose());
  EXPECT_LT(L.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(L.diagonal(), StiffnessDiagonal(laplacian));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(L);
  EXPECT_GT(solver.eigenvalues()[0], -1e-12);
  EXPECT_GT(solver.eigenvalues()[1], 1e-3);
}

TEST(SurfaceLaplacian, GradientEnergyOfALinearFunctionIsExact)
{
  SurfaceMesh mesh = Roughened(Square(10, 7.0), 0.2, 3);
  mesh.V.col(2).setZero();
  const Eigen::VectorXd u = 3.0 * mesh.V.col(0) - 2.0 * mesh.V.col(1);
  const auto            laplacian = LaplacianOf(mesh);
  EXPECT_NEAR(GradientEnergy(laplacian, u), 13.0 * SurfaceArea(mesh.V, mesh.F), 1e-10);
  EXPECT_NEAR(u.dot(StiffnessMatrix(laplacian) * u), 13.0 * SurfaceArea(mesh.V, mesh.F), 1e-10);
}

TEST(SurfaceLaplacian, WeightsOfEquilateralTriangles)
{
  const double      height = std::sqrt(0.75);
  const SurfaceMesh mesh =
    FromLists({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, height, 0 }, { 0.5, -height, 0 } }, { { 0, 1, 2 }, { 1, 0, 3 } });
  const SurfaceConnectivity connectivity(mesh);
  const auto                laplacian = MakeSurfaceLaplacian(connectivity, mesh.V);
  const double              cotangent = 1.0 / std::sqrt(3.0);
  EXPECT_NEAR(laplacian.weights[connectivity.FindEdge(0, 1)], cotangent, 1e-14);
  EXPECT_NEAR(laplacian.weights[connectivity.FindEdge(1, 2)], 0.5 * cotangent, 1e-14);
}

TEST(SurfaceLaplacian, FromLengthsAloneIsTheSame)
{
  const SurfaceMesh         mesh = Roughened(Torus(20, 10, 10.0, 3.0), 0.3, 4);
  const SurfaceConnectivity connectivity(mesh);
  const auto                inSpace = MakeSurfaceLaplacian(connectivity, mesh.V);
  const auto                intrinsic = MakeSurfaceLaplacian(connectivity, EdgeLengths(connectivity, mesh.V));
  EXPECT_EQ(inSpace.weights, intrinsic.weights);
  EXPECT_EQ(inSpace.mass, intrinsic.mass);
  const Eigen::VectorXd doubled = 2.0 * EdgeLengths(connectivity, mesh.V);
  const auto            twice = MakeSurfaceLaplacian(connectivity, doubled);
  EXPECT_LT((twice.weights - inSpace.weights).norm(), 1e-12);
  EXPECT_LT((twice.mass - 4.0 * inSpace.mass).norm(), 1e-12);
}

TEST(SurfaceLaplacian, NeedlesAreClampedAndStaySemidefinite)
{
  SurfaceMesh mesh = Square(6, 6.0);
  mesh.V(24, 0) = mesh.V(25, 0) - 1e-9; // faces with a height of 1e-9 of their longest side
  const auto laplacian = LaplacianOf(mesh);
  EXPECT_FALSE(laplacian.clampedFaces.empty());
  EXPECT_LT(laplacian.weights.cwiseAbs().maxCoeff(), 1e7);
  const Eigen::MatrixXd                                L = StiffnessMatrix(laplacian);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(L);
  EXPECT_GT(solver.eigenvalues()[0], -1e-9);
}

TEST(SurfaceLaplacian, LengthsThatMissATriangleByRoundingAreANeedle)
{
  const SurfaceMesh         mesh = Square(1, 1.0);
  const SurfaceConnectivity connectivity(mesh);
  Eigen::VectorXd           lengths = EdgeLengths(connectivity, mesh.V);
  const int                 diagonal = connectivity.FindEdge(0, 3);
  lengths[diagonal] = 2.0 * (1.0 + 1e-7);
  EXPECT_EQ(MakeSurfaceLaplacian(connectivity, lengths).clampedFaces.size(), 2u);
  lengths[diagonal] = 2.1;
  EXPECT_THROW(MakeSurfaceLaplacian(connectivity, lengths), InputError);
}

TEST(SurfaceLaplacian, SidesTooShortForTheirTrianglesAreLengthened)
{
  const SurfaceMesh         mesh = Square(4, 1.0);
  const SurfaceConnectivity connectivity(mesh);
  const Eigen::VectorXd     straight = EdgeLengths(connectivity, mesh.V);
  Eigen::VectorXd           lengths = straight;
  EXPECT_TRUE(LengthenShortestSides(connectivity, lengths).empty());
  EXPECT_EQ(straight, lengths);

  // The edge from (0, 0) to (1, 0) has one face; its other sides have 1 and sqrt(2) steps.
  const int edge = connectivity.FindEdge(0, 1);
  lengths[edge] = 1e-3;
  EXPECT_EQ(std::set<int>{ edge }, LengthenShortestSides(connectivity, lengths));
  EXPECT_NEAR((std::sqrt(2.0) - 1.0) * straight[edge], lengths[edge], 1e-12);
  lengths[edge] = straight[edge];
  EXPECT_EQ(straight, lengths);

  // Vertices closer than the error of the distances: only lengths of this size change.
  constexpr double error = 1e-3;
  SurfaceMesh      dense = mesh;
  dense.V *= 0.2 * error / straight[edge];
  dense.V.row(0) << 10.0, 10.0, 0.0;
  const Eigen::VectorXd right = EdgeLengths(connectivity, dense.V);
  Eigen::VectorXd       measured = right;
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    measured[e] = std::max(1e-6, right[e] + error * ((5 * e) % 7 - 3) / 3.0);
  }
  const Eigen::VectorXd before = measured;
  EXPECT_FALSE(AreTriangles(connectivity, measured));
  const std::set<int> lengthened = LengthenShortestSides(connectivity, measured);
  EXPECT_TRUE(AreTriangles(connectivity, measured));
  for (int e = 0; e < connectivity.NumberOfEdges(); ++e)
  {
    EXPECT_NEAR(right[e], measured[e], 4.0 * error);
    EXPECT_EQ(lengthened.count(e) == 0, before[e] == measured[e]);
    EXPECT_EQ(0U, right[e] > 1.0 ? lengthened.count(e) : 0U);
  }
}

TEST(SurfaceLaplacian, RefusesBadInput)
{
  SurfaceMesh empty;
  EXPECT_THROW(LaplacianOf(empty), InputError);
  SurfaceMesh mesh = Square(3, 3.0);
  mesh.V(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(LaplacianOf(mesh), InputError);
  mesh = Square(3, 3.0);
  mesh.V.row(5) = mesh.V.row(6);
  EXPECT_THROW(LaplacianOf(mesh), InputError);
  mesh = Square(1, 3.0);
  mesh.V.row(1) << 1.5, 1.5, 0.0; // in the center of the diagonal
  EXPECT_THROW(LaplacianOf(mesh), InputError);
  mesh = Square(3, 3.0);
  mesh.V.conservativeResize(mesh.V.rows() + 1, Eigen::NoChange);
  mesh.V.row(mesh.V.rows() - 1).setZero();
  EXPECT_THROW(LaplacianOf(mesh), InputError); // an unreferenced vertex
  mesh = Square(3, 3.0);
  mesh.F.row(2) << 1, 1, 5;
  EXPECT_THROW(LaplacianOf(mesh), InputError);
  const SurfaceConnectivity connectivity(Square(3, 3.0));
  EXPECT_THROW(MakeSurfaceLaplacian(connectivity, Eigen::VectorXd(Eigen::VectorXd::Ones(2))), InputError);
}

TEST(SurfaceLaplacian, OneManifoldIsRequired)
{
  EXPECT_NO_THROW(RequireOneManifold(SurfaceConnectivity(Square(3, 3.0)), "s"));
  EXPECT_THROW(RequireOneManifold(SurfaceConnectivity(Together({ Square(3, 3.0), Square(2, 1.0) })), "s"), InputError);
  EXPECT_THROW(RequireOneManifold(SurfaceConnectivity(SurfaceMesh()), "s"), InputError);
  SurfaceMesh mesh = Square(3, 3.0);
  mesh.F.conservativeResize(mesh.F.rows() + 1, Eigen::NoChange);
  mesh.F.row(mesh.F.rows() - 1) << 0, 5, 10; // a third face at inner edges
  EXPECT_THROW(RequireOneManifold(SurfaceConnectivity(mesh), "s"), InputError);
}
} // namespace
