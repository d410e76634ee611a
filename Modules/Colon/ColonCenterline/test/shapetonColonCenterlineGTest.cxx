#include "shapetonColonCenterline.h"
#include "shapetonPi.h"

#include "shapetonTubeMask.h"

#include "shapetonTestErrors.h"
#include "shapetonVolumeReader.h"
#include "shapetonTestThreads.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace
{
using shapeton::ColonCenterline;
using shapeton::LengthOf;
using shapeton::TubeMask;
using shapeton::TubePoints;

TubePoints
PointsOf(const ColonCenterline & line)
{
  TubePoints points;
  for (const int i : line.curve.curves.front())
  {
    points.emplace_back(line.curve.V.row(i).transpose());
  }
  return points;
}

double
DistanceTo(const TubePoints & points, const Eigen::Vector3d & point)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto & p : points)
  {
    least = std::min(least, (p - point).norm());
  }
  return least;
}

double
MeanDistance(const TubePoints & from, const TubePoints & to)
{
  double sum = 0.0;
  for (const auto & p : from)
  {
    sum += DistanceTo(to, p);
  }
  return sum / from.size();
}

/** Fraction of `truth` within `reach` mm of the line. */
double
Covered(const TubePoints & truth, const TubePoints & line, double reach)
{
  return std::count_if(
           truth.begin(), truth.end(), [&](const Eigen::Vector3d & p) { return DistanceTo(line, p) <= reach; }) /
         static_cast<double>(truth.size());
}

bool
HasWarning(const ColonCenterline & line, const std::string & text)
{
  return std::any_of(line.warnings.begin(), line.warnings.end(), [&](const std::string & warning) {
    return warning.find(text) != std::string::npos;
  });
}

/** Whether each point is in a lumen voxel, except on bridges. */
bool
IsInside(const ColonCenterline & line, const shapeton::LumenMask * mask)
{
  const auto gap = shapeton::PointValues(line.curve, "gap", "test");
  for (int i = 0; i < gap.size(); ++i)
  {
    const Eigen::Vector3d at = line.curve.V.row(i).transpose();
    const auto            index = mask->TransformPhysicalPointToIndex(itk::Point<double, 3>(at.data()));
    if (gap[i] == 0.0 && mask->GetPixel(index) == 0)
    {
      return false;
    }
  }
  return true;
}

/** Trilinear interpolation between 1 in the lumen and 0 elsewhere; the surface of the mask is at 0.5. */
double
Occupancy(const shapeton::LumenMask * mask, const Eigen::Vector3d & at)
{
  const auto place = mask->TransformPhysicalPointToContinuousIndex<double>(itk::Point<double, 3>(at.data()));
  double     sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    itk::Index<3> index;
    double        weight = 1.0;
    for (int a = 0; a < 3; ++a)
    {
      const double low = std::floor(place[a]);
      const int    upper = corner >> a & 1;
      index[a] = static_cast<itk::IndexValueType>(low) + upper;
      weight *= upper == 1 ? place[a] - low : 1.0 - place[a] + low;
    }
    sum += mask->GetBufferedRegion().IsInside(index) && mask->GetPixel(index) != 0 ? weight : 0.0;
  }
  return sum;
}

/** Fraction of the points of a curve before the point nearest to a given position. */
double
ShareAt(const TubePoints & points, const Eigen::Vector3d & point)
{
  const auto nearer = [&](const Eigen::Vector3d & a, const Eigen::Vector3d & b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  };
  return (std::min_element(points.begin(), points.end(), nearer) - points.begin()) / static_cast<double>(points.size());
}

/** A curve through rectum, sigmoid, descending, transverse and ascending colon to the pole of the cecum. */
TubePoints
ColonThrough(TubePoints places, const Eigen::Vector3d & pole)
{
  places.insert(places.end(),
                { { 110, 20, -20 },
                  { 110, 20, 100 },
                  { 40, -10, 130 },
                  { -40, -10, 130 },
                  { -110, 10, 100 },
                  { -115, 5, -20 },
                  pole });
  return shapeton::CurveThrough(places);
}

/** A serpentine of adjacent limbs, whose axes are `pitch` mm apart. It begins caudally. */
TubePoints
Serpentine(int limbs, double length, double pitch)
{
  TubePoints points;
  for (int k = 0; k < limbs; ++k)
  {
    const double x = k % 2 == 0 ? 0.0 : length;
    const double direction = k % 2 == 0 ? 1.0 : -1.0;
    for (double t = 0.0; t <= length; t += 0.5)
    {
      points.emplace_back(x + direction * t, 0.0, pitch * k);
    }
    for (double angle = 0.01; k + 1 < limbs && angle < shapeton::Pi; angle += 0.02)
    {
      const double r = 0.5 * pitch;
      points.emplace_back(x + direction * (length + r * std::sin(angle)), 0.0, pitch * k + r * (1.0 - std::cos(angle)));
    }
  }
  return points;
}

TEST(ColonCenterline, OfAColonIsItsAxisInAnyImageFrame)
{
  const TubePoints truth = shapeton::ColonCurve();
  const auto       radius = [](double share) { return 16.0 + 6.0 * std::sin(60.0 * share); };
  for (const bool isLeftHanded : { false, true })
  {
    TubeMask mask(truth, 30.0, { 1.9, 1.6, 2.5 }, shapeton::ObliqueFrame(isLeftHanded));
    mask.Paint(truth, radius);
    const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
    const TubePoints      points = PointsOf(line);
    EXPECT_NEAR(line.length, LengthOf(truth), 0.03 * LengthOf(truth));
    EXPECT_LT(MeanDistance(points, truth), 2.0);
    EXPECT_GT(Covered(truth, points, 8.0), 0.97);
    EXPECT_LT((points.front() - truth.front()).norm(), 20.0);
    EXPECT_LT((points.back() - truth.back()).norm(), 20.0);
    EXPECT_TRUE(line.gaps.empty());
    EXPECT_TRUE(IsInside(line, mask.Get()));
    EXPECT_GT(line.coverage, 0.97);
  }
}

TEST(ColonCenterline, CoversAWideLumenButNotABranch)
{
  // Three tubes side by side overlap: 64 mm wide, 36 mm deep. The branch is at a right angle.
  const auto axis = [](double x) { return shapeton::CurveThrough({ { x, 0.0, -150.0 }, { x, 0.0, 150.0 } }); };
  TubeMask   mask(axis(0.0), 200.0, { 1.5, 1.5, 1.5 }, shapeton::ObliqueFrame());
  for (const double x : { -14.0, 0.0, 14.0 })
  {
    mask.Paint(axis(x), 18.0);
  }
  const ColonCenterline wide = shapeton::TraceColonCenterline(mask.Get());
  EXPECT_GT(wide.coverage, 0.99);
  EXPECT_FALSE(HasWarning(wide, "side branch"));

  mask.Paint(shapeton::CurveThrough({ { 0.0, 0.0, 0.0 }, { 0.0, 130.0, 0.0 } }), 12.0);
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  const double          volume = line.pieces.front().volume;                           // ml
  const double away = (130.0 + 8.0 - 10.0 - 36.0) * shapeton::Pi * 12.0 * 12.0 * 1e-3; // beyond 10 mm + 2 radii; a cap
  EXPECT_NEAR((1.0 - line.coverage) * volume, away, 0.15 * away);
  EXPECT_TRUE(HasWarning(line, "side branch"));
}

TEST(ColonCenterline, DoubtsARectumAtAnUnlikelyPlace)
{
  for (const double begin : { 0.0, 0.5 }) // the right half starts at the cecum
  {
    const TubePoints truth = shapeton::PartOf(shapeton::ColonCurve(), begin, 1.0);
    TubeMask         mask(truth, 30.0, { 2.0, 2.0, 2.0 });
    mask.Paint(truth, 15.0);
    EXPECT_EQ(HasWarning(shapeton::TraceColonCenterline(mask.Get()), "unlikely for the anus"), begin > 0.0);
  }
}

TEST(ColonCenterline, HasArraysThatFitItsPoints)
{
  const TubePoints truth = shapeton::PartOf(shapeton::ColonCurve(), 0.0, 0.5);
  TubeMask         mask(truth, 30.0, { 1.5, 1.5, 1.5 });
  mask.Paint(truth, 15.0);
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  const auto            arc = shapeton::PointValues(line.curve, "arcLength", "test");
  const auto            radius = shapeton::PointValues(line.curve, "radius", "test");
  const TubePoints      points = PointsOf(line);
  EXPECT_EQ(arc[0], 0.0);
  EXPECT_EQ(arc[arc.size() - 1], line.length);
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    EXPECT_NEAR(arc[i] - arc[i - 1], (points[i] - points[i - 1]).norm(), 1e-9);
    EXPECT_NEAR(arc[i] - arc[i - 1], 1.0, 0.05);
  }
  for (int i = 30; i + 30 < radius.size(); ++i)
  {
    EXPECT_NEAR(radius[i], 15.0, 1.5);
  }
}

TEST(ColonCenterline, OfATorusArcAndAHelixHasTheClosedLength)
{
  TubePoints arc, helix;
  for (double t = 0.0; t <= 1.5 * shapeton::Pi; t += 0.01)
  {
    arc.emplace_back(60.0 * std::cos(t), 0.0, 60.0 * std::sin(t));
  }
  for (double t = 0.0; t <= 4.0 * shapeton::Pi; t += 0.01)
  {
    helix.emplace_back(50.0 * std::cos(t), 50.0 * std::sin(t), 8.0 * t);
  }
  for (const TubePoints & truth : { arc, helix })
  {
    TubeMask mask(truth, 20.0, { 1.3, 1.3, 1.7 }, shapeton::ObliqueFrame());
    mask.Paint(truth, 14.0);
    const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
    // Round caps may lengthen the line beyond the ends of the axis.
    EXPECT_GT(line.length, 0.98 * LengthOf(truth));
    EXPECT_LT(line.length, 1.02 * LengthOf(truth) + 2.0 * 14.0);
    EXPECT_LT(MeanDistance(PointsOf(line), truth), 2.0);
    EXPECT_NEAR(line.lengths[0], line.length, 0.03 * line.length);
    EXPECT_NEAR(line.lengths[2], line.length, 0.03 * line.length);
  }
}

/** Limbs separated by septa one voxel thick, with some leaks. */
TubeMask
LeakySerpentine(const TubePoints & truth, double pitch, double hole)
{
  TubeMask mask(truth, 25.0, { 1.0, 1.0, 1.0 });
  mask.Paint(truth, 0.5 * pitch - 0.6);
  for (const double x : { 20.0, 55.0, 90.0 })
  {
    for (int k = 0; k < 4; ++k)
    {
      mask.PaintBall({ x + 3.0 * k, 0.0, pitch * (k + 0.5) }, hole);
    }
  }
  return mask;
}

TEST(ColonCenterline, TakesNoShortCutThroughSeptaThatLeak)
{
  const double     pitch = 30.0;
  const TubePoints truth = Serpentine(5, 130.0, pitch);
  for (const double hole : { 1.5, 5.0 })
  {
    const ColonCenterline line = shapeton::TraceColonCenterline(LeakySerpentine(truth, pitch, hole).Get());
    EXPECT_NEAR(line.length, LengthOf(truth), 0.04 * LengthOf(truth)) << hole;
    EXPECT_GT(Covered(truth, PointsOf(line), 6.0), 0.97) << hole;
    EXPECT_FALSE(line.merges.empty());
    EXPECT_LT(line.warnings.size(), 30u);
    EXPECT_TRUE(HasWarning(line, "touch at"));
  }
}

TEST(ColonCenterline, GoesThroughANarrowPlaceRatherThanAWiderHole)
{
  const double     pitch = 30.0;
  const TubePoints truth = Serpentine(3, 220.0, pitch);
  // The colon is 5 mm wide halfway along its second limb; the holes between the limbs are up to half as wide as the
  // limbs.
  for (const double hole : { 4.0, 6.8, 7.5 })
  {
    TubeMask mask(truth, 25.0, { 1.2, 1.0, 1.2 });
    mask.Paint(truth, [](double share) { return std::abs(share - 0.5) < 0.02 ? 2.5 : 14.4; });
    mask.Paint(shapeton::PartOf(truth, 0.46, 0.54), 14.4, 0);
    mask.Paint(shapeton::PartOf(truth, 0.42, 0.58), 2.5);
    mask.PaintBall({ 20.0, 0.0, 0.5 * pitch }, hole);
    mask.PaintBall({ 200.0, 0.0, 1.5 * pitch }, hole);
    const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
    EXPECT_NEAR(line.length, LengthOf(truth), 0.04 * LengthOf(truth)) << hole;
    EXPECT_GT(Covered(truth, PointsOf(line), 6.0), 0.97) << hole;
  }
}

TEST(ColonCenterline, BridgesCollapsedStretchesInTheOrderOfTheColon)
{
  const TubePoints                         truth = shapeton::ColonCurve();
  TubeMask                                 mask(truth, 30.0, { 1.5, 1.5, 2.0 }, shapeton::ObliqueFrame());
  const std::vector<std::array<double, 2>> parts = { { 0.0, 0.17 }, { 0.21, 0.45 }, { 0.5, 0.7 }, { 0.75, 1.0 } };
  for (const auto & part : parts)
  {
    // Tapering at both ends.
    mask.Paint(shapeton::PartOf(truth, part[0], part[1]),
               [](double share) { return std::min(16.0, 3.0 + 130.0 * std::min(share, 1.0 - share)); });
  }
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  const TubePoints      points = PointsOf(line);
  ASSERT_EQ(line.gaps.size(), 3u);
  EXPECT_TRUE(IsInside(line, mask.Get()));
  EXPECT_NEAR(line.length, LengthOf(truth), 0.05 * LengthOf(truth));
  const auto gap = shapeton::PointValues(line.curve, "gap", "test");
  const auto arc = shapeton::PointValues(line.curve, "arcLength", "test");
  for (std::size_t g = 0; g < 3; ++g)
  {
    const double begin = LengthOf(shapeton::PartOf(truth, 0.0, parts[g][1]));
    const double end = LengthOf(shapeton::PartOf(truth, 0.0, parts[g + 1][0]));
    EXPECT_NEAR(line.gaps[g].begin, begin, 0.03 * line.length);
    EXPECT_NEAR(line.gaps[g].end, end, 0.03 * line.length);
    EXPECT_FALSE(line.gaps[g].isDoubtful);
  }
  for (int i = 0; i < gap.size(); ++i)
  {
    const bool isInside = std::any_of(line.gaps.begin(), line.gaps.end(), [&](const shapeton::CenterlineGap & g) {
      return arc[i] > g.begin + 1e-6 && arc[i] < g.end - 1e-6;
    });
    ASSERT_EQ(gap[i] == 1.0, isInside) << arc[i];
  }
  for (const auto & part : parts)
  {
    EXPECT_GT(Covered(shapeton::PartOf(truth, part[0], part[1]), points, 8.0), 0.97);
  }
}

TEST(ColonCenterline, CutsAHoleThatHangsTheCecumOnAnotherLoop)
{
  // A collapsed stretch after the second limb; the third one leaks into the neighbor of the first limb instead.
  const double     pitch = 36.0;
  const TubePoints truth = Serpentine(3, 220.0, pitch);
  TubeMask         mask(truth, 25.0, { 1.5, 1.5, 1.5 });
  mask.Paint(shapeton::PartOf(truth, 0.0, 0.62), 16.0);
  mask.Paint(shapeton::PartOf(truth, 0.68, 1.0), 16.0);
  mask.Paint({ { 130.0, 0.0, 1.3 * pitch }, { 130.0, 0.0, 1.5 * pitch }, { 130.0, 0.0, 1.7 * pitch } }, 3.0);
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  EXPECT_EQ(line.gaps.size(), 1u);
  EXPECT_GT(Covered(truth, PointsOf(line), 12.0), 0.97);
  EXPECT_NEAR(line.length, LengthOf(truth), 0.06 * LengthOf(truth));
}

TEST(ColonCenterline, CutsAHoleByWhichThePouchOfTheLastPieceHangsOnTheFirst)
{
  // A narrow hole and the pouch at the end of the third limb connect the first limb to the rest. The joints between the
  // first, second and third limb have collapsed.
  const TubePoints truth = ColonThrough(
    { { 0, 40, -150 }, { 0, 35, -90 }, { -50, 0, -60 }, { -40, -25, -20 }, { 40, 0, -50 } }, { -105, 0, -75 });
  TubeMask mask(truth, 35.0, { 1.5, 1.5, 1.5 });
  mask.Paint(shapeton::PartOf(truth, 0.0, 0.36), 12.0);
  mask.Paint(shapeton::PartOf(truth, 0.43, 0.62), 16.0);
  mask.Paint(shapeton::PartOf(truth, 0.69, 1.0), [](double share) { return 18.0 + 10.0 * share; });
  const Eigen::Vector3d crest = truth[static_cast<std::size_t>(0.145 * truth.size())];
  mask.Paint(shapeton::CurveThrough({ crest, truth.back() }), 2.2);
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  ASSERT_EQ(line.gaps.size(), 2u);
  EXPECT_GT(line.coverage, 0.9);
  EXPECT_TRUE(IsInside(line, mask.Get()));
  EXPECT_NEAR(line.length, LengthOf(truth), 0.05 * LengthOf(truth));
  EXPECT_LT((PointsOf(line).front() - truth.front()).norm(), 20.0);
  EXPECT_LT((PointsOf(line).back() - truth.back()).norm(), 30.0);
  EXPECT_GT(Covered(truth, PointsOf(line), 15.0), 0.97);
}

TEST(ColonCenterline, GoesOnAtATaperRatherThanAtANearerCecum)
{
  // The sigmoid is collapsed next to the pole of the cecum and continues farther away.
  const Eigen::Vector3d collapses(-22, -45, -80);
  const Eigen::Vector3d goesOn(30, -75, -100);
  const TubePoints      truth = ColonThrough({ { 0, 40, -150 },
                                               { 0, 35, -90 },
                                               { 20, 0, -60 },
                                               { 0, -40, -50 },
                                               collapses,
                                               { -20, -70, -110 },
                                               goesOn,
                                               { 80, -20, -80 } },
                                        { -95, -30, -85 });
  TubeMask              mask(truth, 35.0, { 1.5, 1.5, 1.5 });
  mask.Paint(shapeton::PartOf(truth, 0.0, ShareAt(truth, collapses)),
             [](double share) { return std::min(15.0, 4.0 + 40.0 * (1.0 - share)); });
  mask.Paint(shapeton::PartOf(truth, ShareAt(truth, goesOn), 1.0),
             [](double share) { return std::min(16.0 + 6.0 * share, 4.0 + 120.0 * share); });
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  ASSERT_EQ(line.gaps.size(), 1u);
  EXPECT_LT((PointsOf(line).back() - truth.back()).norm(), 30.0);
  EXPECT_NEAR(line.length, LengthOf(truth), 0.07 * LengthOf(truth));
}

TEST(ColonCenterline, EndsAtTheCecumRatherThanInSmallBowel)
{
  const TubePoints truth = shapeton::ColonCurve();
  TubeMask         mask(truth, 35.0, { 1.5, 1.5, 1.5 });
  mask.Paint(truth, [](double share) { return std::min(16.0 + 4.0 * share, 4.0 + 120.0 * share); });
  // Gas in small bowel, half a meter long and 12 mm wide, begins 35 mm from the cecum.
  const auto bowel = shapeton::CurveThrough({ { -40, 20, -60 },
                                              { 40, 20, -60 },
                                              { 40, 20, -30 },
                                              { -40, 20, -30 },
                                              { -40, 20, 0 },
                                              { 40, 20, 0 },
                                              { 40, 20, 25 } });
  mask.Paint(bowel, [](double) { return 6.0; });
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  EXPECT_TRUE(line.gaps.empty());
  EXPECT_NEAR(line.length, LengthOf(truth), 0.05 * LengthOf(truth));
  ASSERT_EQ(line.pieces.size(), 2u);
  EXPECT_NE(line.pieces[1].reason.find("small bowel"), std::string::npos);
}

TEST(ColonCenterline, BeginsAtARectumThatLooksLikeASideBranch)
{
  // The junction of sigmoid and descending colon is collapsed, and the descending colon leaks into the rectum: the
  // longest path through the lumen follows the descending colon down and the sigmoid up.
  const Eigen::Vector3d collapses(40, -35, -75);
  const Eigen::Vector3d goesOn(28, 22, -78);
  const Eigen::Vector3d leaks(0, 40, -85);
  const TubePoints      truth = ColonThrough({ { 0, 40, -150 },
                                               leaks,
                                               { -30, 10, -40 },
                                               { -60, -30, -60 },
                                               { -30, -60, -80 },
                                               collapses,
                                               { 44, -5, -80 },
                                               goesOn,
                                               { 70, 40, -60 } },
                                        { -105, 0, -75 });
  TubeMask              mask(truth, 35.0, { 1.5, 1.5, 1.5 });
  mask.Paint(shapeton::PartOf(truth, 0.0, ShareAt(truth, collapses)),
             [](double share) { return std::min(13.0, 5.0 + 60.0 * (1.0 - share)); });
  mask.Paint(shapeton::PartOf(truth, ShareAt(truth, goesOn), 1.0), [](double share) { return 11.0 + 12.0 * share; });
  mask.PaintBall(0.5 * (leaks + goesOn), 6.5);
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  EXPECT_EQ(line.gaps.size(), 1u);
  EXPECT_LT((PointsOf(line).front() - truth.front()).norm(), 20.0);
  EXPECT_LT((PointsOf(line).back() - truth.back()).norm(), 30.0);
  EXPECT_NEAR(line.length, LengthOf(truth), 0.07 * LengthOf(truth));
}

TEST(ColonCenterline, ReachesThePoleOfAWideCecum)
{
  const TubePoints truth = Serpentine(2, 220.0, 70.0);
  TubeMask         mask(truth, 40.0, { 1.5, 1.5, 1.5 });
  const double     radius = 26.0;
  mask.Paint(truth, radius);
  const TubePoints      points = PointsOf(shapeton::TraceColonCenterline(mask.Get()));
  const Eigen::Vector3d out = (truth.back() - truth[truth.size() - 20]).normalized();
  const Eigen::Vector3d pole = truth.back() + radius * out;
  // 3 mm before the wall, to within the grid spacing.
  EXPECT_NEAR((pole - points.back()).dot(out), 3.0, 3.0);
  EXPECT_LT((points.back() - pole).norm(), 9.0);
}

/** A pouch next to the cecum bends upward and touches the ascending colon; the path ends in the pouch. */
TEST(ColonCenterline, ReachesThePoleBesideAPouchThatTurnsBack)
{
  const Eigen::Vector3d pole(-115, -75, -95);
  const TubePoints      truth = ColonThrough({ { 0, 60, -160 }, { 10, 40, -120 }, { 60, 10, -90 } }, pole);
  TubeMask              mask(truth, 60.0, { 1.7, 1.7, 2.0 });
  mask.Paint(truth, 22.0);
  const auto at = [&](double y, double z) { return Eigen::Vector3d(-115, y, z); };
  mask.Paint(shapeton::CurveThrough({ at(0, -40), at(-40, -65), at(-65, -85) }), 32.0);
  mask.Paint(shapeton::CurveThrough({ at(-50, -85), at(-15, -105), at(25, -85) }), 14.0);
  mask.Paint(shapeton::CurveThrough({ at(25, -85), at(20, -20) }), 4.0);
  const TubePoints points = PointsOf(shapeton::TraceColonCenterline(mask.Get()));
  EXPECT_LT((points.back() - pole).norm(), 24.0); // the lumen around it has a radius of 22
}

TEST(ColonCenterline, StaysInsideUpToEachGap)
{
  const TubePoints truth = Serpentine(3, 200.0, 60.0);
  TubeMask         mask(truth, 30.0, { 1.4, 1.4, 1.4 }, shapeton::ObliqueFrame());
  const auto       taper = [](double share) { return std::min(15.0, 0.5 + 150.0 * std::min(share, 1.0 - share)); };
  mask.Paint(shapeton::PartOf(truth, 0.0, 0.45), taper);
  mask.Paint(shapeton::PartOf(truth, 0.52, 1.0), taper);
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  const TubePoints      points = PointsOf(line);
  const auto            gap = shapeton::PointValues(line.curve, "gap", "test");
  ASSERT_EQ(line.gaps.size(), 1u);
  for (int i = 0; i + 1 < gap.size(); ++i)
  {
    if (gap[i] == 0.0 && gap[i + 1] == 0.0)
    {
      EXPECT_GE(Occupancy(mask.Get(), points[i]), 0.5) << i;
      EXPECT_GE(Occupancy(mask.Get(), 0.5 * (points[i] + points[i + 1])), 0.5) << i;
    }
  }
}

TEST(ColonCenterline, BeginsAtTheStartThatIsGiven)
{
  const TubePoints truth = shapeton::ColonCurve();
  TubeMask         mask(truth, 30.0, { 2.0, 2.0, 2.0 });
  mask.Paint(truth, 16.0);
  shapeton::ColonCenterlineSettings options;
  options.start = itk::Point<double, 3>(truth.back().data());
  const TubePoints points = PointsOf(shapeton::TraceColonCenterline(mask.Get(), options));
  EXPECT_LT((points.front() - truth.back()).norm(), 4.0);
  EXPECT_LT((points.back() - truth.front()).norm(), 20.0);
}

TEST(ColonCenterline, UsesSmallPiecesOnlyNextToASeed)
{
  const TubePoints truth = Serpentine(1, 200.0, 30.0);
  TubeMask         mask(truth, 30.0, { 1.5, 1.5, 1.5 });
  mask.Paint(shapeton::PartOf(truth, 0.0, 0.6), 12.0);
  mask.Paint(shapeton::PartOf(truth, 0.85, 0.9), 7.0);
  const ColonCenterline without = shapeton::TraceColonCenterline(mask.Get());
  EXPECT_TRUE(without.gaps.empty());
  ASSERT_EQ(without.pieces.size(), 2u);
  EXPECT_FALSE(without.pieces[1].isUsed);
  EXPECT_NE(without.pieces[1].reason.find("smaller than 5.0 ml"), std::string::npos);
  shapeton::ColonCenterlineSettings options;
  options.seedPoint = { itk::Point<double, 3>(shapeton::PartOf(truth, 0.87, 0.9).front().data()) };
  const ColonCenterline with = shapeton::TraceColonCenterline(mask.Get(), options);
  EXPECT_EQ(with.gaps.size(), 1u);
  EXPECT_TRUE(with.pieces[1].isUsed);
}

TEST(ColonCenterline, HasTheSameBytesForAnyNumberOfThreads)
{
  const TubePoints truth = shapeton::ColonCurve();
  TubeMask         mask(truth, 30.0, { 2.0, 2.0, 2.5 });
  mask.Paint(shapeton::PartOf(truth, 0.0, 0.5), 16.0);
  mask.Paint(shapeton::PartOf(truth, 0.54, 1.0), 16.0);
  basetest::ExpectSameWithAnyThreads([&] { return shapeton::TraceColonCenterline(mask.Get()).curve.V; }, { 2, 3 });
}

/** Subsamples by 2; a voxel is lumen only if its neighbors are, so that walls do not vanish. */
shapeton::LumenMask::Pointer
Coarser(const itk::Image<float, 3> * image)
{
  const auto size = image->GetBufferedRegion().GetSize();
  const auto mask = shapeton::LumenMask::New();
  mask->SetRegions(itk::Size<3>{ { size[0] / 2, size[1] / 2, size[2] / 2 } });
  mask->SetOrigin(image->GetOrigin());
  mask->SetDirection(image->GetDirection());
  mask->SetSpacing(image->GetSpacing() * 2.0);
  mask->Allocate(true);
  basetest::ForVoxels(mask, [&](const itk::Index<3> & coarse, const auto &) {
    bool isLumen = true;
    for (int corner = 0; corner < 8; ++corner)
    {
      itk::Index<3> index;
      for (int a = 0; a < 3; ++a)
      {
        index[a] = 2 * coarse[a] + (corner >> a & 1);
      }
      isLumen = isLumen && image->GetPixel(index) != 0.0F;
    }
    mask->SetPixel(coarse, isLumen ? 1 : 0);
  });
  return mask;
}

TEST(ColonCenterline, OfARealColonPassesAllOfItsParts)
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (folder == nullptr || *folder == 0)
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  const auto volume = shapeton::ReadVolume(std::string(folder) + "/ctc/colon-lumen-mask.nii.gz");
  const auto mask = Coarser(volume.image);
  const auto line = shapeton::TraceColonCenterline(mask);
  EXPECT_TRUE(IsInside(line, mask));
  // Read off projections of the mask: rectum, the low and high bends, the flexure on the right, the cecum.
  const TubePoints points = PointsOf(line);
  EXPECT_LT((points.front() - Eigen::Vector3d(-15, -4, -503)).norm(), 25.0);
  for (const Eigen::Vector3d & place : { Eigen::Vector3d(80, -40, -390),
                                         Eigen::Vector3d(50, -70, -395),
                                         Eigen::Vector3d(0, 60, -155),
                                         Eigen::Vector3d(-20, -80, -120),
                                         Eigen::Vector3d(-130, -20, -230) })
  {
    EXPECT_LT(DistanceTo(points, place), 40.0) << place.transpose();
  }
  EXPECT_LT((points.back() - Eigen::Vector3d(-49, -41, -305)).norm(), 40.0);
  EXPECT_GT(line.coverage, 0.85);
  EXPECT_NEAR(line.length, 2700.0, 270.0);
}

TEST(ColonCenterline, DoubtsThatANetIsTheLumenOfAColon)
{
  TubeMask mask({ { 0.0, 0.0, 0.0 }, { 405.0, 0.0, 405.0 } }, 15.0, { 3.0, 3.0, 3.0 });
  for (double at = 0.0; at <= 405.0; at += 45.0)
  {
    mask.Paint(shapeton::CurveThrough({ { at, 0.0, 0.0 }, { at, 0.0, 405.0 } }), 10.0);
    mask.Paint(shapeton::CurveThrough({ { 0.0, 0.0, at }, { 405.0, 0.0, at } }), 10.0);
  }
  const ColonCenterline line = shapeton::TraceColonCenterline(mask.Get());
  EXPECT_GT(line.merges.size(), 60u);
  EXPECT_NE(line.failure.find("far more than in a colon"), std::string::npos) << line.failure;
}

TEST(ColonCenterline, DoubtsThatALungIsTheLumenOfAColon)
{
  const TubePoints lobes = shapeton::CurveThrough({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 150.0 } });
  TubeMask         lung(lobes, 60.0, { 3.0, 3.0, 3.0 });
  lung.Paint(lobes, 55.0);
  const ColonCenterline line = shapeton::TraceColonCenterline(lung.Get());
  EXPECT_NE(line.failure.find("cm^2 on average"), std::string::npos) << line.failure;
  TubeMask megacolon(lobes, 60.0, { 3.0, 3.0, 3.0 });
  megacolon.Paint(lobes, 35.0);
  EXPECT_EQ(shapeton::TraceColonCenterline(megacolon.Get()).failure, "");
}

TEST(ColonCenterline, RefusesWhatHasNoColon)
{
  const TubePoints tube = Serpentine(1, 40.0, 30.0);
  TubeMask         mask(tube, 30.0, { 1.5, 1.5, 1.5 });
  EXPECT_THROW(shapeton::TraceColonCenterline(mask.Get()), shapeton::InputError);
  mask.Paint(tube, 4.0);
  EXPECT_TRUE(basetest::Refuses([&] { shapeton::TraceColonCenterline(mask.Get()); },
                                "no piece of lumen is at least 5.0 ml: the largest of 1 is 2."));
  mask.Paint(tube, 12.0);
  shapeton::ColonCenterlineSettings options;
  options.start = itk::Point<double, 3>(Eigen::Vector3d(0, 0, 500).data());
  EXPECT_THROW(shapeton::TraceColonCenterline(mask.Get(), options), shapeton::InputError);
  options = {};
  options.exponent = 0;
  EXPECT_THROW(shapeton::TraceColonCenterline(mask.Get(), options), shapeton::ParameterError);
}
} // namespace
