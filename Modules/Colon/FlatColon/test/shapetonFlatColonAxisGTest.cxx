#include "shapetonFlatColonAxis.h"

#include "shapetonFlatTestTubes.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
using namespace flattubes;
using shapeton::FlatColonGrid;

constexpr double bendRadius = 90.0;

shapeton::SurfaceMesh
BentTube(double radius)
{
  TubeForm form;
  form.cutSway = 1.2;
  return MakeBentTube(form, bendRadius, [radius](double, double) { return radius; });
}

Eigen::Vector3d
OnArc(double u)
{
  return { bendRadius * std::cos(u / bendRadius), 0.0, bendRadius * std::sin(u / bendRadius) };
}

shapeton::CurveSet
CurveOf(const std::vector<Eigen::Vector3d> & points)
{
  shapeton::CurveSet curve;
  curve.V.resize(points.size(), 3);
  curve.curves.emplace_back();
  AddArray(curve.pointArrays, "arcLength", static_cast<Eigen::Index>(points.size()), 1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    curve.V.row(i) = points[i];
    curve.curves[0].push_back(static_cast<int>(i));
    curve.pointArrays[0].values(i, 0) =
      i == 0 ? 0.0 : curve.pointArrays[0].values(i - 1, 0) + (points[i] - points[i - 1]).norm();
  }
  return curve;
}
} // namespace

TEST(FlatColonAxis, FollowsABentTube)
{
  const FlatColonGrid           grid(BentTube(18.0));
  const shapeton::FlatColonAxis axis = MakeFlatColonAxis(grid, 4.0);
  for (int column = 0; column < grid.Columns(); ++column)
  {
    const double          turn = (column + 0.5) / bendRadius;
    const Eigen::Vector3d tangent(-std::sin(turn), 0.0, std::cos(turn));
    // The outer side of the bend is longer and therefore has more weight, which shifts the center by r^2 / 4R = 0.9 mm.
    ASSERT_LT((axis.centers.row(column).transpose() - OnArc(column + 0.5)).norm(), 1.0);
    ASSERT_NEAR(axis.radii[column], 18.0, 0.3);
    if (column > 8 && column < grid.Columns() - 8)
    {
      ASSERT_GT(axis.tangents.row(column).dot(tangent), 0.9995);
    }
  }
}

TEST(FlatColonAxis, FramesAreThoseOfAnEyeInside)
{
  const FlatColonGrid           grid(BentTube(18.0));
  const shapeton::FlatColonAxis axis = MakeFlatColonAxis(grid, 4.0);
  for (int i = 0; i < 1000; ++i)
  {
    const int                      column = 8 + (37 * i) % 130, row = (53 * i) % grid.Rows();
    const shapeton::FlatSample     sample = grid.SampleOfPixel(column, row);
    const shapeton::FlatColonFrame frame = FrameAt(axis, column, sample.point);
    ASSERT_NEAR(frame.right.dot(frame.down), 0.0, 1e-12);
    ASSERT_NEAR(frame.right.dot(frame.towards), 0.0, 1e-12);
    ASSERT_NEAR(frame.right.cross(frame.down).dot(frame.towards), -1.0, 1e-12);
    ASSERT_GT(frame.towards.dot(sample.inwardNormal), 0.995);
    const Eigen::Vector3d next = grid.PointOfPixel(column, row + 1) - sample.point;
    ASSERT_GT(frame.down.dot(next.normalized()), 0.99) << "rows are downward";
    const Eigen::Vector3d beside = grid.PointOfPixel(column + 1, row) - sample.point;
    ASSERT_GT(frame.right.dot(beside.normalized()), 0.99);
  }
}

TEST(FlatColonAxis, DistanceOfTheSurfaceNeverFalls)
{
  shapeton::SurfaceMesh mesh = BentTube(18.0);
  auto &                arcLength = mesh.pointArrays[2].values;
  for (Eigen::Index i = 0; i < arcLength.rows(); ++i)
  {
    arcLength(i, 0) += 6.0 * std::sin(0.3 * mesh.pointArrays[0].values(i, 0)); // locally decreasing
  }
  const std::vector<double> distances = DistanceOfColumns(FlatColonGrid(mesh));
  ASSERT_EQ(distances.size(), 150U);
  for (std::size_t i = 1; i < distances.size(); ++i)
  {
    ASSERT_GE(distances[i], distances[i - 1]);
    ASSERT_NEAR(distances[i], 10.0 + i + 0.5, 6.5);
  }
  mesh.pointArrays.pop_back();
  EXPECT_TRUE(DistanceOfColumns(FlatColonGrid(mesh)).empty());
}

TEST(FlatColonAxis, DistanceOfACenterline)
{
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 300; ++i)
  {
    points.push_back(OnArc(-20.0 + 0.7 * i)); // 20 mm before the tube begins
  }
  const FlatColonGrid       grid(BentTube(18.0));
  const std::vector<double> distances = DistanceOfColumns(MakeFlatColonAxis(grid, 4.0), CurveOf(points));
  ASSERT_EQ(distances.size(), 150U);
  for (int column = 0; column < 150; ++column)
  {
    ASSERT_NEAR(distances[column], 20.0 + column + 0.5, 1.0) << column;
  }
}

TEST(FlatColonAxis, TouchingLoopsDoNotMislead)
{
  // A hairpin with legs 2 mm apart.
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 100; ++i)
  {
    points.emplace_back(i, 0.0, 0.0);
  }
  for (int i = 100; i >= 0; --i)
  {
    points.emplace_back(i, 2.0, 0.0);
  }
  shapeton::FlatColonAxis axis;
  axis.centers.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    axis.centers.row(i) = points[i] + Eigen::Vector3d(0.0, i < 101 ? 1.1 : -1.1, 0.0); // nearer to the other leg
  }
  const std::vector<double> distances = DistanceOfColumns(axis, CurveOf(points));
  for (std::size_t i = 1; i < distances.size(); ++i)
  {
    ASSERT_GE(distances[i], distances[i - 1]);
  }
  EXPECT_NEAR(distances[50], 50.0, 1e-9);
  EXPECT_NEAR(distances[151], 152.0, 1e-9);
}

TEST(FlatColonAxis, RefusesACenterlineWithoutDistances)
{
  shapeton::CurveSet curve = CurveOf({ OnArc(0.0), OnArc(100.0) });
  curve.pointArrays.clear();
  const FlatColonGrid grid(BentTube(18.0));
  EXPECT_THROW(DistanceOfColumns(MakeFlatColonAxis(grid), curve), shapeton::InputError);
}
