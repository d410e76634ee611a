#include "shapetonSmoothedCurvature.h"

#include "shapetonFlatTestTubes.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
/** A closed cylinder of radius 20 mm; faces counterclockwise from outside. */
struct Cylinder
{
  explicit Cylinder(int around = 60, int along = 40)
  {
    V.resize(around * (along + 1), 3);
    F.resize(2 * around * along, 3);
    for (int i = 0; i < V.rows(); ++i)
    {
      V.row(i) = flattubes::OnCylinder(20.0, 2.0 * (i / around), 2.0 * flattubes::pi * (i % around) / around);
    }
    for (int i = 0; i < around * along; ++i)
    {
      const int next = i / around * around + (i + 1) % around;
      F.row(2 * i) << i, next, next + around;
      F.row(2 * i + 1) << i, next + around, i + around;
    }
  }
  shapeton::VertexMatrix V;
  shapeton::FaceMatrix   F;
};
} // namespace

TEST(SmoothedCurvature, OfACylinderIsItsClosedForm)
{
  const Cylinder        tube;
  const Eigen::VectorXd curvature = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0);
  for (Eigen::Index i = 60; i + 60 < curvature.size(); ++i)
  {
    EXPECT_NEAR(curvature[i], -1.0 / 40.0, 1e-12); // bulges outward
  }
  EXPECT_EQ(curvature[0], 0.0); // on the boundary
}

TEST(SmoothedCurvature, TurnedFacesTurnItsSign)
{
  Cylinder              tube;
  const Eigen::VectorXd expected = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 3.0);
  tube.F.col(1).swap(tube.F.col(2));
  EXPECT_LT((shapeton::SmoothedMeanCurvature(tube.V, tube.F, 3.0) + expected).norm(), 1e-9);
}

TEST(SmoothedCurvature, DiffusionKeepsTheIntegralAndEvensOut)
{
  const Cylinder                   tube;
  const shapeton::SurfaceLaplacian laplacian =
    shapeton::MakeSurfaceLaplacian(shapeton::SurfaceConnectivity(tube.F, static_cast<int>(tube.V.rows())), tube.V);
  const Eigen::VectorXd before = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0);
  const Eigen::VectorXd after = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 10.0);
  EXPECT_NEAR(laplacian.mass.dot(after), laplacian.mass.dot(before), 1e-6 * std::abs(laplacian.mass.dot(before)));
  EXPECT_LT(shapeton::GradientEnergy(laplacian, after), 0.5 * shapeton::GradientEnergy(laplacian, before));
}

TEST(SmoothedCurvature, ThePublishedOneGrowsWithTheFaces)
{
  const Cylinder                   tube;
  const shapeton::SurfaceLaplacian laplacian =
    shapeton::MakeSurfaceLaplacian(shapeton::SurfaceConnectivity(tube.F, static_cast<int>(tube.V.rows())), tube.V);
  const Eigen::VectorXd perArea = shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0);
  const Eigen::VectorXd published =
    shapeton::SmoothedMeanCurvature(tube.V, tube.F, 0.0, shapeton::CurvatureUnit::Published);
  EXPECT_LT((published + 2.0 * perArea.cwiseProduct(laplacian.mass)).norm(), 1e-9);
}

TEST(SmoothedCurvature, RefusesNegativeTimes)
{
  const Cylinder tube;
  EXPECT_THROW(shapeton::SmoothedMeanCurvature(tube.V, tube.F, -1.0), shapeton::ParameterError);
}
