#include "shapetonDicomSeriesGeometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using shapeton::ExamineSlices;
using shapeton::SlicePlace;
using shapeton::SlicesGeometry;

constexpr double PixelSpacing[2] = { 0.8, 0.8 };

std::vector<SlicePlace>
PlacesAt(const std::vector<double> & positions)
{
  std::vector<SlicePlace> places;
  for (const double position : positions)
  {
    places.push_back({ position, { 0, 0 } });
  }
  return places;
}

SlicesGeometry
Examine(const std::vector<double> & positions)
{
  return ExamineSlices(PlacesAt(positions), PixelSpacing);
}
} // namespace

TEST(DicomSeriesGeometry, RegularWithMicrometersOfJitter)
{
  std::mt19937        random(1);
  std::vector<double> positions;
  for (int i = 0; i < 400; ++i)
  {
    positions.push_back(i * 0.625 + (static_cast<double>(random() % 1000) - 500) * 4e-6); // +-2 micrometers
  }
  const SlicesGeometry geometry = Examine(positions);
  EXPECT_TRUE(geometry.IsRegular());
  EXPECT_NEAR(geometry.spacing, 0.625, 0.004);
}

TEST(DicomSeriesGeometry, DisplacementsBelowTheToleranceAreRegularAndAboveAreNot)
{
  EXPECT_TRUE(Examine({ 0, 1, 2.009, 3, 4 }).IsRegular());
  EXPECT_TRUE(Examine({ 0, 1, 2.021, 3, 4 }).isVariable);
  // Tenths of a millimeter are negligible at 20 mm but not at 1 mm.
  EXPECT_TRUE(Examine({ 0, 20, 40.1, 60 }).IsRegular());
  // Positions in steps of 10 micrometers must not be merged by the tolerance.
  const SlicesGeometry fine = Examine({ 0, 0.01, 0.02, 0.03, 0.05 });
  EXPECT_TRUE(fine.duplicates.empty());
  EXPECT_EQ(fine.gaps.size(), 1u);
}

TEST(DicomSeriesGeometry, AccumulatedDriftIsVariableSpacing)
{
  std::vector<double> positions{ 0 };
  for (int i = 0; i < 100; ++i)
  {
    positions.push_back(positions.back() + 1 + 0.009 * (i < 50 ? -1 : 1)); // each distance is within 1 %
  }
  EXPECT_TRUE(Examine(positions).isVariable);
}

TEST(DicomSeriesGeometry, GapsAreCounted)
{
  const SlicesGeometry geometry = Examine({ 0, 1, 2, 5, 6, 7, 9, 10 });
  ASSERT_EQ(geometry.gaps.size(), 2u);
  EXPECT_EQ(geometry.gaps[0].before, 2u);
  EXPECT_EQ(geometry.gaps[0].missing, 2u);
  EXPECT_EQ(geometry.gaps[1].before, 5u);
  EXPECT_EQ(geometry.gaps[1].missing, 1u);
  EXPECT_FALSE(geometry.isVariable);
  EXPECT_DOUBLE_EQ(geometry.spacing, 1.0);
}

TEST(DicomSeriesGeometry, AGapBehindADuplicate)
{
  const SlicesGeometry geometry = Examine({ 0, 1, 2, 2, 4, 5 });
  ASSERT_EQ(geometry.gaps.size(), 1u);
  EXPECT_EQ(geometry.gaps[0].before, 2u);
  EXPECT_EQ(geometry.gaps[0].after, 4u);
  EXPECT_EQ(geometry.gaps[0].missing, 1u);
}

TEST(DicomSeriesGeometry, ADoubledDistanceForGoodIsVariableSpacing)
{
  const SlicesGeometry geometry = Examine({ 0, 1, 2, 3, 4, 5, 7, 9, 11, 13 });
  EXPECT_TRUE(geometry.isVariable);
  EXPECT_TRUE(geometry.gaps.empty());
  EXPECT_EQ(geometry.unusual, (std::vector<unsigned int>{ 5, 6, 7, 8 }));
}

TEST(DicomSeriesGeometry, DuplicatesAreCounted)
{
  const SlicesGeometry geometry = Examine({ 0, 1, 1.000001, 1.000002, 2, 3, 3 });
  ASSERT_EQ(geometry.duplicates.size(), 2u);
  EXPECT_EQ(geometry.duplicates[0].first, 1u);
  EXPECT_EQ(geometry.duplicates[0].count, 3u);
  EXPECT_EQ(geometry.duplicates[1].first, 5u);
  EXPECT_EQ(geometry.duplicates[1].count, 2u);
  EXPECT_TRUE(geometry.gaps.empty());
  EXPECT_FALSE(geometry.isVariable);
}

TEST(DicomSeriesGeometry, EachSliceTwiceHasTheSpacingOfOne)
{
  const SlicesGeometry geometry = Examine({ 0, 0, 1.5, 1.5, 3, 3, 4.5, 4.5 });
  EXPECT_DOUBLE_EQ(geometry.spacing, 1.5);
  EXPECT_EQ(geometry.duplicates.size(), 4u);
}

TEST(DicomSeriesGeometry, TiltIsMeasured)
{
  std::vector<SlicePlace> places;
  const double            tilt = std::tan(15.0 * std::acos(-1.0) / 180.0);
  for (int i = 0; i < 20; ++i)
  {
    places.push_back({ 1.25 * i, { 0, -tilt * 1.25 * i } });
  }
  const SlicesGeometry geometry = ExamineSlices(places, PixelSpacing);
  EXPECT_TRUE(geometry.isSheared);
  EXPECT_TRUE(geometry.isLinearShear);
  EXPECT_NEAR(geometry.tiltDegrees, 15.0, 1e-9);
  places[7].offset[0] = 3;
  const SlicesGeometry irregular = ExamineSlices(places, PixelSpacing);
  EXPECT_TRUE(irregular.isSheared);
  EXPECT_FALSE(irregular.isLinearShear);
}

TEST(DicomSeriesGeometry, FewSlices)
{
  EXPECT_TRUE(Examine({}).IsRegular());
  EXPECT_TRUE(Examine({ 3 }).IsRegular());
  EXPECT_EQ(Examine({ 3 }).spacing, 0.0);
  EXPECT_TRUE(Examine({ 3, 8 }).IsRegular());
  EXPECT_EQ(Examine({ 3, 8 }).spacing, 5.0);
  EXPECT_EQ(Examine({ 3, 3 }).duplicates.size(), 1u);
}
