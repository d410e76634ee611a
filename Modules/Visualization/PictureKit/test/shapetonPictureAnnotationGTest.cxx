#include "shapetonPictureAnnotation.h"

#include "shapetonAxisTicks.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonPlotFrame.h"

#include <cmath>
#include <limits>

namespace
{
const shapeton::RGBColor white = shapeton::MakeColor(255, 255, 255);
const shapeton::RGBColor ink = shapeton::MakeColor(30, 32, 38);

void
ExpectTicks(const std::vector<double> & ticks, const std::vector<double> & expected)
{
  ASSERT_EQ(ticks.size(), expected.size());
  for (std::size_t i = 0; i < ticks.size(); ++i)
  {
    EXPECT_NEAR(ticks[i], expected[i], 1e-9 * (1.0 + std::fabs(expected[i])));
  }
}
} // namespace

TEST(AxisTicks, RoundTicksAreRoundAndInside)
{
  ExpectTicks(shapeton::RoundTicks(0.0, 100.0, 10), { 0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100 });
  ExpectTicks(shapeton::RoundTicks(0.0, 100.0, 9), { 0, 20, 40, 60, 80, 100 });
  ExpectTicks(shapeton::RoundTicks(-3.0, 7.0, 4), { 0, 5 });
  ExpectTicks(shapeton::RoundTicks(0.11, 0.14, 3), { 0.11, 0.12, 0.13, 0.14 });
  EXPECT_TRUE(shapeton::RoundTicks(1.0, 1.0, 5).empty());
  EXPECT_TRUE(shapeton::RoundTicks(0.0, std::numeric_limits<double>::infinity(), 5).empty());
}

TEST(PictureAnnotation, AColorScaleClampsAndKnowsNoValue)
{
  shapeton::ColorScale scale{ "mm", 10.0, 30.0, shapeton::HeatColor };
  EXPECT_EQ(scale.ColorOf(20.0), shapeton::HeatColor(0.5));
  EXPECT_EQ(scale.ColorOf(-5.0), shapeton::HeatColor(0.0));
  EXPECT_EQ(scale.ColorOf(31.0), shapeton::HeatColor(1.0));
  EXPECT_EQ(scale.ColorOf(std::nan("")), shapeton::MakeColor(150, 150, 150));
  scale.upper = scale.lower;
  EXPECT_EQ(scale.ColorOf(10.0), shapeton::HeatColor(0.0));
  const double values[] = { 10.0, 30.0 };
  EXPECT_EQ(shapeton::ColorsOf(values, 2, { "mm", 10.0, 30.0, shapeton::HeatColor })[1], shapeton::HeatColor(1.0));
}

TEST(PictureAnnotation, AColorBarRunsUpwardsAndHasTicksAtItsColors)
{
  auto                       picture = shapeton::NewPicture(shapeton::colorBarWidth + 20, 240, white);
  const shapeton::ColorScale scale{ "mm", 0.0, 100.0, shapeton::HeatColor };
  shapeton::DrawColorBar(picture, 10, 20, 201, scale, ink);
  EXPECT_EQ(shapeton::At(picture, 12, 20), shapeton::HeatColor(1.0));
  EXPECT_EQ(shapeton::At(picture, 12, 220), shapeton::HeatColor(0.0));
  // 0, 50 and 100 at most 46 pixels apart: ticks every 50.
  EXPECT_EQ(shapeton::At(picture, 28, 120), ink);
  EXPECT_EQ(shapeton::At(picture, 12, 120), scale.ColorOf(50.0));
  EXPECT_EQ(shapeton::At(picture, 28, 110), white);
}

TEST(PlotFrame, TicksLieAtTheirValues)
{
  shapeton::PlotFrame frame;
  frame.left = 90;
  frame.top = 20;
  frame.width = 501;
  frame.height = 201;
  frame.x = { "x (mm)", 0.0, 1000.0 };
  frame.y = { "y (mm)", 0.0, 50.0 };
  auto picture = shapeton::NewPicture(640, 300, white);
  shapeton::DrawPlotFrame(picture, frame);
  EXPECT_EQ(frame.PixelOfX(400.0), 290.0);
  EXPECT_EQ(frame.PixelOfY(10.0), 180.0);
  for (const int x : { 90, 190, 290, 390, 490, 590 }) // every 200
  {
    EXPECT_EQ(shapeton::At(picture, x, 224), ink) << x;
    EXPECT_EQ(shapeton::At(picture, x + 20, 224), white) << x;
  }
  for (const int y : { 20, 60, 100, 140, 180, 220 }) // every 10
  {
    EXPECT_EQ(shapeton::At(picture, 87, y), ink) << y;
    EXPECT_EQ(shapeton::At(picture, 87, y - 10), white) << y;
  }
}
