#include "shapetonFlatDistortion.h"

#include "shapetonColonTube.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
Plane()
{
  shapeton::SurfaceMesh mesh = Square(9, 30.0);
  for (int v = 0; v < mesh.NumberOfVertices(); ++v)
  {
    mesh.V(v, 0) += colontube::Uniform(3, 0, v);
    mesh.V(v, 1) += colontube::Uniform(3, 1, v);
  }
  return mesh;
}

shapeton::FlatDistortion
DistortionOf(const shapeton::SurfaceMesh & mesh, const Eigen::Matrix2d & map)
{
  const Eigen::MatrixX2d uv = mesh.V.leftCols<2>() * map.transpose();
  return shapeton::MeasureFlatDistortion(mesh.F, uv, shapeton::SidesOfFaces(mesh.V, mesh.F));
}
} // namespace

TEST(FlatDistortion, LinearMapsHaveTheRatioOfTheirSingularValues)
{
  Eigen::Matrix2d turn, stretch;
  turn << 0.6, -0.8, 0.8, 0.6;
  stretch << 3.0, 0.0, 0.0, 2.0;
  const shapeton::FlatDistortion distortion = DistortionOf(Plane(), turn * stretch);
  EXPECT_LT((distortion.dilatation.array() - 1.5).abs().maxCoeff(), 1e-9);
  EXPECT_LT((distortion.areaScale.array() - 6.0).abs().maxCoeff(), 1e-9);
  EXPECT_EQ(0, distortion.flips);
  EXPECT_FALSE(distortion.isClockwise);
  const shapeton::FlatDistortion similar = DistortionOf(Plane(), 5.0 * turn);
  EXPECT_LT((similar.dilatation.array() - 1.0).abs().maxCoeff(), 1e-6);
  EXPECT_LT((similar.areaScale.array() - 25.0).abs().maxCoeff(), 1e-9);
}

TEST(FlatDistortion, ReflectionIsClockwiseWithoutFlips)
{
  Eigen::Matrix2d mirror;
  mirror << 1.0, 0.0, 0.0, -1.0;
  const shapeton::FlatDistortion distortion = DistortionOf(Plane(), mirror);
  EXPECT_TRUE(distortion.isClockwise);
  EXPECT_EQ(0, distortion.flips);
}

TEST(FlatDistortion, CountsFlippedFaces)
{
  const shapeton::SurfaceMesh mesh = Square(5, 5.0);
  Eigen::MatrixX2d            uv = mesh.V.leftCols<2>();
  const int                   vertex = 14; // at (2, 2); moved into another face
  uv.row(vertex) << 4.4, 4.6;
  const shapeton::FlatDistortion distortion =
    shapeton::MeasureFlatDistortion(mesh.F, uv, shapeton::SidesOfFaces(mesh.V, mesh.F));
  EXPECT_EQ(std::accumulate(distortion.isFlipped.begin(), distortion.isFlipped.end(), 0), distortion.flips);
  EXPECT_GT(distortion.flips, 0);
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    const bool touches = (mesh.F.row(f).array() == vertex).any();
    EXPECT_TRUE(touches || !distortion.isFlipped[f]);
  }
  EXPECT_EQ(mesh.NumberOfFaces() - distortion.flips, shapeton::QuantilesOfDilatation(distortion).number);
  EXPECT_EQ(0, shapeton::QuantilesOfDilatation(distortion, std::vector<char>(mesh.NumberOfFaces(), 1)).number);
}

TEST(FlatDistortion, FacesWithoutAreaAreFlippedAndInfinite)
{
  const shapeton::SurfaceMesh mesh = Square(2, 2.0);
  Eigen::MatrixX2d            uv = mesh.V.leftCols<2>();
  uv.row(mesh.F(0, 0)) = uv.row(mesh.F(0, 1));
  const shapeton::FlatDistortion distortion =
    shapeton::MeasureFlatDistortion(mesh.F, uv, shapeton::SidesOfFaces(mesh.V, mesh.F));
  EXPECT_TRUE(distortion.isFlipped[0]);
  EXPECT_TRUE(std::isinf(distortion.dilatation[0]));
}

TEST(FlatDistortion, SidesOfEdgesAreThoseInSpace)
{
  const shapeton::SurfaceMesh         mesh = Icosphere(2, 10.0);
  const shapeton::SurfaceConnectivity connectivity(mesh);
  EXPECT_EQ(shapeton::SidesOfFaces(mesh.V, mesh.F),
            shapeton::SidesOfFaces(connectivity, shapeton::EdgeLengths(connectivity, mesh.V)));
  EXPECT_THROW(shapeton::SidesOfFaces(connectivity, Eigen::VectorXd::Ones(3)), shapeton::InputError);
}

TEST(FlatDistortion, QuantilesAreThoseOfSortedValues)
{
  shapeton::FlatDistortion distortion;
  distortion.dilatation = Eigen::VectorXd::LinSpaced(101, 200.0, 100.0);
  distortion.isFlipped.assign(101, 0);
  const shapeton::DistortionQuantiles quantiles = shapeton::QuantilesOfDilatation(distortion);
  EXPECT_DOUBLE_EQ(150.0, quantiles.median);
  EXPECT_DOUBLE_EQ(195.0, quantiles.p95);
  EXPECT_DOUBLE_EQ(199.0, quantiles.p99);
}

TEST(FlatDistortion, QualityOfKnownTriangles)
{
  shapeton::SideLengths sides(4, 3);
  sides << 2.0, 2.0, 2.0, 3.0, 4.0, 5.0, 1.0, 1.0, 2.0, 1.0, 1.0, 3.0;
  const Eigen::VectorXd quality = shapeton::TriangleQualities(sides);
  EXPECT_NEAR(1.0, quality[0], 1e-15);
  EXPECT_NEAR(0.8, quality[1], 1e-15); // r = 1, R = 2.5
  EXPECT_EQ(0.0, quality[2]);
  EXPECT_EQ(0.0, quality[3]);
  const shapeton::TriangleQuality summary = shapeton::MeasureTriangleQuality(sides, 10);
  EXPECT_EQ((std::vector<int>{ 2, 0, 0, 0, 0, 0, 0, 0, 1, 1 }), summary.histogram);
  EXPECT_NEAR(0.5, summary.shareBelowThreshold, 1e-15);
  EXPECT_NEAR(0.45, summary.mean, 1e-15);
  EXPECT_THROW(shapeton::MeasureTriangleQuality(sides, 0), shapeton::InputError);
}
