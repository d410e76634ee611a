#include "shapetonHarmonicSolver.h"

#include "shapetonColonTube.h"
#include "shapetonIntrinsicSurfaces.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
using namespace testsurfaces;

std::string
ErrorOf(const shapeton::SurfaceMesh & mesh, const std::vector<int> & fixed)
{
  return basetest::ErrorOf([&] { const shapeton::HarmonicSolver solver(LaplacianOf(mesh), fixed); });
}
} // namespace

TEST(HarmonicSolver, LinearFunctionsOfThePlaneAreHarmonic)
{
  const shapeton::SurfaceMesh         mesh = Square(12, 30.0);
  const shapeton::SurfaceConnectivity connectivity(mesh);
  const std::vector<int>              rim = connectivity.BoundaryLoops().at(0);
  Eigen::MatrixXd                     truth(mesh.NumberOfVertices(), 2);
  truth.col(0) = 3.0 * mesh.V.col(0) - 2.0 * mesh.V.col(1);
  truth.col(1) = mesh.V.col(1).array() + 7.0;
  Eigen::MatrixXd given(rim.size(), 2);
  for (std::size_t i = 0; i < rim.size(); ++i)
  {
    given.row(i) = truth.row(rim[i]);
  }
  const Eigen::MatrixXd found = shapeton::HarmonicSolver(LaplacianOf(mesh), rim).Solve(given);
  EXPECT_LT((found - truth).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(HarmonicSolver, HeightIsHarmonicOnACylinderWithFixedEnds)
{
  const shapeton::SurfaceMesh         mesh = Cylinder(24, 40, 20.0, 100.0);
  const shapeton::SurfaceConnectivity connectivity(mesh);
  std::vector<int>                    fixed = connectivity.BoundaryLoops().at(0);
  const auto                          first = fixed.size();
  fixed.insert(fixed.end(), connectivity.BoundaryLoops().at(1).begin(), connectivity.BoundaryLoops().at(1).end());
  Eigen::MatrixXd given = Eigen::MatrixXd::Ones(fixed.size(), 1);
  given.topRows(first).setZero();
  const Eigen::MatrixXd u = shapeton::HarmonicSolver(LaplacianOf(mesh), fixed).Solve(given);
  const double          sign = mesh.V(fixed[0], 2) < 50.0 ? 1.0 : -1.0;
  const Eigen::VectorXd truth = (sign * (mesh.V.col(2).array() / 100.0 - 0.5) + 0.5).matrix();
  EXPECT_LT((u - truth).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(HarmonicSolver, SolvesPoissonsEquationWithOneFixedVertex)
{
  const shapeton::SurfaceMesh      mesh = MakeColonTube({ 3000, 2, 1, 400.0 }).mesh;
  const shapeton::SurfaceLaplacian laplacian = LaplacianOf(mesh);
  Eigen::MatrixXd                  source(mesh.NumberOfVertices(), 2);
  for (int i = 0; i < mesh.NumberOfVertices(); ++i)
  {
    source.row(i) << colontube::Uniform(5, 0, i) - 0.5, colontube::Uniform(5, 1, i) - 0.5;
  }
  const shapeton::HarmonicSolver solver(laplacian, { 17 });
  const Eigen::MatrixXd          given = Eigen::RowVector2d(4.0, -1.0);
  const Eigen::MatrixXd          x = solver.Solve(given, source);
  Eigen::MatrixXd                residual = shapeton::StiffnessMatrix(laplacian) * x - source;
  residual.row(17).setZero();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_DOUBLE_EQ(4.0, x(17, 0));
  EXPECT_DOUBLE_EQ(-1.0, x(17, 1));
  EXPECT_EQ(x.col(1), solver.Solve(given.col(1), source.col(1)));
}

TEST(HarmonicSolver, RefusesWhatHasNoUniqueSolution)
{
  EXPECT_NE(std::string::npos, ErrorOf(Octahedron(), {}).find("has none"));
  const shapeton::SurfaceMesh two = Together({ Octahedron(), Octahedron() });
  EXPECT_NE(std::string::npos, ErrorOf(two, { 0 }).find("the component of vertex 6 has none"));
  EXPECT_EQ("", ErrorOf(two, { 0, 6 }));
  EXPECT_NE(std::string::npos, ErrorOf(two, { 0, 0, 6 }).find("two fixed values"));
  EXPECT_NE(std::string::npos, ErrorOf(two, { 12 }).find("fixed vertex 12 does not exist"));
  EXPECT_NE(std::string::npos, ErrorOf(two, { -1 }).find("fixed vertex -1 does not exist"));
}

TEST(HarmonicSolver, RefusesSizesThatDoNotFit)
{
  const shapeton::HarmonicSolver solver(LaplacianOf(Octahedron()), { 0, 1 });
  EXPECT_THROW(solver.Solve(Eigen::MatrixXd::Zero(1, 1)), shapeton::InputError);
  EXPECT_THROW(solver.Solve(Eigen::MatrixXd::Zero(2, 1), Eigen::MatrixXd::Zero(5, 1)), shapeton::InputError);
  EXPECT_THROW(solver.Solve(Eigen::MatrixXd::Zero(2, 2), Eigen::MatrixXd::Zero(6, 1)), shapeton::InputError);
}
