#include "shapetonConformalTube.h"

#include "shapetonColonTube.h"
#include "shapetonFlatDistortion.h"
#include "shapetonHeatDiffusionMetric.h"
#include "shapetonSurfaceHandles.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
using namespace testsurfaces;

/** A tube with its map and distortion, in the Euclidean metric by default. */
struct Flattened
{
  explicit Flattened(const shapeton::SurfaceMesh & surface, const shapeton::TubeOptions & options = {})
    : mesh(surface), connectivity(mesh), lengths(shapeton::EdgeLengths(connectivity, mesh.V))
  {
    this->Map(options);
  }
  void
  Map(const shapeton::TubeOptions & options)
  {
    const shapeton::TubeEnds ends = shapeton::FindTubeEnds(mesh, connectivity, "the surface");
    map = shapeton::FlattenTube(mesh, connectivity, lengths, ends, options);
    uv = shapeton::FlatCoordinates(map.flat, "the map");
    distortion = shapeton::MeasureFlatDistortion(map.flat.F, uv, shapeton::SidesOfFaces(connectivity, lengths));
  }

  shapeton::SurfaceMesh         mesh;
  shapeton::SurfaceConnectivity connectivity;
  Eigen::VectorXd               lengths;
  shapeton::TubeMap             map;
  Eigen::MatrixX2d              uv;
  shapeton::FlatDistortion      distortion;
};

ColonTubeOptions
SmallColon(int handles = 0)
{
  return { 6000, handles, 1, 750.0 };
}

shapeton::SurfaceMesh
Cone(int around, int along, double r0, double r1, double height)
{
  // Steps grow with the radius, so that triangles are similar.
  return Grid(around, along, Wrap::Around, [=](double s, double t) {
    const double r = r0 * std::pow(r1 / r0, t);
    const double z = height * (r - r0) / (r1 - r0);
    return Eigen::Vector3d(r * std::cos(2 * Pi * s), r * std::sin(2 * Pi * s), z);
  });
}

std::set<int>
VerticesOfHandles(const ColonTube & tube)
{
  std::set<int> vertices;
  for (const auto & handle : tube.handles)
  {
    vertices.insert(handle.begin(), handle.end());
  }
  return vertices;
}
} // namespace

TEST(ConformalTube, CylinderIsUnrolled)
{
  constexpr int   around = 24;
  const double    radius = 20.0;
  const Flattened flat(Cylinder(around, 40, radius, 100.0));
  const double    circumference = around * 2.0 * radius * std::sin(Pi / around);
  EXPECT_NEAR(circumference, flat.map.circumference, 1e-9);
  EXPECT_NEAR(100.0, flat.map.length, 1e-9);
  EXPECT_NEAR(circumference / 100.0, flat.map.modulusU, 1e-12);
  EXPECT_NEAR(circumference / 100.0, flat.map.modulusV, 1e-12);
  EXPECT_EQ(flat.map.circumference, shapeton::FlatCircumference(flat.map.flat, "it"));
  EXPECT_EQ(flat.map.length, shapeton::FlatLength(flat.map.flat, "it"));
  // An isometry, since a cylinder of planes is developable.
  EXPECT_LT((flat.distortion.dilatation.array() - 1.0).abs().maxCoeff(), 1e-5);
  EXPECT_LT((flat.distortion.areaScale.array() - 1.0).abs().maxCoeff(), 1e-9);
  EXPECT_EQ(0, flat.distortion.flips);
  EXPECT_EQ(0, flat.map.saddles);
  for (int v = 0; v < flat.mesh.NumberOfVertices(); ++v)
  {
    EXPECT_NEAR(flat.mesh.V(v, 2), flat.uv(v, 0), 1e-9);
  }
}

TEST(ConformalTube, ConeHasItsModulus)
{
  // An unrolled cone is a ring sector with the angle 2 pi sin(alpha); its logarithm is the rectangle.
  const Flattened flat(Cone(96, 40, 10.0, 35.0, 60.0));
  const double    slant = std::hypot(25.0, 60.0);
  const double    truth = 2.0 * Pi * (25.0 / slant) / std::log(3.5);
  EXPECT_GT(flat.map.modulusU, truth * (1.0 - 1.5e-3)); // a pyramid with 96 sides approximates the cone
  EXPECT_NEAR(truth, flat.map.modulusU, 2e-3 * truth);
  EXPECT_NEAR(truth, flat.map.modulusV, 2e-3 * truth);
  EXPECT_GE(flat.map.Gap(), -1e-9);
  EXPECT_LT(flat.map.Gap(), 1e-3);
  // Level sets are circles with uniformly distributed log radius.
  const Eigen::VectorXd levels = shapeton::LevelLengths(flat.mesh, flat.map.u, 10);
  EXPECT_NEAR(2.0 * Pi * 10.0 * std::pow(3.5, 0.05), levels[0], 0.2);
  EXPECT_NEAR(2.0 * Pi * 10.0 * std::pow(3.5, 0.95), levels[9], 0.7);
  EXPECT_NEAR(2.0 * Pi * 25.0 / std::log(3.5), flat.map.circumference, 0.2);
  EXPECT_NEAR(10.0, shapeton::NarrowestLevelRadius(flat.mesh, flat.map.u), 0.05);
}

TEST(ConformalTube, LevelsAtVerticesHaveTheirLengthOnce)
{
  const shapeton::SurfaceMesh mesh = Cylinder(24, 40, 20.0, 100.0);
  const double                level = 0.55;
  const double                circumference = 48.0 * 20.0 * std::sin(Pi / 24.0);
  for (const double value : { std::nextafter(level, 0.0), level, std::nextafter(level, 1.0) })
  {
    Eigen::VectorXd u = mesh.V.col(2) / 100.0;
    u = (u.array() - level).abs().matrix().unaryExpr([](double away) { return away < 1e-9; }).select(value, u);
    EXPECT_NEAR(shapeton::LevelLengths(mesh, u, 10)[5], circumference, 1e-9);
  }
}

TEST(ConformalTube, MapShowsTheViewFromInside)
{
  for (const int rectum : { 0, 24 * 41 - 1 })
  {
    shapeton::SurfaceMesh mesh = Cylinder(24, 40, 20.0, 100.0);
    mesh.fieldArrays.push_back({ "rectumLoop", shapeton::SurfaceArray::ValueMatrix::Constant(1, 1, rectum), true });
    const Flattened flat(mesh);
    EXPECT_TRUE(flat.distortion.isClockwise);
    for (const int f : { 0, 500, 1500 })
    {
      Eigen::Matrix2d             plane;
      Eigen::Matrix<double, 3, 2> space;
      const auto &                F = flat.map.flat.F;
      for (int k = 0; k < 2; ++k)
      {
        plane.col(k) = (flat.uv.row(F(f, k + 1)) - flat.uv.row(F(f, 0))).transpose();
        space.col(k) = (flat.map.flat.V.row(F(f, k + 1)) - flat.map.flat.V.row(F(f, 0))).transpose();
      }
      const Eigen::Matrix<double, 3, 2> axes = space * plane.inverse(); // right and up directions in space
      const Eigen::Vector3d             towardsViewer = axes.col(0).cross(axes.col(1));
      const Eigen::Vector3d             outwards(flat.map.flat.V(F(f, 0), 0), flat.map.flat.V(F(f, 0), 1), 0.0);
      EXPECT_LT(towardsViewer.dot(outwards), 0.0);
      EXPECT_EQ(rectum == 0, axes(2, 0) > 0.0);
    }
  }
}

TEST(ConformalTube, SeamIsOnePeriodApart)
{
  const Flattened flat(MakeColonTube(SmallColon(4)).mesh);
  const auto      source = shapeton::FlatSourcePoints(flat.map.flat, "it");
  int             pairs = 0;
  for (int i = flat.mesh.NumberOfVertices(); i < flat.map.flat.NumberOfVertices(); ++i)
  {
    ++pairs;
    EXPECT_EQ(flat.uv(i, 0), flat.uv(source[i], 0));
    EXPECT_NEAR(flat.map.circumference, std::abs(flat.uv(i, 1) - flat.uv(source[i], 1)), 1e-8);
  }
  EXPECT_EQ(static_cast<int>(flat.map.cutPath.size()), pairs);
  EXPECT_NEAR(0.0, flat.uv.col(0).minCoeff(), 1e-12);
  EXPECT_NEAR(flat.map.length, flat.uv.col(0).maxCoeff(), 1e-9);
  EXPECT_GT(flat.uv.col(1).minCoeff(), -0.3 * flat.map.circumference);
  EXPECT_LT(flat.uv.col(1).maxCoeff(), 1.3 * flat.map.circumference);
}

TEST(ConformalTube, ColonWithoutHandlesIsConformal)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const Flattened flat(MakeColonTube({ 12000, 0, seed }).mesh);
    EXPECT_EQ(0, flat.distortion.flips);
    EXPECT_GE(flat.map.Gap(), 0.0);
    EXPECT_LE(flat.map.Gap(), 0.003);
    const shapeton::DistortionQuantiles dilatation = shapeton::QuantilesOfDilatation(flat.distortion);
    EXPECT_LE(dilatation.median, 1.04);
    EXPECT_LE(dilatation.p95, 1.10);
    EXPECT_EQ(0, flat.map.saddles);
  }
}

TEST(ConformalTube, HandlesSpoilOnlyTheirNeighborhood)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const ColonTube         tube = MakeColonTube({ 12000, 10, seed });
    const Flattened         flat(tube.mesh);
    const std::set<int>     onHandles = VerticesOfHandles(tube);
    shapeton::SurfaceHandle handles;
    handles.vertices.assign(onHandles.begin(), onHandles.end());
    const std::vector<char> near = shapeton::FacesNearHandles(flat.connectivity, { handles }, 3);
    for (int f = 0; f < tube.mesh.NumberOfFaces(); ++f)
    {
      EXPECT_FALSE(flat.distortion.isFlipped[f] && !near[f]) << f;
    }
    EXPECT_TRUE(
      std::none_of(flat.map.cutPath.begin(), flat.map.cutPath.end(), [&](int v) { return onHandles.count(v) > 0; }));
    EXPECT_GE(flat.map.saddles, 20);
  }
}

TEST(ConformalTube, PublishedRouteAgreesOnACylinderAndFailsAtHandles)
{
  shapeton::TubeOptions published;
  published.conjugate = shapeton::TubeConjugate::Published;
  const Flattened cylinder(Cylinder(24, 40, 20.0, 100.0), published);
  EXPECT_NEAR(cylinder.map.modulusU, cylinder.map.modulusV, 1e-9);
  EXPECT_LT((cylinder.distortion.dilatation.array() - 1.0).abs().maxCoeff(), 1e-5);
  EXPECT_TRUE(cylinder.distortion.isClockwise);
  const ColonTube tube = MakeColonTube(SmallColon(6));
  EXPECT_GT(Flattened(tube.mesh, published).distortion.flips, 4 * Flattened(tube.mesh).distortion.flips);
}

TEST(ConformalTube, MapDoesNotDependOnPlaceScaleAndNumbering)
{
  const shapeton::SurfaceMesh mesh = MakeColonTube(SmallColon(3)).mesh;
  const Flattened             flat(mesh);
  shapeton::SurfaceMesh       moved = mesh;
  const Eigen::Matrix3d       turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const int                   last = mesh.NumberOfVertices() - 1;
  moved.V = 2.5 * (mesh.V.colwise().reverse() * turn.transpose());
  moved.V.rowwise() += Eigen::RowVector3d(5, 6, 7);
  moved.F = last - mesh.F.array();
  moved.fieldArrays.push_back({ "rectumLoop", shapeton::SurfaceArray::ValueMatrix::Constant(1, 1, last), true });
  const Flattened other(moved);
  EXPECT_NEAR(flat.map.modulusU, other.map.modulusU, 1e-10);
  EXPECT_NEAR(flat.map.modulusV, other.map.modulusV, 1e-10);
  EXPECT_NEAR(2.5 * flat.map.circumference, other.map.circumference, 1e-7);
  EXPECT_NEAR(2.5 * flat.map.length, other.map.length, 1e-7);
  // The offset of v depends on the cut; areas do not.
  EXPECT_LT((flat.distortion.areaScale - other.distortion.areaScale).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ConformalTube, OnlyRatiosOfTheMetricCount)
{
  Flattened              flat(MakeColonTube(SmallColon()).mesh);
  const Eigen::MatrixX2d before = flat.uv;
  flat.lengths *= 1e-4;
  flat.Map({});
  EXPECT_LT((flat.uv - before).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(ConformalTube, DiffusionMetricHidesHandles)
{
  const double time = 60.0;
  const auto   moduliOf = [&](int handles) {
    Flattened                   flat(MakeColonTube({ 12000, handles }).mesh);
    const std::array<double, 2> euclidean{ flat.map.modulusU, flat.map.modulusV };
    flat.lengths = shapeton::ComputeHeatDiffusionMetric(flat.mesh, time).edgeLengths;
    flat.Map({});
    return std::array<double, 4>{ euclidean[0], euclidean[1], flat.map.modulusU, flat.map.modulusV };
  };
  const auto none = moduliOf(0);
  const auto ten = moduliOf(10);
  EXPECT_LT(std::abs(ten[3] / none[3] - 1.0), std::abs(ten[1] / none[1] - 1.0));
}

TEST(ConformalTube, CutFollowsAGivenCurve)
{
  shapeton::SurfaceMesh mesh = Cylinder(36, 60, 20.0, 100.0);
  shapeton::TubeOptions options;
  for (double z = 5.0; z < 90.0; z += 10.0)
  {
    const double turn = 1.0 + 0.4 * std::sin(z / 15.0);
    options.cutCurve.emplace_back(20.3 * std::cos(turn), 20.3 * std::sin(turn), z);
  }
  const Flattened flat(mesh, options);
  for (const int v : flat.map.cutPath)
  {
    const double z = mesh.V(v, 2);
    const double turn = std::atan2(mesh.V(v, 1), mesh.V(v, 0));
    if (z > 6.0 && z < 84.0)
    {
      EXPECT_NEAR(1.0 + 0.4 * std::sin(z / 15.0), turn, 0.3);
    }
  }
  EXPECT_NEAR(100.0, flat.map.length, 1e-9);
  for (Eigen::Vector3d & point : options.cutCurve)
  {
    point.x() += 200.0;
  }
  EXPECT_THROW(Flattened(mesh, options), shapeton::InputError);
}

TEST(ConformalTube, ThreadsDoNotMatter)
{
  const shapeton::SurfaceMesh mesh = MakeColonTube(SmallColon(3)).mesh;
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const Flattened flattened(mesh);
      return std::make_pair(flattened.uv, flattened.map.flat.F);
    },
    { 4 });
}
