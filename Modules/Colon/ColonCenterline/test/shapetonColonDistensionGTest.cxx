#include "shapetonColonDistension.h"

#include "shapetonExceptions.h"

#include "gtest/gtest.h"

namespace
{
shapeton::SurfaceArray
Array(const std::string & name, const Eigen::VectorXd & values)
{
  shapeton::SurfaceArray array;
  array.name = name;
  array.values = values;
  return array;
}

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
  curve.pointArrays = { Array("arcLength", arc), Array("radius", radius), Array("gap", gap) };
  return curve;
}

TEST(ColonDistension, CountsLengthsNotPoints)
{
  const auto whole = shapeton::MeasureDistension(Line(), { { "colon", 0.0 } });
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_DOUBLE_EQ(whole[0].share, 0.4);
  EXPECT_DOUBLE_EQ(whole[0].meanCaliber, (40.0 * 30.0 + 40.0 * 8.0) / 100.0);
  EXPECT_DOUBLE_EQ(whole[0].collapsedLength, 20.0);
}

TEST(ColonDistension, CutsStepsAtBorders)
{
  const auto parts = shapeton::MeasureDistension(Line(), { { "a", 25.0 }, { "b", 50.0 }, { "c", 0.0 + 50.0 } });
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_DOUBLE_EQ(parts[0].share, 1.0);
  EXPECT_DOUBLE_EQ(parts[1].share, 15.0 / 25.0);
  EXPECT_DOUBLE_EQ(parts[1].collapsedLength, 10.0);
  EXPECT_DOUBLE_EQ(parts[2].share, 0.0);
  EXPECT_DOUBLE_EQ(parts[2].end, 100.0);
  EXPECT_DOUBLE_EQ(parts[2].meanCaliber, 40.0 * 8.0 / 50.0);
}

TEST(ColonDistension, CustomarySegmentsCoverTheWholeLine)
{
  const auto segments = shapeton::MeasureDistension(Line());
  ASSERT_EQ(segments.size(), 6u);
  double length = 0.0;
  double distended = 0.0;
  for (const auto & segment : segments)
  {
    length += segment.end - segment.begin;
    distended += segment.share * (segment.end - segment.begin);
  }
  EXPECT_NEAR(length, 100.0, 1e-9);
  EXPECT_NEAR(distended, 40.0, 1e-9);
  EXPECT_EQ(segments.front().name, "rectum");
  EXPECT_EQ(segments.back().name, "cecum");
}

TEST(ColonDistension, RefusesWhatHasNoLengthOrOrder)
{
  EXPECT_THROW(shapeton::MeasureDistension(Line(), {}), shapeton::ParameterError);
  EXPECT_THROW(shapeton::MeasureDistension(Line(), { { "a", 50.0 }, { "b", 20.0 } }), shapeton::ParameterError);
  shapeton::CurveSet curve = Line();
  curve.pointArrays.pop_back();
  EXPECT_THROW(shapeton::MeasureDistension(curve), shapeton::InputError);
}
} // namespace
