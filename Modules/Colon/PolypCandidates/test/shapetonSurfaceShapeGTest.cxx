#include "shapetonPi.h"
#include "shapetonSurfaceShape.h"

#include "shapetonTestSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
shapeton::SurfaceShape
Measure(const shapeton::SurfaceMesh & mesh, double time)
{
  return shapeton::MeasureSurfaceShape(mesh.V, shapeton::SurfaceConnectivity(mesh), mesh.F, time);
}
} // namespace

// A ball in the lumen, with faces oriented inward.
TEST(SurfaceShape, BallHasItsCurvatureWhateverTheSmoothing)
{
  shapeton::SurfaceMesh ball = testsurfaces::Icosphere(4, 5.0);
  ball.F.col(1).swap(ball.F.col(2));
  for (const double time : { 0.0, 1.0, 4.0 })
  {
    const shapeton::SurfaceShape shape = Measure(ball, time);
    EXPECT_NEAR(shape.greater.mean(), 0.2, 0.004) << time;
    EXPECT_NEAR(shape.lesser.mean(), 0.2, 0.004) << time;
    EXPECT_GT(shape.lesser.minCoeff(), 0.18) << time;
    EXPECT_LT(shape.greater.maxCoeff(), 0.22) << time;
    // Outward, into the lumen around the ball.
    EXPECT_GT((shape.inwardNormals.cwiseProduct(ball.V)).rowwise().sum().minCoeff(), 4.9);
    // Gauss-Bonnet: 4 pi.
    EXPECT_NEAR((shape.greater.array() * shape.lesser.array() * shape.areas.array()).sum(), 4.0 * shapeton::Pi, 0.3);
  }
}

TEST(SurfaceShape, TubeIsHollowAcrossAndStraightAlong)
{
  const shapeton::SurfaceMesh  tube = testsurfaces::Cylinder(64, 40, 10.0, 40.0);
  const shapeton::SurfaceShape shape = Measure(tube, 1.0);
  int                          inner = 0;
  for (Eigen::Index i = 0; i < tube.V.rows(); ++i)
  {
    const double middle = 0.5 * (tube.V.col(2).minCoeff() + tube.V.col(2).maxCoeff());
    if (std::abs(tube.V(i, 2) - middle) < 12.0)
    {
      EXPECT_NEAR(shape.lesser[i], -0.1, 0.004);
      EXPECT_NEAR(shape.greater[i], 0.0, 0.004);
      ++inner;
    }
  }
  EXPECT_GT(inner, 500);
}

TEST(SurfaceShape, IndexTellsCapsRidgesAndPits)
{
  EXPECT_DOUBLE_EQ(shapeton::ShapeIndex(0.2, 0.2), 1.0);
  EXPECT_DOUBLE_EQ(shapeton::ShapeIndex(0.2, 0.0), 0.5);
  EXPECT_DOUBLE_EQ(shapeton::ShapeIndex(0.2, -0.2), 0.0);
  EXPECT_DOUBLE_EQ(shapeton::ShapeIndex(0.0, -0.2), -0.5);
  EXPECT_DOUBLE_EQ(shapeton::ShapeIndex(-0.2, -0.2), -1.0);
  EXPECT_DOUBLE_EQ(shapeton::Curvedness(0.3, 0.3), 0.3);
}
