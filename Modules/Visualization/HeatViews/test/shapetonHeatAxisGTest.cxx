#include "shapetonHeatAxis.h"

#include "shapetonColorMap.h"

#include "gtest/gtest.h"

#include <stdexcept>

namespace
{
/** Two equal rows: 100 voxels at 0.1, 300 at 0.2, 600 at 0.4, and 5000 background voxels. */
shapeton::HeatHistogram
ThreeLines()
{
  shapeton::HeatHistogram histogram({ 0, 1000 });
  for (std::size_t row = 0; row < 2; ++row)
  {
    histogram.AddToRow(row, std::vector<float>(5000, 0.0F).data(), 5000);
    histogram.AddToRow(row, std::vector<float>(100, 0.1F).data(), 100);
    histogram.AddToRow(row, std::vector<float>(300, 0.2F).data(), 300);
    histogram.AddToRow(row, std::vector<float>(600, 0.4F).data(), 600);
  }
  return histogram;
}

double
MiddleOfBin(float heat)
{
  const unsigned int bin = shapeton::HeatHistogram::BinOf(heat);
  return 0.5 * (shapeton::HeatHistogram::LowerEdge(bin) + shapeton::HeatHistogram::LowerEdge(bin + 1));
}
} // namespace

TEST(HeatAxis, EqualizedPositionsAreSharesOfCountsWithoutBackground)
{
  const shapeton::HeatAxis axis(ThreeLines());
  EXPECT_NEAR(axis.PositionOf(MiddleOfBin(0.1F)), 0.05, 1e-6);
  EXPECT_NEAR(axis.PositionOf(MiddleOfBin(0.2F)), 0.10 + 0.15, 1e-6);
  EXPECT_NEAR(axis.PositionOf(MiddleOfBin(0.4F)), 0.40 + 0.30, 1e-6);
  EXPECT_NEAR(axis.PositionOf(0.15), 0.1, 1e-12);
  EXPECT_EQ(axis.PositionOf(0.0), 0.0);
  EXPECT_EQ(axis.PositionOf(1.0), 1.0);
}

TEST(HeatAxis, NormalizedPositionsAreProportionalToHeat)
{
  const shapeton::HeatAxis axis(ThreeLines(), shapeton::HeatScale::Normalized);
  const double             upper = axis.GetRange().upper;
  EXPECT_GE(upper, 0.4);
  EXPECT_LT(upper, 0.403);
  EXPECT_EQ(axis.GetRange().lower, 0.0);
  EXPECT_NEAR(axis.PositionOf(0.1), 0.1 / upper, 1e-12);
  EXPECT_NEAR(axis.HeatAt(0.25), 0.25 * upper, 1e-12);
}

TEST(HeatAxis, PositionNeverFallsAndHeatAtInvertsIt)
{
  shapeton::HeatHistogram histogram({ 5 });
  unsigned int            state = 7;
  for (int i = 0; i < 20000; ++i)
  {
    state = state * 1664525U + 1013904223U;
    const float heat = static_cast<float>(state >> 8) / (1U << 24);
    const float spread = heat * heat * heat;
    histogram.AddToRow(0, &spread, 1);
  }
  const shapeton::HeatAxis axis(histogram);
  double                   previous = 0.0;
  for (int i = 0; i <= 1000; ++i)
  {
    const double heat = i / 1000.0;
    EXPECT_GE(axis.PositionOf(heat), previous);
    previous = axis.PositionOf(heat);
    EXPECT_NEAR(axis.PositionOf(axis.HeatAt(heat)), heat, 1e-9);
  }
}

TEST(HeatAxis, APartIsEqualizedAnew)
{
  const shapeton::HeatAxis part(ThreeLines(), shapeton::HeatScale::Equalized, { 0.05, 0.3 });
  // 100 and 300 voxels remain.
  EXPECT_NEAR(part.PositionOf(MiddleOfBin(0.1F)), 0.125, 1e-6);
  EXPECT_NEAR(part.PositionOf(MiddleOfBin(0.2F)), 0.25 + 0.375, 1e-6);
  EXPECT_EQ(part.PositionOf(0.4), 1.0);
  EXPECT_EQ(part.PositionOf(0.01), 0.0);
}

TEST(HeatAxis, WithoutCountsAllBinsAreEquallyWide)
{
  const shapeton::HeatAxis empty(shapeton::HeatHistogram({ 0 }));
  EXPECT_NEAR(empty.PositionOf(1.0 / 256.0), 0.5, 1e-3);
  const shapeton::HeatAxis gap(ThreeLines(), shapeton::HeatScale::Equalized, { 0.5, 1.0 });
  EXPECT_NEAR(gap.PositionOf(0.75), 0.5, 1e-9);
}

TEST(HeatAxis, ColorsFollowThePosition)
{
  const shapeton::HeatAxis axis(ThreeLines());
  EXPECT_EQ(axis.ColorOf(0.15), shapeton::HeatColor(0.1));
  EXPECT_EQ(axis.ColorOf(1.0), shapeton::HeatColor(1.0));
  // 0.1 is not at the center of its bin, but its line has the color of the center.
  EXPECT_EQ(axis.ColorOf(0.1), shapeton::HeatColor(0.05));
  EXPECT_EQ(axis.ColorOf(0.4), shapeton::HeatColor(0.7));
  EXPECT_EQ(shapeton::HeatAxis(ThreeLines(), shapeton::HeatScale::Normalized, { 0.0, 0.5 }).ColorOf(0.1),
            shapeton::HeatColor(0.2));
}

TEST(HeatAxis, RefusesWrongRanges)
{
  const shapeton::HeatHistogram histogram = ThreeLines();
  const auto                    make = [&](double lower, double upper) {
    return shapeton::HeatAxis(histogram, shapeton::HeatScale::Equalized, { lower, upper });
  };
  EXPECT_THROW(make(0.3, 0.2), std::invalid_argument);
  EXPECT_THROW(make(-0.1, 0.2), std::invalid_argument);
  EXPECT_THROW(make(0.1, 1.2), std::invalid_argument);
  EXPECT_THROW(make(0.1, 0.1), std::invalid_argument);
}
