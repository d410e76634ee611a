#include "shapetonColonAssessability.h"

#include "shapetonExceptions.h"
#include "shapetonTestImages.h"

#include "gtest/gtest.h"

#include <cmath>

namespace
{
using shapeton::ColonHindrance;

/** A straight tube along x with a radius of 12 mm and 1 mm voxels; the line is its axis. */
class Tube
{
public:
  explicit Tube(int length = 200) : m_Length(length)
  {
    m_Lumen.labels = basetest::NewImage<shapeton::ColonLumen::LabelImageType>(
      { { static_cast<itk::SizeValueType>(length), 30, 30 } }, { 1.0, 1.0, 1.0 }, { 0.0, -15.0, -15.0 });
    m_Lumen.gravity.Fill(0.0);
    m_Lumen.gravity[1] = 1.0;
    this->Fill(0, length, 12.0);
  }

  /** Gas within the radius, above `level` mm below the axis. */
  void
  Fill(int begin, int end, double radius, double level = 100.0)
  {
    basetest::ForVoxels(m_Lumen.labels, [&](const auto & index, const auto & p) {
      if (index[0] >= begin && index[0] < end)
      {
        m_Lumen.labels->SetPixel(index, std::hypot(p[1], p[2]) <= radius && p[1] <= level ? 1 : 0);
      }
    });
  }

  void
  AddLevel(double x, double depth, double area, bool isTagged)
  {
    shapeton::ColonLevel level;
    level.center[0] = x;
    level.center[1] = depth;
    level.center[2] = 0.0;
    level.area = area;
    level.isTagged = isTagged;
    level.isColon = true;
    m_Lumen.levels.push_back(level);
  }

  /** The line from `begin` to the end of the tube. */
  shapeton::CurveSet
  Line(int begin = 20, double radius = 12.0) const
  {
    const int          points = m_Length - 2 * begin;
    shapeton::CurveSet curve;
    curve.V = shapeton::VertexMatrix::Zero(points, 3);
    curve.curves.emplace_back();
    for (int i = 0; i < points; ++i)
    {
      curve.V(i, 0) = begin + i;
      curve.curves[0].push_back(i);
    }
    curve.pointArrays = { { "arcLength", curve.V.col(0).array() - begin, false },
                          { "radius", Eigen::VectorXd::Constant(points, radius), false },
                          { "gap", Eigen::VectorXd::Zero(points), true } };
    return curve;
  }

  std::vector<shapeton::HinderedStretch>
  Stretches(shapeton::CurveSet line) const
  {
    shapeton::MarkHindrances(m_Lumen, line);
    return shapeton::FindHinderedStretches(line);
  }

private:
  int                  m_Length;
  shapeton::ColonLumen m_Lumen;
};
} // namespace

TEST(ColonAssessability, AWideTubeIsAssessableAllAlong)
{
  EXPECT_TRUE(Tube().Stretches(Tube().Line()).empty());
  const shapeton::ColonAssessability all = shapeton::Assess({}, 0.0, 100.0);
  EXPECT_EQ(all.share, 1.0);
  EXPECT_EQ(all.Verdict(), "assessable");
  EXPECT_TRUE(all.Hindrances().empty());
}

TEST(ColonAssessability, TheAnalCanalIsNarrowByNature)
{
  shapeton::CurveSet line = Tube().Line();
  line.pointArrays[1].values.block(0, 0, 35, 1).setConstant(4.0);
  EXPECT_TRUE(Tube().Stretches(line).empty());
  line.pointArrays[1].values.block(0, 0, 60, 1).setConstant(4.0); // also in the rectum
  const auto stretches = Tube().Stretches(line);
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_EQ(stretches[0].begin, 40.5);
  EXPECT_EQ(stretches[0].end, 59.5);
}

TEST(ColonAssessability, NamesReadBack)
{
  for (int i = 0; i < shapeton::numberOfColonHindrances; ++i)
  {
    const auto hindrance = static_cast<ColonHindrance>(i);
    EXPECT_EQ(shapeton::HindranceOfName(shapeton::NameOf(hindrance)), hindrance);
  }
  EXPECT_EQ(shapeton::HindranceOfName(""), ColonHindrance::None);
  EXPECT_THROW(shapeton::HindranceOfName("Narrow"), shapeton::InputError);
}

TEST(ColonAssessability, NarrowStretchesCountAndSingleFoldsDoNot)
{
  shapeton::CurveSet line = Tube().Line();
  line.pointArrays[1].values.block(30, 0, 4, 1).setConstant(4.0); // the lip of a fold
  line.pointArrays[1].values.block(60, 0, 20, 1).setConstant(4.0);
  line.pointArrays[2].values.block(100, 0, 10, 1).setConstant(1.0);
  const auto stretches = Tube().Stretches(line);
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[0].hindrance, ColonHindrance::Narrow);
  EXPECT_EQ(stretches[0].begin, 59.5);
  EXPECT_EQ(stretches[0].end, 79.5);
  EXPECT_EQ(stretches[1].hindrance, ColonHindrance::NoLumen);
  EXPECT_EQ(stretches[1].begin, 99.0); // a gap extends to the points beside it
  EXPECT_EQ(stretches[1].end, 110.0);
  const shapeton::ColonAssessability part = shapeton::Assess(stretches, 60.0, 110.0);
  EXPECT_NEAR(part.share, (50.0 - 19.5 - 11.0) / 50.0, 1e-12);
  EXPECT_EQ(part.Verdict(), "notAssessable");
  EXPECT_EQ(part.Hindrances(), (std::vector<ColonHindrance>{ ColonHindrance::Narrow, ColonHindrance::NoLumen }));
  EXPECT_EQ(shapeton::HindranceAt(stretches, 70.0), ColonHindrance::Narrow);
  EXPECT_EQ(shapeton::HindranceAt(stretches, 90.0), ColonHindrance::None);
  // If the array is missing, the result follows from gap and radius.
  EXPECT_EQ(shapeton::FindHinderedStretches(line).size(), 2u);
}

TEST(ColonAssessability, UntaggedFluidHidesTheWallBelow)
{
  for (const bool isTagged : { false, true })
  {
    Tube tube;
    tube.Fill(60, 120, 12.0, 4.0);
    tube.AddLevel(90.0, 4.5, 60.0 * 20.0, isTagged);
    const auto stretches = tube.Stretches(tube.Line());
    ASSERT_EQ(stretches.size(), isTagged ? 0u : 1u);
    if (!isTagged)
    {
      EXPECT_EQ(stretches[0].hindrance, ColonHindrance::UntaggedFluid);
      EXPECT_NEAR(stretches[0].begin, 40.0, 1.0);
      EXPECT_NEAR(stretches[0].end, 100.0, 1.0);
    }
  }
  Tube flat; // a flat wall without a pool
  flat.Fill(60, 68, 12.0, 4.0);
  flat.AddLevel(64.0, 4.5, 80.0, false);
  EXPECT_TRUE(flat.Stretches(flat.Line()).empty());
}

TEST(ColonAssessability, WhatTheScanCutsIsNotSeen)
{
  const Tube tube;
  const auto stretches = tube.Stretches(tube.Line(5));
  ASSERT_EQ(stretches.size(), 2u);
  EXPECT_EQ(stretches[0].hindrance, ColonHindrance::CutByScan);
  EXPECT_EQ(stretches[0].begin, 0.0);
  EXPECT_NEAR(stretches[0].end, 8.5, 0.6); // distance to the border equals that to the wall
}

TEST(ColonAssessability, AGapBetweenTwoPlacesThatTheScanCutsLiesOutsideOfIt)
{
  for (const int turn : { 3, 40 }) // mm from the border to the end of the lumen
  {
    shapeton::CurveSet line = Tube().Line();
    const auto         points = static_cast<int>(line.V.rows());
    for (int i = 0; i < points; ++i)
    {
      const int  fromMiddle = std::abs(2 * i - points) / 2;
      const bool isGap = fromMiddle < 10;
      line.V(i, 0) = isGap ? turn - 5.0 : turn + fromMiddle - 10.0;
      line.pointArrays[2].values(i, 0) = isGap ? 1.0 : 0.0;
    }
    const auto stretches = Tube().Stretches(line);
    ASSERT_EQ(stretches.size(), 1U) << turn;
    EXPECT_EQ(stretches[0].hindrance, turn == 3 ? ColonHindrance::CutByScan : ColonHindrance::NoLumen);
  }
}

TEST(ColonAssessability, RefusesALineThatDoesNotTell)
{
  shapeton::CurveSet line = Tube().Line();
  line.pointArrays.pop_back();
  EXPECT_FALSE(shapeton::TellsHindrances(line));
  EXPECT_THROW(shapeton::FindHinderedStretches(line), shapeton::InputError);
}

TEST(ColonAssessability, OtherCurvesAreMarkedByTheirArcLength)
{
  shapeton::CurveSet taenia;
  taenia.V = shapeton::VertexMatrix::Zero(3, 3);
  taenia.curves = { { 0, 1, 2 } };
  taenia.pointArrays = { { "arcLength", Eigen::Vector3d(5.0, 15.0, 25.0), false } };
  shapeton::MarkHindrances({ { 10.0, 20.0, ColonHindrance::Narrow } }, taenia);
  const Eigen::VectorXd marks = shapeton::PointValues(taenia, "notAssessable", "the taenia");
  EXPECT_EQ(marks, Eigen::Vector3d(0.0, 4.0, 0.0));
}

TEST(ColonAssessability, JsonTellsWhy)
{
  const shapeton::Json json =
    shapeton::AssessabilityToJson(shapeton::Assess({ { 10.0, 30.0, ColonHindrance::UntaggedFluid } }, 0.0, 80.0));
  EXPECT_EQ(json["assessableShare"], 0.75);
  EXPECT_EQ(json["verdict"], "partly");
  ASSERT_EQ(json["reasons"].size(), 1u);
  EXPECT_EQ(json["reasons"][0]["reason"], "untaggedFluid");
  EXPECT_EQ(json["reasons"][0]["length"], 20.0);
}
