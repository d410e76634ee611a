#include "shapetonLabelSurfaces.h"

#include "shapetonPi.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonTestImages.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

using namespace shapeton;

namespace
{
using LabelImage = itk::Image<unsigned short, 3>;

const std::array<double, 3> ballCenter{ { 12.0, -7.0, 30.0 } };
constexpr double            ballRadius = 9.0;

/** Label 7 in a ball, 9 in a cube that touches two borders of the image; anisotropic and oblique. */
LabelImage::Pointer
BallAndCube(bool isLeftHanded)
{
  auto direction = basetest::Rotation(0, 0.3) * basetest::Rotation(2, 0.5);
  for (unsigned int row = 0; row < 3 && isLeftHanded; ++row)
  {
    direction(row, 2) *= -1.0;
  }
  const auto image = basetest::NewImage<LabelImage>({ { 50, 44, 40 } }, { { 0.7, 0.9, 1.3 } }, {}, direction);
  // Moves the center of the image to the center of the ball.
  const auto middle = image->TransformContinuousIndexToPhysicalPoint<double>(
    itk::ContinuousIndex<double, 3>(std::array<double, 3>{ { 24.5, 21.5, 19.5 } }.data()));
  image->SetOrigin(itk::Point<double, 3>(ballCenter.data()) - middle.GetVectorFromOrigin());
  basetest::ForVoxels(image, [&](const itk::Index<3> & index, const itk::Point<double, 3> & point) {
    const bool isInBall = point.EuclideanDistanceTo(itk::Point<double, 3>(ballCenter.data())) < ballRadius;
    const bool isInCube = index[0] < 6 && index[1] < 6 && index[2] >= 2 && index[2] < 8;
    image->SetPixel(index, isInBall ? 7 : isInCube ? 9 : 0);
  });
  return image;
}
} // namespace

TEST(LabelSurfaces, AreClosedOutwardAndInTheirPlace)
{
  for (const bool isLeftHanded : { false, true })
  {
    const auto surfaces = SurfacesOfLabels(BallAndCube(isLeftHanded), { 7, 8, 9 });
    ASSERT_EQ(surfaces.size(), 3u);
    EXPECT_EQ(surfaces[1].NumberOfFaces(), 0);
    for (const int i : { 0, 2 })
    {
      const SurfaceQuality quality = InspectSurface(surfaces[i]);
      EXPECT_TRUE(quality.isClosed && quality.isManifold && quality.isOriented);
      EXPECT_EQ(quality.genus, 0);
    }
    const double ball = 4.0 / 3.0 * Pi * std::pow(ballRadius, 3);
    EXPECT_NEAR(EnclosedVolume(surfaces[0].V, surfaces[0].F), ball, 0.02 * ball);
    const Eigen::RowVector3d center(ballCenter.data());
    const Eigen::VectorXd    radii = (surfaces[0].V.rowwise() - center).rowwise().norm();
    EXPECT_LT((radii.array() - ballRadius).abs().maxCoeff(), 0.5 * 1.3 + 0.5 * 0.7); // half a voxel, and the smoothing
    const double cube = std::pow(6.0, 3) * 0.7 * 0.9 * 1.3;
    EXPECT_NEAR(EnclosedVolume(surfaces[2].V, surfaces[2].F), cube, 0.1 * cube); // corners are cut
  }
}

TEST(LabelSurfaces, SmoothingFlattensStairs)
{
  const auto               surface = SurfacesOfLabels(BallAndCube(false), { 7 })[0];
  const VertexMatrix       normals = VertexNormals(surface.V, surface.F);
  const Eigen::RowVector3d center(ballCenter.data());
  const VertexMatrix       outward = (surface.V.rowwise() - center).rowwise().normalized();
  const Eigen::VectorXd    cosines = normals.cwiseProduct(outward).rowwise().sum();
  EXPECT_GT(cosines.mean(), std::cos(10.0 * Pi / 180.0));
}

TEST(LabelSurfaces, DoNotDependOnThreads)
{
  const auto image = BallAndCube(false);
  basetest::ExpectSameWithAnyThreads([&] { return SurfacesOfLabels(image, { 7 })[0].V; });
}
