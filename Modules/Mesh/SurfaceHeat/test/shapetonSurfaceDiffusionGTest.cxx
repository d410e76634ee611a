#include "shapetonSurfaceDiffusion.h"

#include "shapetonIntrinsicSurfaces.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

// A coordinate on a sphere is an eigenfunction with the eigenvalue 2 / r^2; each implicit step divides it by 1 + time /
// r^2.
TEST(SurfaceDiffusion, CoordinatesOfASphereDecayAsKnown)
{
  constexpr double       radius = 5.0, time = 4.0;
  const SurfaceMesh      sphere = Icosphere(4, radius);
  const SurfaceLaplacian laplacian = LaplacianOf(sphere);
  Eigen::MatrixXd        values(sphere.V.rows(), 4);
  values << sphere.V, Eigen::VectorXd::Constant(sphere.V.rows(), 7.0);
  DiffuseOverSurface(laplacian, time, values);
  const double step = 1.0 + time / (radius * radius);
  EXPECT_LT((values.leftCols(3) - sphere.V / (step * step)).cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT((values.col(3).array() - 7.0).abs().maxCoeff(), 1e-7); // constants are preserved
}

TEST(SurfaceDiffusion, HeatIsConservedAndNoTimeChangesNothing)
{
  const SurfaceMesh      tube = Cylinder(20, 15, 5.0, 12.0);
  const SurfaceLaplacian laplacian = LaplacianOf(tube);
  Eigen::MatrixXd        values = Eigen::MatrixXd::Zero(tube.V.rows(), 1);
  values(37, 0) = 1.0;
  const Eigen::MatrixXd before = values;
  DiffuseOverSurface(laplacian, 0.0, values);
  EXPECT_EQ(values, before);
  DiffuseOverSurface(laplacian, 3.0, values);
  EXPECT_NEAR(laplacian.mass.dot(values.col(0)), laplacian.mass[37], 1e-8);
  EXPECT_LT(values.maxCoeff(), 0.5);
  Eigen::MatrixXd wrong = Eigen::MatrixXd::Zero(3, 1);
  EXPECT_THROW(DiffuseOverSurface(laplacian, 1.0, wrong), ParameterError);
  EXPECT_THROW(DiffuseOverSurface(laplacian, -1.0, values), ParameterError);
}
} // namespace
