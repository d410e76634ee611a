#include "shapetonSmoothedCurvature.h"

#include "shapetonSurfaceLaplacian.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
/** A cylinder of radius 20 mm; faces counterclockwise from outside. */
shapeton::SurfaceMesh
Cylinder()
{
  return testsurfaces::Cylinder(60, 40, 20.0, 80.0);
}

shapeton::SurfaceLaplacian
LaplacianOf(const shapeton::SurfaceMesh & mesh)
{
  return shapeton::MakeSurfaceLaplacian(shapeton::SurfaceConnectivity(mesh), mesh.V);
}
} // namespace

TEST(SmoothedCurvature, OfACylinderIsItsClosedForm)
{
  const shapeton::SurfaceMesh tube = Cylinder();
  const Eigen::VectorXd       curvature = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0);
  for (Eigen::Index i = 60; i + 60 < curvature.size(); ++i)
  {
    EXPECT_NEAR(curvature[i], -1.0 / 40.0, 1e-12); // bulges outward
  }
  EXPECT_EQ(curvature[0], 0.0); // on the boundary
}

TEST(SmoothedCurvature, TurnedFacesTurnItsSign)
{
  shapeton::SurfaceMesh tube = Cylinder();
  const Eigen::VectorXd expected = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 3.0);
  tube.F.col(1).swap(tube.F.col(2));
  EXPECT_LT((shapeton::SmoothedMeanCurvature(tube.V, tube.F, 3.0) + expected).norm(), 1e-9);
}

TEST(SmoothedCurvature, DiffusionKeepsTheIntegralAndEvensOut)
{
  const shapeton::SurfaceMesh      tube = Cylinder();
  const shapeton::SurfaceLaplacian laplacian = LaplacianOf(tube);
  const Eigen::VectorXd            before = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0);
  const Eigen::VectorXd            after = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 10.0);
  EXPECT_NEAR(laplacian.mass.dot(after), laplacian.mass.dot(before), 1e-6 * std::abs(laplacian.mass.dot(before)));
  EXPECT_LT(shapeton::GradientEnergy(laplacian, after), 0.5 * shapeton::GradientEnergy(laplacian, before));
}

TEST(SmoothedCurvature, ThePublishedOneGrowsWithTheFaces)
{
  const shapeton::SurfaceMesh      tube = Cylinder();
  const shapeton::SurfaceLaplacian laplacian = LaplacianOf(tube);
  const Eigen::VectorXd            perArea = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0);
  const Eigen::VectorXd            published =
    shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0, shapeton::CurvatureUnit::Published);
  EXPECT_LT((published + 2.0 * perArea.cwiseProduct(laplacian.mass)).norm(), 1e-9);
}

TEST(SmoothedCurvature, RefusesNegativeTimes)
{
  const shapeton::SurfaceMesh tube = Cylinder();
  EXPECT_THROW(shapeton::SmoothedMeanCurvature(tube.V, tube.F, -1.0), shapeton::ParameterError);
}
