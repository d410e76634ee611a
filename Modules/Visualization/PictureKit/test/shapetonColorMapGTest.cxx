#include "shapetonColorMap.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Triple = std::array<double, 3>;

Triple
LinearOf(const shapeton::RGBColor & color)
{
  Triple linear;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double c = color[i] / 255.0;
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return linear;
}

/** CIELAB under D65. */
Triple
LabOf(const Triple & linear)
{
  const auto   f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
  const double x = f((0.4124 * linear[0] + 0.3576 * linear[1] + 0.1805 * linear[2]) / 0.95047);
  const double y = f(0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]);
  const double z = f((0.0193 * linear[0] + 0.1192 * linear[1] + 0.9505 * linear[2]) / 1.08883);
  return { 116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z) };
}

Triple
LabOf(const shapeton::RGBColor & color)
{
  return LabOf(LinearOf(color));
}

double
Difference(const Triple & a, const Triple & b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

using Matrix = std::array<std::array<double, 3>, 3>;

/** Linear sRGB as seen without red or green cones (Vienot, Brettel, Mollon 1999). */
constexpr Matrix normalSight{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
constexpr Matrix protanSight{ { { 0.11238, 0.88762, 0.0 }, { 0.11238, 0.88762, 0.0 }, { 0.00401, -0.00401, 1.0 } } };
constexpr Matrix deutanSight{ { { 0.29275, 0.70725, 0.0 }, { 0.29275, 0.70725, 0.0 }, { -0.02234, 0.02234, 1.0 } } };

/** CIELAB of a color for this type of vision. */
Triple
Seen(const shapeton::RGBColor & color, const Matrix & sight)
{
  const Triple linear = LinearOf(color);
  Triple       seen;
  for (unsigned int i = 0; i < 3; ++i)
  {
    seen[i] = std::clamp(sight[i][0] * linear[0] + sight[i][1] * linear[1] + sight[i][2] * linear[2], 0.0, 1.0);
  }
  return LabOf(seen);
}

/** The smallest difference (CIE 1976) between the colors of two labels that differ by at most `apart`. */
double
LeastDifference(unsigned int classes, unsigned int apart, const Matrix & sight)
{
  double least = 1000.0;
  for (unsigned int a = 1; a <= classes; ++a)
  {
    for (unsigned int b = a + 1; b <= std::min(classes, a + apart); ++b)
    {
      least = std::min(least, Difference(Seen(shapeton::ClassColor(a), sight), Seen(shapeton::ClassColor(b), sight)));
    }
  }
  return least;
}

double
HueOf(const shapeton::RGBColor & color)
{
  const double red = color[0];
  const double green = color[1];
  const double blue = color[2];
  const double greatest = std::max({ red, green, blue });
  const double span = greatest - std::min({ red, green, blue });
  if (greatest == red)
  {
    return 60.0 * (green - blue) / span;
  }
  return greatest == green ? 60.0 * (2.0 + (blue - red) / span) : 60.0 * (4.0 + (red - green) / span);
}
} // namespace

TEST(ColorMap, RunsFromBlueToRedThroughAllHues)
{
  const shapeton::RGBColor least = shapeton::HeatColor(0.0);
  const shapeton::RGBColor most = shapeton::HeatColor(1.0);
  EXPECT_GT(least[2], 2 * std::max(least[0], least[1]));
  EXPECT_GT(most[0], 3 * std::max(most[1], most[2]));
  double hue = HueOf(least);
  for (int i = 1; i <= 400; ++i)
  {
    const double next = HueOf(shapeton::HeatColor(i / 400.0));
    EXPECT_LE(next, hue + 1.0) << i; // rounding of channels
    hue = next;
  }
  EXPECT_EQ(shapeton::HeatColor(-3.0), least);
  EXPECT_EQ(shapeton::HeatColor(7.0), most);
  EXPECT_EQ(shapeton::HeatColor(std::nan("")), least);
}

TEST(ColorMap, EqualStepsLookEquallyDifferent)
{
  for (int i = 0; i < 32; ++i)
  {
    const auto a = LabOf(shapeton::HeatColor(i / 32.0));
    const auto b = LabOf(shapeton::HeatColor((i + 1) / 32.0));
    EXPECT_NEAR(Difference(a, b), 9.6, 1.2) << i;
  }
}

TEST(ColorMap, LightnessRisesOnceThenFallsAndStaysOffBlack)
{
  constexpr double turn = 22.0 / 32.0;
  double           previous = 0.0;
  for (int i = 0; i <= 320; ++i)
  {
    const double lightness = LabOf(shapeton::HeatColor(i / 320.0))[0];
    EXPECT_GT(lightness, 41.0);
    const bool isRising = i / 320.0 <= turn;
    EXPECT_TRUE(i == 0 || (isRising ? lightness > previous - 0.4 : lightness < previous + 0.4)) << i;
    previous = lightness;
  }
}

TEST(ColorMap, ClassesAreToldApartAlsoByTheColorBlind)
{
  for (const Matrix & sight : { normalSight, protanSight, deutanSight })
  {
    EXPECT_GT(LeastDifference(8, 7, sight), 39.0);
    EXPECT_GT(LeastDifference(12, 11, sight), 27.0);
    EXPECT_GT(LeastDifference(13, 1, sight), 28.0) << "consecutive classes, also where the colors repeat";
  }
  EXPECT_EQ(shapeton::ClassColor(13), shapeton::ClassColor(1));
}

TEST(ColorMap, ClassesStandOffBlackAndWhite)
{
  for (unsigned int label = 1; label <= 12; ++label)
  {
    for (const Matrix * const sight : { &normalSight, &protanSight, &deutanSight })
    {
      const bool isNormal = sight == &normalSight;
      const auto color = Seen(shapeton::ClassColor(label), *sight);
      EXPECT_GT(Difference(color, { 0.0, 0.0, 0.0 }), isNormal ? 57.0 : 39.0) << label;
      EXPECT_GT(Difference(color, { 100.0, 0.0, 0.0 }), isNormal ? 48.0 : 13.0) << label;
    }
  }
}

TEST(ColorMap, ClassesStandOffTheGraysOfAnImage)
{
  for (unsigned int label = 1; label <= 12; ++label)
  {
    const auto lab = LabOf(shapeton::ClassColor(label));
    EXPECT_GT(lab[0], 37.0) << label;
    EXPECT_GT(std::hypot(lab[1], lab[2]), 27.0) << label;
  }
}

TEST(ColorMap, NamesAndHexadecimalColors)
{
  EXPECT_EQ(*shapeton::ColorOf("red"), shapeton::MakeColor(255, 0, 0));
  EXPECT_EQ(*shapeton::ColorOf("SteelBlue"), shapeton::MakeColor(70, 130, 180));
  EXPECT_EQ(*shapeton::ColorOf("#0a0B0c"), shapeton::MakeColor(10, 11, 12));
  EXPECT_EQ(shapeton::HexOf(shapeton::MakeColor(10, 11, 252)), "#0a0bfc");
  for (const char * const wrong : { "", "reddish", "#12345", "#1234567", "#12345g", "0x123456", "# 12345" })
  {
    EXPECT_FALSE(shapeton::ColorOf(wrong)) << wrong;
  }
  EXPECT_NE(shapeton::ColorNames().find("yellow"), std::string::npos);
}
