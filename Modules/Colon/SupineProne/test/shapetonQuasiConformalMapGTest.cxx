#include "shapetonQuasiConformalMap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using shapeton::BeltramiEquations;
using shapeton::CylinderValues;
using shapeton::MapCondition;
using shapeton::MapConditions;
using Complex = std::complex<double>;

constexpr double pi = 3.14159265358979323846;
constexpr double length = 200.0; // mm, of the source
constexpr double around = 90.0;
constexpr double targetAround = 120.0;

/** A map with its derivatives along and around the source. */
struct Known
{
  double along, around;
  double alongX, alongY, aroundX, aroundY;

  Complex
  Beltrami() const
  {
    const Complex i(0.0, 1.0);
    const Complex ofX(alongX, aroundX);
    const Complex ofY(alongY, aroundY);
    return (ofX + i * ofY) / (ofX - i * ofY);
  }
};

/** A bent map that maps ends to ends. */
Known
BentMap(double x, double y)
{
  const double k = pi / length;
  const double w = 2.0 * pi / around;
  const double scale = targetAround / around;
  return { 1.5 * x + 6.0 * std::sin(k * x) * std::cos(w * y), scale * y + 0.1 * x + 4.0 * std::sin(w * y + k * x),
           1.5 + 6.0 * k * std::cos(k * x) * std::cos(w * y), -6.0 * w * std::sin(k * x) * std::sin(w * y),
           0.1 + 4.0 * k * std::cos(w * y + k * x),           scale + 4.0 * w * std::cos(w * y + k * x) };
}

/** Twice as long, and twisted. */
Known
StretchedMap(double x, double y)
{
  return { 2.0 * x, targetAround / around * y + 0.3 * x, 2.0, 0.0, 0.3, targetAround / around };
}

/** The row spacing increases along the source. */
double
PlaceOfRow(int row, int rows)
{
  const double t = static_cast<double>(row) / (rows - 1);
  return length * (0.5 * t + 0.5 * t * t);
}

BeltramiEquations
Equations(int rows, int angles, double ofSource = 1.0, double ofTarget = 1.0)
{
  std::vector<double> heights;
  for (int row = 0; row + 1 < rows; ++row)
  {
    heights.push_back(ofSource * (PlaceOfRow(row + 1, rows) - PlaceOfRow(row, rows)));
  }
  return { heights, angles, ofSource * around, ofTarget * targetAround };
}

template <typename TMap>
CylinderValues
ValuesOf(const BeltramiEquations & equations, TMap map)
{
  CylinderValues values{ Eigen::VectorXd(equations.Nodes()), Eigen::VectorXd(equations.Nodes()) };
  for (int node = 0; node < equations.Nodes(); ++node)
  {
    const Known known = map(PlaceOfRow(node / equations.Angles(), equations.Rows()),
                            around * (node % equations.Angles()) / equations.Angles());
    values.along[node] = known.along;
    values.around[node] = known.around;
  }
  return values;
}

template <typename TMap>
BeltramiEquations::Coefficients
CoefficientsInTheMiddle(const BeltramiEquations & equations, TMap map)
{
  BeltramiEquations::Coefficients mu;
  for (int t = 0; t < equations.Triangles(); ++t)
  {
    const int    row = t / 2 / equations.Angles();
    const int    angle = t / 2 % equations.Angles();
    const double along = t % 2 == 0 ? 2.0 / 3.0 : 1.0 / 3.0;
    const double low = PlaceOfRow(row, equations.Rows());
    const double high = PlaceOfRow(row + 1, equations.Rows());
    mu.push_back(map(low + along * (high - low), around * (angle + 1.0 - along) / equations.Angles()).Beltrami());
  }
  return mu;
}

MapCondition
AtNode(int node, double value)
{
  return { { node, node, node }, { 1.0, 0.0, 0.0 }, value };
}

/** Constrains the ends to circles at their current values, and the angle of one node of the first row. */
MapConditions
EndsOf(const BeltramiEquations & equations, const CylinderValues & values, int kept = 0)
{
  MapConditions conditions;
  for (int angle = 0; angle < equations.Angles(); ++angle)
  {
    const int last = equations.Nodes() - 1 - angle;
    conditions.along.push_back(AtNode(angle, values.along[angle]));
    conditions.along.push_back(AtNode(last, values.along[last]));
  }
  conditions.around.push_back(AtNode(kept, values.around[kept]));
  return conditions;
}

/** Constrains the map to move a position (in rows and angles of the nodes) by a displacement in mm. */
void
AddLandmark(const BeltramiEquations & equations,
            const CylinderValues &    values,
            double                    row,
            double                    angle,
            const Eigen::Vector2d &   displacement,
            MapConditions &           conditions)
{
  const BeltramiEquations::Place    place = equations.PlaceOf(row, angle);
  const BeltramiEquations::Triangle triangle = equations.TriangleOf(place.triangle);
  MapCondition                      along{ triangle.node, place.share, displacement.x() };
  MapCondition                      turned{ triangle.node, place.share, displacement.y() };
  for (int k = 0; k < 3; ++k)
  {
    along.value += place.share[k] * values.along[triangle.node[k]];
    turned.value += place.share[k] * values.around[triangle.node[k]];
  }
  conditions.along.push_back(along);
  conditions.around.push_back(turned);
}

double
GreatestDifference(const CylinderValues & a, const CylinderValues & b)
{
  return std::max((a.along - b.along).cwiseAbs().maxCoeff(), (a.around - b.around).cwiseAbs().maxCoeff());
}

double
MissOf(const MapCondition & condition, const Eigen::VectorXd & values)
{
  return values[condition.node[0]] * condition.share[0] + values[condition.node[1]] * condition.share[1] +
         values[condition.node[2]] * condition.share[2] - condition.value;
}

/** Error of the map found for the Beltrami coefficient of BentMap, mm. */
double
ErrorOfBentMap(int rows, int angles)
{
  const BeltramiEquations equations = Equations(rows, angles);
  const CylinderValues    known = ValuesOf(equations, BentMap);
  return GreatestDifference(
    known, shapeton::SolveBeltrami(equations, CoefficientsInTheMiddle(equations, BentMap), EndsOf(equations, known)));
}

shapeton::QuasiConformalMap
Find(const BeltramiEquations & equations, const CylinderValues & start, const MapConditions & conditions)
{
  return shapeton::FindQuasiConformalMap(equations, start, [&](const CylinderValues &) { return conditions; }, {});
}

/** Three landmarks, far apart, that move by a few mm; all are shifted by `turned` angles. */
MapConditions
SomeLandmarks(const BeltramiEquations & equations, const CylinderValues & values, int turned = 0, double scale = 1.0)
{
  MapConditions conditions = EndsOf(equations, values, turned);
  const auto    add = [&](double row, double angle, const Eigen::Vector2d & displacement) {
    AddLandmark(
      equations, values, row, std::fmod(angle + turned, equations.Angles()), scale * displacement, conditions);
  };
  add(14.3, 29.6, { 6.0, -3.0 });
  add(22.7, 8.2, { -4.0, 5.0 });
  add(31.1, 17.0, { 3.0, 7.0 });
  return conditions;
}
} // namespace

TEST(QuasiConformalMap, AnAffineMapIsReproducedExactly)
{
  const BeltramiEquations equations = Equations(25, 18);
  const CylinderValues    known = ValuesOf(equations, StretchedMap);
  const auto              mu = CoefficientsInTheMiddle(equations, StretchedMap);
  EXPECT_GT(std::abs(mu[0]), 0.1);
  EXPECT_LT(GreatestDifference(known, shapeton::SolveBeltrami(equations, mu, EndsOf(equations, known))), 1e-8);
}

TEST(QuasiConformalMap, AKnownMapIsReproducedToSecondOrder)
{
  const double coarse = ErrorOfBentMap(25, 18);
  const double fine = ErrorOfBentMap(49, 36);
  const double finer = ErrorOfBentMap(97, 72);
  EXPECT_LT(finer, 0.05);
  EXPECT_NEAR(coarse / fine, 4.0, 0.8);
  EXPECT_NEAR(fine / finer, 4.0, 0.4);
}

TEST(QuasiConformalMap, CoefficientsOfAKnownMap)
{
  const BeltramiEquations equations = Equations(97, 72);
  int                     flips = 0;
  const auto              found = equations.CoefficientsOf(ValuesOf(equations, BentMap), flips);
  const auto              known = CoefficientsInTheMiddle(equations, BentMap);
  EXPECT_EQ(flips, 0);
  for (std::size_t t = 0; t < known.size(); ++t)
  {
    ASSERT_LT(std::abs(found[t] - known[t]), 0.01) << t;
  }
}

/** The ends alone determine the conformal map if the target has the matching length. */
TEST(QuasiConformalMap, LandmarksThatAgreeGiveTheConformalMap)
{
  const BeltramiEquations equations = Equations(40, 36);
  const double            scale = targetAround / around;
  const CylinderValues    conformal = ValuesOf(
    equations, [scale](double x, double y) { return Known{ scale * x, scale * y + 5.0, scale, 0.0, 0.0, scale }; });
  const auto map = Find(equations, conformal, SomeLandmarks(equations, conformal, 0, 0.0));
  EXPECT_LT(GreatestDifference(conformal, map.values), 1e-7);
  EXPECT_LT(map.greatest, 1e-8);
  EXPECT_EQ(map.flips, 0);
}

TEST(QuasiConformalMap, LandmarksHold)
{
  const BeltramiEquations equations = Equations(40, 36);
  const CylinderValues    start = ValuesOf(equations, StretchedMap);
  const MapConditions     conditions = SomeLandmarks(equations, start);
  const auto              map = Find(equations, start, conditions);
  EXPECT_LT(map.greatestMiss, 1e-6);
  for (const MapCondition & condition : conditions.along)
  {
    EXPECT_NEAR(MissOf(condition, map.values.along), 0.0, 1e-6);
  }
  for (const MapCondition & condition : conditions.around)
  {
    EXPECT_NEAR(MissOf(condition, map.values.around), 0.0, 1e-6);
  }
}

/** Points have zero capacity: a harmonic map deviates only locally at a landmark and folds over there. */
TEST(QuasiConformalMap, IsOneToOneWhereTheHarmonicMapFolds)
{
  const BeltramiEquations equations = Equations(40, 36);
  const CylinderValues    start = ValuesOf(equations, StretchedMap);
  MapConditions           conditions = EndsOf(equations, start);
  AddLandmark(equations, start, 20.4, 12.7, { 25.0, 15.0 }, conditions);
  const auto harmonic =
    shapeton::SolveBeltrami(equations, BeltramiEquations::Coefficients(equations.Triangles()), conditions);
  int flips = 0;
  equations.CoefficientsOf(harmonic, flips);
  EXPECT_GT(flips, 0);
  const auto map = Find(equations, start, conditions);
  EXPECT_EQ(map.flips, 0);
  EXPECT_LT(map.greatest, 1.0);
}

TEST(QuasiConformalMap, ItsPlaceOfTheSeamIsOfNoConsequence)
{
  const BeltramiEquations equations = Equations(40, 36);
  const CylinderValues    start = ValuesOf(equations, StretchedMap);
  constexpr int           turned = 11;
  const auto              map = Find(equations, start, SomeLandmarks(equations, start));
  const auto              other = Find(equations, start, SomeLandmarks(equations, start, turned));
  for (int node = 0; node < equations.Nodes(); ++node)
  {
    const int angle = node % equations.Angles();
    const int there = node - angle + (angle + turned) % equations.Angles();
    ASSERT_NEAR(map.values.along[node], other.values.along[there], 1e-5);
  }
}

TEST(QuasiConformalMap, ScaledCylindersAreConformal)
{
  const BeltramiEquations equations = Equations(40, 36);
  const CylinderValues    start = ValuesOf(equations, StretchedMap);
  const auto              map = Find(equations, start, SomeLandmarks(equations, start));
  // Constraints are in mm of the target; smoothing is in mm of the source and is therefore unchanged.
  constexpr double        scale = 2.5;
  const BeltramiEquations large = Equations(40, 36, 1.0, scale);
  const CylinderValues    largeStart{ scale * start.along, scale * start.around };
  const auto              other = Find(large, largeStart, SomeLandmarks(large, largeStart, 0, scale));
  EXPECT_LT(GreatestDifference({ scale * map.values.along, scale * map.values.around }, other.values), 1e-5);
}

TEST(QuasiConformalMap, ContradictionsAreMissedAsLittleAsCanBe)
{
  const BeltramiEquations equations = Equations(40, 36);
  const CylinderValues    start = ValuesOf(equations, StretchedMap);
  MapConditions           conditions = EndsOf(equations, start);
  AddLandmark(equations, start, 20.4, 12.7, { 2.0, 0.0 }, conditions);
  AddLandmark(equations, start, 20.4, 12.7, { -1.0, 0.0 }, conditions);
  const auto map = Find(equations, start, conditions);
  EXPECT_NEAR(map.greatestMiss, 1.5, 1e-3);
}
