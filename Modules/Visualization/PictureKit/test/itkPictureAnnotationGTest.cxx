#include "itkPictureAnnotation.h"

#include "itkAxisTicks.h"
#include "itkPictureTestUtilities.h"
#include "itkPlotFrame.h"

#include <cmath>
#include <limits>

namespace
{
const itk::RGBColor white = itk::MakeColor(255, 255, 255);
const itk::RGBColor ink = itk::MakeColor(30, 32, 38);

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
  ExpectTicks(itk::RoundTicks(0.0, 100.0, 10), { 0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100 });
  ExpectTicks(itk::RoundTicks(0.0, 100.0, 9), { 0, 20, 40, 60, 80, 100 });
  ExpectTicks(itk::RoundTicks(-3.0, 7.0, 4), { 0, 5 });
  ExpectTicks(itk::RoundTicks(0.11, 0.14, 3), { 0.11, 0.12, 0.13, 0.14 });
  EXPECT_TRUE(itk::RoundTicks(1.0, 1.0, 5).empty());
  EXPECT_TRUE(itk::RoundTicks(0.0, std::numeric_limits<double>::infinity(), 5).empty());
}

TEST(PictureAnnotation, AColorScaleClampsAndKnowsNoValue)
{
  itk::ColorScale scale{ "mm", 10.0, 30.0, itk::HeatColor };
  EXPECT_EQ(scale.ColorOf(20.0), itk::HeatColor(0.5));
  EXPECT_EQ(scale.ColorOf(-5.0), itk::HeatColor(0.0));
  EXPECT_EQ(scale.ColorOf(31.0), itk::HeatColor(1.0));
  EXPECT_EQ(scale.ColorOf(std::nan("")), itk::MakeColor(150, 150, 150));
  scale.upper = scale.lower;
  EXPECT_EQ(scale.ColorOf(10.0), itk::HeatColor(0.0));
  const double values[] = { 10.0, 30.0 };
  EXPECT_EQ(itk::ColorsOf(values, 2, { "mm", 10.0, 30.0, itk::HeatColor })[1], itk::HeatColor(1.0));
}

TEST(PictureAnnotation, AColorBarRunsUpwardsAndHasTicksAtItsColours)
{
  auto                  picture = itk::NewPicture(itk::colorBarWidth + 20, 240, white);
  const itk::ColorScale scale{ "mm", 0.0, 100.0, itk::HeatColor };
  itk::DrawColorBar(picture, 10, 20, 201, scale, ink);
  EXPECT_EQ(itk::At(picture, 12, 20), itk::HeatColor(1.0));
  EXPECT_EQ(itk::At(picture, 12, 220), itk::HeatColor(0.0));
  // 0, 50 and 100 at most 46 pixels apart: ticks every 50.
  EXPECT_EQ(itk::At(picture, 28, 120), ink);
  EXPECT_EQ(itk::At(picture, 12, 120), scale.ColorOf(50.0));
  EXPECT_EQ(itk::At(picture, 28, 110), white);
}

TEST(PlotFrame, TicksLieAtTheirValues)
{
  itk::PlotFrame frame;
  frame.left = 90;
  frame.top = 20;
  frame.width = 501;
  frame.height = 201;
  frame.x = { "x (mm)", 0.0, 1000.0 };
  frame.y = { "y (mm)", 0.0, 50.0 };
  auto picture = itk::NewPicture(640, 300, white);
  itk::DrawPlotFrame(picture, frame);
  EXPECT_EQ(frame.PixelOfX(400.0), 290.0);
  EXPECT_EQ(frame.PixelOfY(10.0), 180.0);
  for (const int x : { 90, 190, 290, 390, 490, 590 }) // every 200
  {
    EXPECT_EQ(itk::At(picture, x, 224), ink) << x;
    EXPECT_EQ(itk::At(picture, x + 20, 224), white) << x;
  }
  for (const int y : { 20, 60, 100, 140, 180, 220 }) // every 10
  {
    EXPECT_EQ(itk::At(picture, 87, y), ink) << y;
    EXPECT_EQ(itk::At(picture, 87, y - 10), white) << y;
  }
}
