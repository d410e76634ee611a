#include "shapetonColonAnatomy.h"
#include "shapetonSurfaceConnectivity.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using Eigen::Vector3d;

namespace
{
shapeton::ColonPhantomParameters
Patient(const std::string & preset, unsigned seed, int diverticula, const std::string & position = "supine")
{
  auto parameters = shapeton::ColonPhantomPreset(preset);
  parameters.seed = seed;
  parameters.diverticula = diverticula;
  parameters.position = position;
  return parameters;
}

// Distance to the nearest segment of a set of curves.
double
DistanceToCurves(const shapeton::CurveSet & curves, const Vector3d & point)
{
  double least = 1e9;
  for (const auto & curve : curves.curves)
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      const Vector3d a = curves.V.row(curve[i - 1]);
      const Vector3d b = curves.V.row(curve[i]);
      const double   t = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (point - a - t * (b - a)).norm());
    }
  }
  return least;
}
} // namespace

TEST(ColonDiverticula, SacIsABallAndNeckATubeOfTheirSizes)
{
  const shapeton::ColonAnatomy anatomy(Patient("standard", 1, 20));
  ASSERT_GE(anatomy.Diverticula().size(), 10U);
  for (const shapeton::ColonDiverticulum & one : anatomy.Diverticula())
  {
    const auto     distanceAt = [&](const Vector3d & p) { return anatomy.Evaluate(p).distance; };
    const double   radius = 0.5 * one.diameter;
    const Vector3d axis = (one.position - one.mouth).normalized();
    const Vector3d side = axis.unitOrthogonal();
    for (int i = 0; i < 24; ++i)
    {
      // The half of the sac opposite the neck.
      const Vector3d off = Eigen::AngleAxisd(i, axis) * (std::cos(0.06 * i) * axis + std::sin(0.06 * i) * side);
      EXPECT_NEAR(distanceAt(one.position + (radius + 0.3) * off), -0.3, 0.01) << one.id;
      EXPECT_NEAR(distanceAt(one.position + (radius - 0.2) * off), 0.2, 0.05) << one.id;
    }
    const double   length = (one.position - one.mouth).norm() - radius;
    const Vector3d middle = one.mouth + 0.5 * length * axis;
    for (int i = 0; i < 6; ++i)
    {
      const Vector3d off = Eigen::AngleAxisd(i, axis) * side;
      EXPECT_GT(distanceAt(middle + (0.5 * one.neck - 0.1) * off), 0.0) << one.id;
      EXPECT_LT(distanceAt(middle + (0.5 * one.neck + 0.3) * off), 0.0) << one.id;
    }
    // Connected lumen from the sac through the mouth.
    for (double way = -2.0; way < length + radius; way += 0.2)
    {
      EXPECT_GT(distanceAt(one.mouth + way * axis), 0.0) << one.id;
    }
    EXPECT_GE(one.diameter, 3.0);
    EXPECT_LE(one.diameter, 10.0);
    EXPECT_GE(one.neck, 1.5);
    EXPECT_LE(one.neck, 4.0);
    EXPECT_EQ(anatomy.Evaluate(one.position).segment, one.segment);
    EXPECT_NEAR(anatomy.Evaluate(one.position).arcLength, one.arcLength, 1e-9);
  }
}

TEST(ColonDiverticula, StandOutsideOfTheWallBesideATaenia)
{
  const shapeton::ColonAnatomy without(Patient("realistic", 2, 0)), with(Patient("realistic", 2, 30));
  const shapeton::CurveSet     taeniae = without.Taeniae();
  std::map<int, int>           segments;
  EXPECT_TRUE(without.Diverticula().empty());
  EXPECT_EQ(without.Folds().V, with.Folds().V);
  EXPECT_EQ(without.Centerline().V, with.Centerline().V);
  for (const shapeton::ColonDiverticulum & one : with.Diverticula())
  {
    ++segments[one.segment];
    EXPECT_NEAR(without.Evaluate(one.mouth).distance, 0.0, 0.02) << one.id;
    EXPECT_LT(without.Evaluate(one.position).distance, -0.5 * one.diameter) << one.id;
    const double beside = DistanceToCurves(taeniae, one.mouth);
    EXPECT_GT(beside, 3.0) << one.id;
    EXPECT_LT(beside, 12.0) << one.id;
    for (const shapeton::ColonDiverticulum & other : with.Diverticula())
    {
      const double room = 0.5 * (one.diameter + other.diameter) + 2.5;
      EXPECT_TRUE(one.id == other.id || (one.position - other.position).norm() > room) << one.id << ' ' << other.id;
    }
  }
  const int all = static_cast<int>(with.Diverticula().size());
  EXPECT_GE(all, 15);
  EXPECT_EQ(segments[1] + segments[6], 0);
  EXPECT_GT(segments[2] + segments[3], 0.5 * all);
}

TEST(ColonDiverticula, AreThePatients)
{
  const shapeton::ColonAnatomy               supine(Patient("realistic", 3, 25));
  const shapeton::ColonAnatomy               prone(Patient("realistic", 3, 25, "prone"));
  std::map<int, shapeton::ColonDiverticulum> first;
  int                                        both = 0;
  for (const shapeton::ColonDiverticulum & one : supine.Diverticula())
  {
    first.emplace(one.id, one);
  }
  for (const shapeton::ColonDiverticulum & one : prone.Diverticula())
  {
    const auto found = first.find(one.id);
    if (found != first.end())
    {
      ++both;
      EXPECT_EQ(found->second.materialId, one.materialId);
      EXPECT_EQ(found->second.neck, one.neck);
      EXPECT_EQ(found->second.segment, one.segment);
      EXPECT_EQ(found->second.intensity, one.intensity);
      EXPECT_NEAR(found->second.arcLength / one.arcLength, 1.0, 0.1);
    }
  }
  EXPECT_GT(both, 0.6 * static_cast<double>(first.size()));
}

TEST(ColonDiverticula, MoreOfThemMoveNone)
{
  const auto few = shapeton::ColonAnatomy(Patient("standard", 4, 5)).Diverticula();
  const auto many = shapeton::ColonAnatomy(Patient("standard", 4, 20)).Diverticula();
  ASSERT_GE(few.size(), 2U);
  ASSERT_GT(many.size(), few.size());
  for (std::size_t i = 0; i < few.size(); ++i)
  {
    EXPECT_EQ(few[i].id, many[i].id);
    EXPECT_EQ(few[i].position, many[i].position);
  }
}

TEST(ColonDiverticula, SixOfTenPatientsHaveNone)
{
  constexpr int patients = 2000;
  int           none = 0;
  for (unsigned seed = 0; seed < patients; ++seed)
  {
    const int count = shapeton::Drawn(Patient("realistic", seed, static_cast<int>(shapeton::drawnBySeed))).diverticula;
    none += count == 0 ? 1 : 0;
    EXPECT_TRUE(count == 0 || (count >= 3 && count <= 25)) << count;
  }
  EXPECT_NEAR(none, 0.6 * patients, 80);
}

// The cecum of this patient is folded back.
TEST(ColonDiverticula, WallStaysATube)
{
  const shapeton::ColonAnatomy anatomy(Patient("realistic", 7, 25));
  EXPECT_GE(anatomy.Diverticula().size(), 10U);
  const shapeton::SurfaceConnectivity connectivity(anatomy.Wall(0.7));
  ASSERT_EQ(connectivity.Components().size(), 1U);
  EXPECT_EQ(connectivity.Components()[0].genus, 0);
}
