#include "shapetonColonTaeniae.h"

#include "shapetonLandmarkTubes.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

using shapeton::ColonTaeniae;
using shapeton::ColonWallTube;
using shapeton::FindColonTaeniae;
using shapeton::FlatColon;
using shapeton::TaeniaRule;

namespace
{
constexpr double length = 480.0;

struct Tube
{
  FlatColon     flat{ landmarktubes::TubeWithTaeniae() };
  ColonWallTube tube{ flat, landmarktubes::StraightLine(length) };
};

/** Circumferential distance (mm) from a point of a taenia to the nearest true taenia. */
double
ErrorAt(const Eigen::Vector3d & point)
{
  const double angle = std::atan2(point.y(), point.x());
  double       least = 1e9;
  for (int t = 0; t < 3; ++t)
  {
    const double off = std::remainder(angle + landmarktubes::TaeniaAngle(t, point.z()), 2.0 * landmarktubes::pi);
    least = std::min(least, foldtubes::radius * std::abs(off));
  }
  return least;
}

double
GreatestErrorWithin(const ColonTaeniae & taeniae, double begin, double end)
{
  double greatest = 0.0;
  for (const shapeton::ColonTaenia & taenia : taeniae.taeniae)
  {
    for (const Eigen::Vector3d & point : taenia.points)
    {
      greatest = point.z() > begin && point.z() < end ? std::max(greatest, ErrorAt(point)) : greatest;
    }
  }
  return greatest;
}
} // namespace

TEST(ColonTaeniae, RunWhereFoldsEnd)
{
  const Tube         t;
  const ColonTaeniae found = FindColonTaeniae(t.flat, t.tube);
  ASSERT_EQ(found.taeniae.size(), 3u) << found.reason;
  EXPECT_LT(GreatestErrorWithin(found, 40.0, 440.0), 5.0);
  for (const shapeton::ColonTaenia & taenia : found.taeniae)
  {
    ASSERT_EQ(taenia.points.size(), taenia.uv.size());
    EXPECT_GT(taenia.points.back().z() - taenia.points.front().z(), 0.97 * length);
    EXPECT_TRUE(std::is_sorted(taenia.arcLength.begin(), taenia.arcLength.end()));
    for (const double confidence : taenia.confidence)
    {
      ASSERT_GE(confidence, 0.0);
      ASSERT_LE(confidence, 1.0);
    }
  }
  EXPECT_LT(found.disagreeingShare, 0.1);
  const std::size_t middle = found.taeniae[0].points.size() / 2;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d & next = found.taeniae[(k + 1) % 3].points[middle];
    EXPECT_GT((found.taeniae[k].points[middle] - next).norm(), foldtubes::radius) << "three different ones";
  }
}

// The tracks are 50, 92 and 218 degrees apart in the middle and must not be confused.
TEST(ColonTaeniae, StayThemselvesWhereTwoComeNear)
{
  const double        nearer = 70.0 * landmarktubes::pi / 180.0;
  const FlatColon     flat(landmarktubes::TubeWithTaeniae(length, 0.0, nearer));
  const ColonWallTube tube(flat, landmarktubes::StraightLine(length));
  const ColonTaeniae  found = FindColonTaeniae(flat, tube);
  ASSERT_EQ(found.taeniae.size(), 3u) << found.reason;
  const auto farthest = [&](const shapeton::ColonTaenia & taenia, int truth) {
    double greatest = 0.0;
    for (const Eigen::Vector3d & point : taenia.points)
    {
      const double angle = std::atan2(point.y(), point.x()) + landmarktubes::TaeniaAngle(truth, point.z(), nearer);
      const double off = foldtubes::radius * std::abs(std::remainder(angle, 2.0 * landmarktubes::pi));
      greatest = point.z() > 40.0 && point.z() < 440.0 ? std::max(greatest, off) : greatest;
    }
    return greatest;
  };
  for (const shapeton::ColonTaenia & taenia : found.taeniae)
  {
    EXPECT_LT(std::min({ farthest(taenia, 0), farthest(taenia, 1), farthest(taenia, 2) }), 6.0);
  }
}

TEST(ColonTaeniae, OfThePublishedRuleAreAThirdApart)
{
  const Tube                   t;
  shapeton::ColonTaeniaOptions options;
  options.rule = TaeniaRule::Published;
  const ColonTaeniae found = FindColonTaeniae(t.flat, t.tube, options);
  ASSERT_EQ(found.taeniae.size(), 3u);
  EXPECT_EQ(found.kept, "thirds");
  for (std::size_t i = 0; i < found.taeniae[0].uv.size(); i += 10)
  {
    const double apart = found.taeniae[1].uv[i].y() - found.taeniae[0].uv[i].y();
    EXPECT_NEAR(std::abs(std::remainder(apart, t.tube.Circumference())), t.tube.Circumference() / 3.0, 2.1);
  }
}

TEST(ColonTaeniae, PassThroughMarkers)
{
  const Tube                   t;
  shapeton::ColonTaeniaOptions options;
  options.markers = { landmarktubes::PointOfTaenia(0, 200.0, 9.0), landmarktubes::PointOfTaenia(1, 330.0) };
  const ColonTaeniae found = FindColonTaeniae(t.flat, t.tube, options);
  ASSERT_EQ(found.markers.size(), 2u);
  for (const shapeton::UsedMarker & marker : found.markers)
  {
    ASSERT_GE(marker.taenia, 1);
    ASSERT_LE(marker.taenia, 3);
    EXPECT_LT(marker.distanceOfTaenia, 0.5);
    EXPECT_LT(marker.distanceFromWall, 7.0);
    double least = 1e9;
    for (const Eigen::Vector3d & point : found.taeniae[marker.taenia - 1].points)
    {
      least = std::min(least, (point - marker.point).norm());
    }
    EXPECT_LT(least, marker.distanceFromWall + 0.5);
  }
  EXPECT_NE(found.markers[0].taenia, found.markers[1].taenia);
  EXPECT_LT(GreatestErrorWithin(found, 300.0, 440.0), 5.0);
}

// The markers are a sixth of a turn from the true taeniae, against all evidence.
TEST(ColonTaeniae, GoWhereverEnoughMarkersTell)
{
  constexpr double             sixth = landmarktubes::pi / 3.0 * foldtubes::radius; // mm
  constexpr double             step = 20.0;
  const Tube                   t;
  shapeton::ColonTaeniaOptions options;
  for (int taenia = 0; taenia < 3; ++taenia)
  {
    for (double u = step; u < length; u += step)
    {
      options.markers.push_back(landmarktubes::PointOfTaenia(taenia, u, sixth));
    }
  }
  const ColonTaeniae found = FindColonTaeniae(t.flat, t.tube, options);
  ASSERT_EQ(found.taeniae.size(), 3u);
  for (const shapeton::UsedMarker & marker : found.markers)
  {
    EXPECT_LT(marker.distanceOfTaenia, 0.5);
  }
  for (const shapeton::ColonTaenia & taenia : found.taeniae)
  {
    for (const Eigen::Vector3d & point : taenia.points)
    {
      if (point.z() > step && point.z() < length - step)
      {
        EXPECT_GT(ErrorAt(point), sixth - 10.0) << "at " << point.z() << " mm";
      }
    }
  }
}

TEST(ColonTaeniae, TellOfMarkersThatContradictEachOther)
{
  const Tube                   t;
  shapeton::ColonTaeniaOptions options;
  options.markers = { landmarktubes::PointOfTaenia(0, 200.0), landmarktubes::PointOfTaenia(0, 200.0, 8.0) };
  const ColonTaeniae found = FindColonTaeniae(t.flat, t.tube, options);
  ASSERT_EQ(found.markers.size(), 2u);
  EXPECT_EQ(found.markers[0].taenia, found.markers[1].taenia);
  EXPECT_LT(found.markers[0].distanceOfTaenia, 0.5);
  EXPECT_GT(found.markers[1].distanceOfTaenia, 5.0);
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings.back().find("marker 2"), std::string::npos) << found.warnings.back();
}

TEST(ColonTaeniae, RunOnBetweenBulgesWhereThereAreNoFolds)
{
  const FlatColon    flat(landmarktubes::TubeWithTaeniae(240.0, 3.0));
  const ColonTaeniae found = FindColonTaeniae(flat, ColonWallTube(flat, landmarktubes::StraightLine(length)));
  ASSERT_EQ(found.taeniae.size(), 3u) << found.reason;
  EXPECT_LT(GreatestErrorWithin(found, 40.0, 440.0), 5.0);
}

TEST(ColonTaeniae, RefuseAMarkerFarFromTheWall)
{
  const Tube                   t;
  shapeton::ColonTaeniaOptions options;
  options.markers = { Eigen::Vector3d(0.0, 90.0, 200.0) };
  EXPECT_THROW(FindColonTaeniae(t.flat, t.tube, options), shapeton::InputError);
}

TEST(ColonTaeniae, AreAbsentWhereThereAreNoFolds)
{
  flattubes::TubeForm form;
  const FlatColon     flat(flattubes::MakeCylinder(form));
  const ColonTaeniae  found = FindColonTaeniae(flat, ColonWallTube(flat, landmarktubes::StraightLine(form.length)));
  EXPECT_TRUE(found.taeniae.empty());
  EXPECT_NE(found.reason.find("too few"), std::string::npos);
  EXPECT_FALSE(found.warnings.empty());
}

TEST(ColonTaeniae, AsCurvesHaveTheirArrays)
{
  const Tube               t;
  const shapeton::CurveSet curves = TaeniaCurves(FindColonTaeniae(t.flat, t.tube));
  ASSERT_EQ(curves.curves.size(), 3u);
  EXPECT_NE(shapeton::FindSurfaceArray(curves.cellArrays, "taenia"), nullptr);
  for (const char * name : { "arcLength", "uv", "confidence" })
  {
    ASSERT_NE(shapeton::FindSurfaceArray(curves.pointArrays, name), nullptr) << name;
  }
  EXPECT_EQ(shapeton::FindSurfaceArray(curves.pointArrays, "uv")->values.cols(), 2);
}
