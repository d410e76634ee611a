#include "shapetonColonDistension.h"

#include "shapetonExceptions.h"

#include "gtest/gtest.h"

namespace
{
/** 100 mm in unequal steps: radius 15 mm up to 40 mm, then a gap of 20 mm, then radius 4 mm. */
shapeton::CurveSet
Line()
{
  Eigen::VectorXd arc(8), radius(8), gap(8);
  arc << 0, 10, 40, 45, 55, 60, 70, 100;
  radius << 15, 15, 15, 2, 2, 4, 4, 4;
  gap << 0, 0, 0, 1, 1, 0, 0, 0;
  shapeton::CurveSet curve;
  curve.V = shapeton::VertexMatrix::Zero(8, 3);
  curve.V.col(2) = arc;
  curve.curves = { { 0, 1, 2, 3, 4, 5, 6, 7 } };
  curve.pointArrays = { { "arcLength", arc }, { "radius", radius }, { "gap", gap } };
  return curve;
}

TEST(ColonDistension, CountsLengthsNotPoints)
{
  const shapeton::ColonDistension whole = shapeton::MeasureDistension(Line());
  EXPECT_DOUBLE_EQ(whole.share, 0.4);
  EXPECT_DOUBLE_EQ(whole.meanCaliber, (40.0 * 30.0 + 40.0 * 8.0) / 100.0);
  EXPECT_DOUBLE_EQ(whole.collapsedLength, 20.0);
  EXPECT_DOUBLE_EQ(whole.leastCaliber, 0.0);
  EXPECT_DOUBLE_EQ(whole.largestCaliber, 30.0);
}

TEST(ColonDistension, CutsStepsAtBorders)
{
  EXPECT_DOUBLE_EQ(shapeton::MeasureDistension(Line(), 0.0, 25.0).share, 1.0);
  const shapeton::ColonDistension middle = shapeton::MeasureDistension(Line(), 25.0, 50.0);
  EXPECT_DOUBLE_EQ(middle.share, 15.0 / 25.0);
  EXPECT_DOUBLE_EQ(middle.collapsedLength, 10.0);
  const shapeton::ColonDistension rest = shapeton::MeasureDistension(Line(), 50.0, 200.0);
  EXPECT_DOUBLE_EQ(rest.share, 0.0);
  EXPECT_DOUBLE_EQ(rest.end, 100.0);
  EXPECT_DOUBLE_EQ(shapeton::MeasureDistension(Line(), 75.0, 90.0).leastCaliber, 8.0);
  EXPECT_DOUBLE_EQ(rest.meanCaliber, 40.0 * 8.0 / 50.0);
}

TEST(ColonDistension, TheAnalCanalEndsWhereTheLumenOpensOrAfterFourCentimeters)
{
  Eigen::VectorXd arc(5), radius(5);
  arc << 7, 17, 27, 45, 60;
  radius << 2, 4, 5, 3, 20;
  EXPECT_EQ(shapeton::EndOfAnalCanal(arc, radius), 17.0);
  radius[2] = 4.9;
  EXPECT_EQ(shapeton::EndOfAnalCanal(arc, radius), 45.0);
  arc[3] = 47.5; // 40.5 mm from the start
  EXPECT_EQ(shapeton::EndOfAnalCanal(arc, radius), 27.0);
  radius[0] = 8.0;
  EXPECT_LT(shapeton::EndOfAnalCanal(arc, radius), arc[0]);
}

TEST(ColonDistension, RefusesWhatHasNoLengthOrOrder)
{
  EXPECT_THROW(shapeton::MeasureDistension(Line(), 50.0, 20.0), shapeton::ParameterError);
  shapeton::CurveSet curve = Line();
  curve.pointArrays.pop_back();
  EXPECT_THROW(shapeton::MeasureDistension(curve), shapeton::InputError);
}
} // namespace
