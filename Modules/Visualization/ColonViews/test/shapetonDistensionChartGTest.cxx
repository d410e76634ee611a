#include "shapetonDistensionChart.h"

#include "shapetonPictureTestUtilities.h"
#include "shapetonTestFolder.h"
#include "shapetonTestColon.h"

#include <stdexcept>

namespace
{
const shapeton::RGBColor ink = shapeton::MakeColor(30, 32, 38);
const shapeton::RGBColor gapShade = shapeton::MakeColor(206, 208, 214);
const shapeton::RGBColor limit = shapeton::MakeColor(196, 44, 44);

class Chart
{
public:
  explicit Chart(const shapeton::TestColon & colon)
    : frame(shapeton::DistensionFrame(colon.centerline)), picture(shapeton::DrawDistensionChart(colon.centerline, {}))
  {}

  /** The color at a distance and a caliber, mm. */
  shapeton::RGBColor
  At(double distance, double caliber) const
  {
    return shapeton::At(picture,
                        static_cast<int>(std::lround(frame.PixelOfX(distance))),
                        static_cast<int>(std::lround(frame.PixelOfY(caliber))));
  }

  shapeton::PlotFrame        frame;
  shapeton::Picture::Pointer picture;
};
} // namespace

TEST(DistensionChart, TicksAndValuesLieWhereTheyBelong)
{
  const shapeton::TestColon colon;
  const Chart               chart(colon);
  EXPECT_DOUBLE_EQ(chart.frame.x.upper, shapeton::TestColon::length);
  EXPECT_DOUBLE_EQ(chart.frame.y.upper, 21.6); // slightly more than the greatest caliber
  const int bottom = chart.frame.top + chart.frame.height;
  for (const double distance : { 0.0, 20.0, 100.0, 180.0 }) // every 2 cm
  {
    const int x = static_cast<int>(std::lround(chart.frame.PixelOfX(distance)));
    EXPECT_EQ(shapeton::At(chart.picture, x, bottom + 3), ink) << distance;
    EXPECT_NE(shapeton::At(chart.picture, x + 8, bottom + 3), ink) << distance;
  }
  // Full below the curve, empty above it; the curve itself at 20 mm.
  const double wide = 0.8 * shapeton::TestColon::length;
  EXPECT_GT(chart.At(wide, 18.5)[2], chart.At(wide, 18.5)[0] + 30);
  EXPECT_EQ(chart.At(wide + 1.0, 21.0), shapeton::MakeColor(255, 255, 255));
  EXPECT_LT(chart.At(wide, 20.0)[0], 100);
}

TEST(DistensionChart, NarrowStretchesAndGapsAreTold)
{
  const shapeton::TestColon colon;
  const Chart               chart(colon);
  const double              narrow = 0.6 * shapeton::TestColon::length;
  EXPECT_GT(chart.At(narrow, 4.0)[0], chart.At(narrow, 4.0)[2] + 60); // orange
  EXPECT_EQ(chart.At(0.33 * shapeton::TestColon::length, 15.0), gapShade);
  EXPECT_EQ(chart.At(0.33 * shapeton::TestColon::length, 1.5), gapShade); // no caliber in a gap
  EXPECT_NE(chart.At(0.28 * shapeton::TestColon::length, 15.0), gapShade);
  int dashes = 0;
  for (int x = 0; x < chart.frame.width; ++x)
  {
    const int y = static_cast<int>(std::lround(chart.frame.PixelOfY(10.0)));
    dashes += shapeton::At(chart.picture, chart.frame.left + x, y) == limit ? 1 : 0;
  }
  EXPECT_NEAR(dashes, 0.5 * chart.frame.width, 30);
}

TEST(DistensionChart, BordersOfSegmentsLieAtTheirDistances)
{
  const shapeton::TestColon colon;
  const auto                segments = shapeton::TestSegments();
  const shapeton::PlotFrame frame = shapeton::DistensionFrame(colon.centerline);
  const auto                picture = shapeton::DrawDistensionChart(colon.centerline, segments);
  for (const shapeton::ColonSegment & segment : segments)
  {
    const int x = static_cast<int>(std::lround(frame.PixelOfX(segment.begin)));
    EXPECT_LT(shapeton::At(picture, x, frame.top - 5)[0], 120) << segment.name;
    EXPECT_EQ(shapeton::At(picture, x + 6, frame.top - 5), shapeton::MakeColor(255, 255, 255)) << segment.name;
  }
}

TEST(DistensionChart, RefusesWhatCannotBeDrawn)
{
  shapeton::TestColon                    colon;
  const shapeton::DistensionChartOptions small{ "Distension", 499, 460 };
  EXPECT_THROW(shapeton::DrawDistensionChart(colon.centerline, {}, small), std::invalid_argument);
  colon.centerline.pointArrays.erase(colon.centerline.pointArrays.begin() + 1);
  const std::string message = basetest::MessageOf([&] { shapeton::DrawDistensionChart(colon.centerline, {}); });
  EXPECT_NE(message.find("radius"), std::string::npos) << message;
}

TEST(DistensionChart, Baseline)
{
  shapeton::ExpectBaseline(shapeton::DrawDistensionChart(shapeton::TestColon().centerline, shapeton::TestSegments()),
                           "shapetonDistensionChart.png");
}
