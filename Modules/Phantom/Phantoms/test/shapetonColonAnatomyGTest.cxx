#include "shapetonColonAnatomy.h"
#include "shapetonColonPointPairs.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonSurfaceQuality.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using Eigen::Vector3d;

namespace
{
shapeton::ColonPhantomParameters
Patient(unsigned seed, const std::string & position = "supine")
{
  shapeton::ColonPhantomParameters parameters = shapeton::ColonPhantomPreset("standard");
  parameters.seed = seed;
  parameters.position = position;
  return parameters;
}

std::vector<double>
Column(const std::vector<shapeton::SurfaceArray> & arrays, const std::string & name)
{
  const shapeton::SurfaceArray * array = shapeton::FindSurfaceArray(arrays, name);
  std::vector<double>            values;
  for (Eigen::Index i = 0; array && i < array->values.rows(); ++i)
  {
    values.push_back(array->values(i, 0));
  }
  return values;
}

double
Quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * values.size()))];
}

// Uniformly distributed directions.
std::vector<Vector3d>
Directions(int number)
{
  std::vector<Vector3d> directions;
  for (int i = 0; i < number; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / number;
    const double angle = i * shapeton::Pi * (3 - std::sqrt(5.0));
    directions.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  return directions;
}

// Points within 1.5 mm of the wall along the whole colon.
std::vector<Vector3d>
PointsNearWall(const shapeton::ColonAnatomy & anatomy)
{
  const shapeton::CurveSet    wall = anatomy.Correspondence();
  const std::vector<Vector3d> directions = Directions(23);
  std::vector<Vector3d>       points;
  for (Eigen::Index i = 0; i < wall.V.rows(); i += 29)
  {
    points.push_back(wall.V.row(i).transpose() + (0.1 * (i % 14)) * directions[i % directions.size()]);
  }
  return points;
}

// The nearest change of sign along many rays.
double
NearestWall(const shapeton::ColonAnatomy & anatomy, const Vector3d & point, const std::vector<Vector3d> & directions)
{
  const bool isInside = anatomy.Evaluate(point).distance > 0;
  double     nearest = 4.0;
  for (const Vector3d & direction : directions)
  {
    for (double r = 0.05; r < nearest; r += 0.05)
    {
      if ((anatomy.Evaluate(point + r * direction).distance > 0) != isInside)
      {
        nearest = r - 0.025;
      }
    }
  }
  return nearest;
}
} // namespace

TEST(ColonAnatomy, BuildIsThatOfAColon)
{
  std::vector<double> radii, heights;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const shapeton::ColonAnatomy anatomy(Patient(seed));
    EXPECT_GT(anatomy.Length(), 1400.0);
    EXPECT_LT(anatomy.Length(), 2000.0);
    Vector3d low, high;
    anatomy.BoundingBox(10.0, low, high);
    EXPECT_GT(low.minCoeff(), -175.0);
    EXPECT_LT(high.maxCoeff(), 175.0);
    const auto radius = Column(anatomy.Centerline().pointArrays, "radius");
    const auto height = Column(anatomy.Folds().cellArrays, "height");
    radii.insert(radii.end(), radius.begin(), radius.end());
    heights.insert(heights.end(), height.begin(), height.end());
  }
  // Measured on real colons: 8, 14, 19, 22, 25 mm, and folds of 3.5, 6.6, 11.4 mm.
  EXPECT_NEAR(Quantile(radii, 0.05), 8.0, 3.5);
  EXPECT_NEAR(Quantile(radii, 0.25), 14.0, 1.5);
  EXPECT_NEAR(Quantile(radii, 0.50), 19.0, 1.5);
  EXPECT_NEAR(Quantile(radii, 0.75), 22.0, 2.0);
  EXPECT_NEAR(Quantile(radii, 0.95), 25.0, 3.5);
  EXPECT_NEAR(Quantile(heights, 0.25), 3.5, 0.8);
  EXPECT_NEAR(Quantile(heights, 0.50), 6.6, 1.0);
  EXPECT_NEAR(Quantile(heights, 0.75), 11.4, 2.0);
}

TEST(ColonAnatomy, SegmentsFollowInOrder)
{
  const shapeton::ColonAnatomy anatomy(Patient(2));
  int                          before = 1;
  for (double s = 0; s <= anatomy.Length(); s += 5)
  {
    const int segment = anatomy.SegmentAt(s);
    EXPECT_TRUE(segment == before || segment == before + 1);
    before = segment;
  }
  EXPECT_EQ(before, 6);
  EXPECT_EQ(shapeton::ColonAnatomy::SegmentName(6), "cecum");
}

/** In both positions, within torsion and drift; the valve stays medial. */
TEST(ColonAnatomy, AnatomicalTaeniaeAreWhereTheirNamesSay)
{
  for (const char * const position : { "supine", "prone" })
  {
    shapeton::ColonPhantomParameters parameters = shapeton::ColonPhantomPreset("realistic");
    parameters.seed = 3;
    parameters.position = position;
    parameters.anatomicalTaeniae = true;
    const shapeton::ColonAnatomy anatomy(parameters);
    const shapeton::CurveSet     taeniae = anatomy.Taeniae();
    const shapeton::CurveSet     line = anatomy.Centerline();
    const Eigen::VectorXd        segment = PointValues(line, "segment", "the truth");
    const auto &                 names = FindSurfaceArray(taeniae.cellArrays, "name")->values;
    ASSERT_EQ(names(0, 0), 1.0);
    ASSERT_EQ(names(1, 0), 3.0);
    ASSERT_EQ(names(2, 0), 2.0);
    std::array<double, 7> front{};
    std::array<double, 7> below{};
    for (const int vertex : taeniae.curves[0])
    {
      Eigen::Index nearest = 0;
      (line.V.rowwise() - taeniae.V.row(vertex)).rowwise().squaredNorm().minCoeff(&nearest);
      const Eigen::Vector3d way = (taeniae.V.row(vertex) - line.V.row(nearest)).transpose();
      front[static_cast<int>(segment[nearest])] -= way.y();
      below[static_cast<int>(segment[nearest])] -= way.z();
    }
    EXPECT_GT(front[3], 0.0) << position;
    EXPECT_GT(front[5], 0.0) << position;
    EXPECT_GT(below[4], 0.0) << position;
  }
}

TEST(ColonAnatomy, PairsOfPointsAreTheSameWallOutsideCollapse)
{
  shapeton::CurveSet a, b;
  a.V.resize(3, 3);
  a.V << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  b.V = 10.0 * a.V;
  a.curves = b.curves = { { 0 }, { 1 }, { 2 } };
  const auto arrays = [](double x, double y, double z, double collapsed) {
    shapeton::SurfaceArray material{ "materialId", shapeton::SurfaceArray::ValueMatrix(3, 1), true };
    shapeton::SurfaceArray collapse{ "collapsed", shapeton::SurfaceArray::ValueMatrix::Zero(3, 1), true };
    material.values << x, y, z;
    collapse.values(2, 0) = collapsed;
    return std::vector<shapeton::SurfaceArray>{ material, collapse };
  };
  a.pointArrays = arrays(7, 5, 9, 0);
  b.pointArrays = arrays(5, 7, 9, 1);
  const auto rows = shapeton::TableOfPointPairs(a, b).GetRows();
  ASSERT_EQ(rows.size(), 2U); // 9 is collapsed
  EXPECT_EQ(rows[0], (std::vector<std::string>{ "4", "5", "6", "10", "20", "30" }));
  EXPECT_EQ(rows[1], (std::vector<std::string>{ "1", "2", "3", "40", "50", "60" }));
  b.pointArrays = arrays(1, 2, 3, 0);
  EXPECT_THROW(shapeton::TableOfPointPairs(a, b), shapeton::InputError);
}

TEST(ColonAnatomy, PatientIsTheSameInTwoPositions)
{
  const shapeton::ColonAnatomy supine(Patient(3)), prone(Patient(3, "prone"));
  const shapeton::CurveSet     a = supine.Correspondence(), b = prone.Correspondence();
  ASSERT_EQ(a.V.rows(), b.V.rows());
  EXPECT_EQ(Column(a.pointArrays, "materialId"), Column(b.pointArrays, "materialId"));
  EXPECT_EQ(Column(a.pointArrays, "segment"), Column(b.pointArrays, "segment"));
  ASSERT_EQ(supine.Polyps().size(), prone.Polyps().size());
  for (std::size_t i = 0; i < supine.Polyps().size(); ++i)
  {
    EXPECT_EQ(supine.Polyps()[i].materialId, prone.Polyps()[i].materialId);
  }
  // The rectum is fixed, the transverse colon moves by a few centimeters, and the length hardly changes.
  const shapeton::CurveSet c = supine.Centerline(), d = prone.Centerline();
  const auto               segment = Column(c.pointArrays, "segment");
  double                   mostMoved = 0.0;
  for (Eigen::Index i = 0; i < c.V.rows(); ++i)
  {
    const double moved = (c.V.row(i) - d.V.row(i)).norm();
    mostMoved = segment[i] == 4 ? std::max(mostMoved, moved) : mostMoved;
    EXPECT_TRUE(i * 2 > 60 || moved < 5.0);
  }
  EXPECT_GT(mostMoved, 20.0);
  EXPECT_LT(mostMoved, 90.0);
  EXPECT_NEAR(supine.Length() / prone.Length(), 1.0, 0.08);
}

TEST(ColonAnatomy, PolypsMoveNoFolds)
{
  shapeton::ColonPhantomParameters none = Patient(4);
  none.polyps = 0;
  const shapeton::ColonAnatomy without(none), with(Patient(4));
  EXPECT_EQ(without.Folds().V, with.Folds().V);
  EXPECT_EQ(without.Polyps().size(), 0U);
  EXPECT_EQ(with.Polyps().size(), 8U);
}

TEST(ColonAnatomy, DistanceIsThatToTheNearestWall)
{
  const shapeton::ColonAnatomy anatomy(Patient(5));
  const std::vector<Vector3d>  directions = Directions(150);
  const std::vector<Vector3d>  points = PointsNearWall(anatomy);
  std::vector<double>          errors;
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    const double distance = std::abs(anatomy.Evaluate(points[i]).distance);
    if (distance > 0.1 && distance < 1.2)
    {
      errors.push_back(std::abs(distance - NearestWall(anatomy, points[i], directions)));
    }
  }
  ASSERT_GT(errors.size(), 50U);
  EXPECT_LT(Quantile(errors, 0.5), 0.05);
  EXPECT_LT(Quantile(errors, 0.9), 0.2);
}

TEST(ColonAnatomy, DistanceGrowsByOneNearTheWall)
{
  const shapeton::ColonAnatomy anatomy(Patient(5));
  int                          good = 0;
  int                          all = 0;
  for (const Vector3d & point : PointsNearWall(anatomy))
  {
    if (std::abs(anatomy.Evaluate(point).distance) < 0.5)
    {
      Vector3d gradient;
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vector3d step = 1e-3 * Vector3d::Unit(axis);
        gradient[axis] = (anatomy.Evaluate(point + step).distance - anatomy.Evaluate(point - step).distance) / 2e-3;
      }
      good += std::abs(gradient.norm() - 1.0) < 0.1 ? 1 : 0;
      ++all;
    }
  }
  ASSERT_GT(all, 100);
  EXPECT_GT(good, 0.85 * all);
}

class EachPreset : public testing::TestWithParam<const char *>
{};

INSTANTIATE_TEST_SUITE_P(ColonAnatomy, EachPreset, testing::Values("standard", "realistic"));

TEST_P(EachPreset, StretchesStayApart)
{
  auto parameters = shapeton::ColonPhantomPreset(GetParam());
  parameters.seed = 1;
  const shapeton::ColonAnatomy anatomy(parameters);
  const shapeton::CurveSet     line = anatomy.Centerline();
  const auto                   radius = Column(line.pointArrays, "radius");
  const auto                   arcLength = Column(line.pointArrays, "arcLength");
  int                          touching = 0;
  for (Eigen::Index i = 0; i < line.V.rows(); i += 2)
  {
    for (Eigen::Index j = i + 40; j < line.V.rows(); j += 2)
    {
      const Vector3d a = line.V.row(i), b = line.V.row(j);
      const double   across = (b - a).norm();
      if (arcLength[j] - arcLength[i] < 100 || across > radius[i] + radius[j] + 2)
      {
        continue;
      }
      // Maximum length outside the lumen on the line between two stretches.
      double longest = 0.0, stay = 0.0;
      for (double x = 0; x < across; x += 0.05)
      {
        stay = anatomy.Evaluate(a + (x / across) * (b - a)).distance < 0 ? stay + 0.05 : 0.0;
        longest = std::max(longest, stay);
      }
      EXPECT_GT(longest, 0.9);
      ++touching;
    }
  }
  EXPECT_GT(touching, 0);
}

TEST(ColonAnatomy, NoVoxelsOfTwoStretchesTouch)
{
  const shapeton::ColonAnatomy anatomy(Patient(1));
  const shapeton::CurveSet     line = anatomy.Centerline();
  const auto                   radius = Column(line.pointArrays, "radius");
  // Near the closest points of two stretches.
  Vector3d middle = Vector3d::Zero();
  double   least = 1e9;
  for (Eigen::Index i = 0; i < line.V.rows(); ++i)
  {
    for (Eigen::Index j = i + 60; j < line.V.rows(); ++j)
    {
      const double gap = (line.V.row(i) - line.V.row(j)).norm() - radius[i] - radius[j];
      if (gap < least)
      {
        least = gap;
        const double share = (radius[i] + 0.5 * gap) / (radius[i] + radius[j] + gap);
        middle = line.V.row(i) + share * (line.V.row(j) - line.V.row(i));
      }
    }
  }
  constexpr int       size = 48;
  std::vector<double> place(size * size * size, -1.0);
  for (int i = 0; i < size * size * size; ++i)
  {
    const Vector3d off(i % size, i / size % size, i / size / size);
    const auto     sample = anatomy.Evaluate(middle + 0.7 * (off - Vector3d::Constant(0.5 * size)));
    place[i] = sample.distance > 0 ? sample.arcLength : -1.0;
  }
  int first = 0, second = 0;
  for (int i = 0; i + size * size < size * size * size; ++i)
  {
    for (int stride : { 1, size, size * size })
    {
      const int next = i + stride;
      if (i / stride % size == size - 1)
      {
        continue;
      }
      EXPECT_FALSE(place[i] >= 0 && place[next] >= 0 && std::abs(place[i] - place[next]) > 40.0);
    }
    first += place[i] >= 0 ? 1 : 0;
    second += place[i] >= 0 && std::abs(place[i] - place[size * size * size / 2]) > 60.0 ? 1 : 0;
  }
  EXPECT_GT(first, 1000);
  EXPECT_GT(second, 100);
}

TEST(ColonAnatomy, WallIsClosedAndWhereTheDistanceIsNought)
{
  const shapeton::ColonAnatomy        anatomy(Patient(2));
  const shapeton::SurfaceMesh         wall = anatomy.Wall(3.0);
  const shapeton::SurfaceConnectivity connectivity(wall);
  int                                 off = 0;
  ASSERT_GT(wall.NumberOfFaces(), 10000);
  EXPECT_TRUE(connectivity.IsClosed());
  EXPECT_TRUE(connectivity.IsOriented());
  EXPECT_TRUE(shapeton::FindSurfaceDefects(wall, connectivity).degenerateFaces.empty());
  for (int i = 0; i < wall.NumberOfVertices(); ++i)
  {
    off += std::abs(anatomy.Evaluate(wall.V.row(i)).distance) > 0.02 ? 1 : 0;
  }
  EXPECT_LT(off, 0.001 * wall.NumberOfVertices());
  EXPECT_NEAR(shapeton::EnclosedVolume(wall.V, wall.F), 2.0e6, 0.6e6);
}

TEST(ColonAnatomy, SessilePolypHasItsVolume)
{
  shapeton::ColonPhantomParameters none = Patient(1);
  none.polyps = 0;
  const shapeton::ColonAnatomy without(none), with(Patient(1));
  int                          compared = 0;
  for (const shapeton::ColonPolyp & polyp : with.Polyps())
  {
    if (polyp.kind != "sessile" || polyp.onFold || polyp.diameter > 10)
    {
      continue;
    }
    const double step = polyp.diameter / 24;
    double       volume = 0.0;
    for (int i = 0; i < 40 * 40 * 40; ++i)
    {
      const Vector3d off(i % 40 - 19.5, i / 40 % 40 - 19.5, i / 1600 - 19.5);
      const Vector3d point = polyp.base + step * off;
      const bool     isPolyp = without.Evaluate(point).distance > 0 && with.Evaluate(point).distance <= 0;
      volume += isPolyp ? step * step * step : 0.0;
    }
    // A half ellipsoid, slightly reduced by the concave wall and enlarged by the fillet.
    const double expected = shapeton::Pi / 6 * polyp.diameter * polyp.diameter * polyp.height;
    EXPECT_NEAR(volume / expected, 1.0, 0.3) << polyp.diameter;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST(ColonAnatomy, CollapseClosesTheLumen)
{
  shapeton::ColonPhantomParameters parameters = Patient(2);
  parameters.collapsed = 1;
  const shapeton::ColonAnatomy anatomy(parameters);
  const shapeton::CurveSet     line = anatomy.Centerline();
  const auto                   collapsed = Column(line.pointArrays, "collapsed");
  const auto                   arcLength = Column(line.pointArrays, "arcLength");
  double                       length = 0.0;
  for (Eigen::Index i = 1; i < line.V.rows(); ++i)
  {
    if (collapsed[i] == 1 && collapsed[i - 1] == 1)
    {
      length += arcLength[i] - arcLength[i - 1];
      EXPECT_LE(anatomy.Evaluate(line.V.row(i)).distance, 0.5);
    }
  }
  EXPECT_GT(length, 30.0);
  EXPECT_LT(length, 140.0);
}

// Mean radius of the wall away from the ends of a segment.
double
RadiusWithin(const shapeton::ColonAnatomy & anatomy, int segment)
{
  const shapeton::CurveSet line = anatomy.Centerline();
  const auto               radius = Column(line.pointArrays, "radius");
  const auto               segments = Column(line.pointArrays, "segment");
  double                   sum = 0.0, count = 0.0;
  for (std::size_t i = 20; i + 20 < radius.size(); ++i)
  {
    const bool isWithin = segments[i - 20] == segment && segments[i + 20] == segment;
    sum += isWithin ? radius[i] : 0.0;
    count += isWithin ? 1.0 : 0.0;
  }
  return sum / count;
}

double
LengthOf(const shapeton::ColonAnatomy & anatomy, int segment)
{
  double length = 0.0;
  for (double s = 0.0; s < anatomy.Length(); s += 1.0)
  {
    length += anatomy.SegmentAt(s) == segment ? 1.0 : 0.0;
  }
  return length;
}

TEST(ColonAnatomy, SegmentsHaveTheShapeAskedFor)
{
  shapeton::ColonPhantomParameters plain = Patient(3), shaped = Patient(3);
  shaped.lengths[1] = 1000.0;
  shaped.lengths[3] = 550.0;
  shaped.caliber[2] = 44.0;
  const shapeton::ColonAnatomy before(plain), after(shaped);
  // The full length does not always fit.
  EXPECT_GT(LengthOf(after, 2), 700.0);
  EXPECT_LT(LengthOf(before, 2), 600.0);
  EXPECT_NEAR(LengthOf(after, 4), 500.0, 80.0);
  EXPECT_GT(LengthOf(before, 4), 600.0);
  // The variation by location and position is 11 and 15 %.
  EXPECT_LT(RadiusWithin(before, 3), 19.5);
  EXPECT_NEAR(RadiusWithin(after, 3), 22.0, 3.5);
}

// Points of the centerline in a segment.
std::vector<Vector3d>
LineWithin(const shapeton::ColonAnatomy & anatomy, int segment)
{
  const shapeton::CurveSet line = anatomy.Centerline();
  const auto               segments = Column(line.pointArrays, "segment");
  std::vector<Vector3d>    points;
  for (Eigen::Index i = 0; i < line.V.rows(); ++i)
  {
    if (segments[i] == segment)
    {
      points.push_back(line.V.row(i));
    }
  }
  return points;
}

// Real patients: 0.32 to 0.55. The fixed descending colon ends at the pelvic brim, medial to the left iliac crest at
// (136, 34, -34) mm.
TEST(ColonAnatomy, SigmoidsSpanThoseOfPatients)
{
  std::vector<double> shares;
  int                 risen = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    auto parameters = shapeton::ColonPhantomPreset("realistic");
    parameters.seed = seed;
    const shapeton::ColonAnatomy anatomy(parameters);
    shares.push_back((LengthOf(anatomy, 1) + LengthOf(anatomy, 2)) / anatomy.Length());
    EXPECT_TRUE(shares.back() > 0.2 && shares.back() < 0.55) << seed;
    const Vector3d junction = LineWithin(anatomy, 3)[0];
    EXPECT_LT((junction - Vector3d(118, 40, -52)).norm(), 45.0) << seed;
    double highest = -1e9;
    for (const Vector3d & point : LineWithin(anatomy, 2))
    {
      highest = std::max(highest, point.z());
    }
    risen += highest > 40.0 ? 1 : 0;
    EXPECT_TRUE(anatomy.GetParameters().sigmoidRise < 60.0 || highest > 40.0) << seed;
    EXPECT_TRUE(anatomy.GetParameters().sigmoidStraightness == 0.0 || highest < -30.0) << seed;
  }
  EXPECT_LT(Quantile(shares, 0.0), 0.24);
  EXPECT_GT(Quantile(shares, 0.99), 0.48);
  EXPECT_GE(risen, 4);
}

TEST(ColonAnatomy, AMobileCecumMoves)
{
  shapeton::ColonPhantomParameters still = Patient(4), mobile = Patient(4);
  still.cecumMobility = 0.0;
  mobile.cecumMobility = 100.0;
  const auto moveOf = [](shapeton::ColonPhantomParameters parameters) {
    const Vector3d supine = shapeton::ColonAnatomy(parameters).CecalPole();
    parameters.position = "prone";
    return (shapeton::ColonAnatomy(parameters).CecalPole() - supine).norm();
  };
  EXPECT_LT(moveOf(still), 25.0);
  EXPECT_GT(moveOf(mobile), moveOf(still) + 10.0);
}
