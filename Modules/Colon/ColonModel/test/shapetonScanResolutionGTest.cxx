#include "shapetonScanResolution.h"

#include "shapetonTestImages.h"

#include "gtest/gtest.h"

#include <cmath>

namespace
{
using Grid = itk::Image<unsigned char, 3>;

Grid::Pointer
GridOf(double x, double y, double z)
{
  const double spacing[3] = { x, y, z };
  const auto   grid = Grid::New();
  grid->SetSpacing(spacing);
  return grid;
}

shapeton::ScanResolution
Measure(double x, double y, double z, double sliceThickness = 0.0, double smoothing = 0.0)
{
  return shapeton::MeasureScanResolution(GridOf(x, y, z), sliceThickness, smoothing);
}
} // namespace

TEST(ScanResolution, ThreeSamplesCrossTheSmallestPolyp)
{
  EXPECT_DOUBLE_EQ(Measure(0.8, 0.8, 0.8).smallestPolyp, 2.4);
  EXPECT_DOUBLE_EQ(Measure(1.25, 1.25, 2.0).smallestPolyp, 6.0);
  EXPECT_DOUBLE_EQ(Measure(1.25, 1.25, 3.0).smallestPolyp, 9.0);
  EXPECT_DOUBLE_EQ(Measure(3.0, 1.25, 1.25).smallestPolyp, 9.0); // slices along the first axis
  EXPECT_DOUBLE_EQ(Measure(0.7, 0.7, 2.0 + 1e-7).smallestPolyp, 6.0);
}

TEST(ScanResolution, OverlappingSlicesCountWithTheirThickness)
{
  const shapeton::ScanResolution overlapping = Measure(0.7, 0.7, 1.25, 2.5);
  EXPECT_DOUBLE_EQ(overlapping.blur, 2.5);
  EXPECT_DOUBLE_EQ(overlapping.smallestPolyp, 7.5);
  EXPECT_DOUBLE_EQ(Measure(0.7, 0.7, 2.5, 1.25).smallestPolyp, 7.5); // gaps between slices
}

TEST(ScanResolution, SmoothingAgainstNoiseBlurs)
{
  const shapeton::ScanResolution smoothed = Measure(0.8, 0.8, 0.8, 0.0, 0.6);
  EXPECT_NEAR(smoothed.blur, std::sqrt(0.64 + 8.0 * std::log(2.0) * 0.36), 1e-12);
  EXPECT_DOUBLE_EQ(smoothed.smallestPolyp, 4.9);
}

TEST(ScanResolution, DoesNotDependOnTheDirectionOfTheAxes)
{
  const auto oblique = GridOf(1.25, 1.25, 3.0);
  oblique->SetDirection(basetest::Rotation(0, std::asin(0.6)));
  EXPECT_DOUBLE_EQ(shapeton::MeasureScanResolution(oblique, 3.0, 0.0).smallestPolyp, 9.0);
}

TEST(ScanResolution, IsToldInWords)
{
  EXPECT_EQ(shapeton::InWords(Measure(1.25, 1.25, 2.0)), "1.25 x 1.25 x 2 mm: polyps of 6 mm and more are evaluable");
  EXPECT_EQ(shapeton::InWords(Measure(0.75, 0.75, 1.5, 3.0)),
            "0.75 x 0.75 x 1.5 mm, slices 3 mm thick: not evaluable for polyps below 9 mm");
}

TEST(ScanResolution, WarnsOfCoarseScansAndOfThickSlices)
{
  EXPECT_TRUE(shapeton::WarningsOf(Measure(1.25, 1.25, 2.0, 2.0)).empty());
  EXPECT_EQ(shapeton::WarningsOf(Measure(0.8, 0.8, 3.0)),
            shapeton::Remarks{ "the colon is not evaluable for polyps below 9 mm: in the coarsest direction, the scan "
                               "resolves 3 mm" });
  const shapeton::Remarks thick = shapeton::WarningsOf(Measure(0.8, 0.8, 3.0, 5.0));
  ASSERT_EQ(thick.size(), 2U);
  EXPECT_EQ(thick[1], "slices of 5 mm; CT colonography requires at most 3 mm");
}

TEST(ScanResolution, LimitIsStoredOnlyAboveSixMillimeters)
{
  shapeton::CurveSet fine, coarse;
  shapeton::SetNotAssessableBelow(Measure(1.25, 1.25, 2.0), fine);
  shapeton::SetNotAssessableBelow(Measure(1.25, 1.25, 2.5), coarse);
  EXPECT_TRUE(fine.fieldArrays.empty());
  EXPECT_EQ(shapeton::NotAssessableBelow(fine), 0.0);
  EXPECT_DOUBLE_EQ(shapeton::NotAssessableBelow(coarse), 7.5);
}
