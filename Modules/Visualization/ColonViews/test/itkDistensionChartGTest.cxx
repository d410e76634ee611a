#include "itkDistensionChart.h"

#include "itkPictureTestUtilities.h"
#include "itkTestFolder.h"
#include "itkTestColon.h"

#include <stdexcept>

namespace
{
const itk::RGBColor ink = itk::MakeColor(30, 32, 38);
const itk::RGBColor gapShade = itk::MakeColor(206, 208, 214);
const itk::RGBColor limit = itk::MakeColor(196, 44, 44);

class Chart
{
public:
  explicit Chart(const itk::TestColon & colon)
    : frame(itk::DistensionFrame(colon.centreline)), picture(itk::DrawDistensionChart(colon.centreline, {}))
  {}

  /** The colour at a distance and a calibre, mm. */
  itk::RGBColor
  At(double distance, double calibre) const
  {
    return itk::At(picture,
                   static_cast<int>(std::lround(frame.PixelOfX(distance))),
                   static_cast<int>(std::lround(frame.PixelOfY(calibre))));
  }

  itk::PlotFrame        frame;
  itk::Picture::Pointer picture;
};
} // namespace

TEST(DistensionChart, TicksAndValuesLieWhereTheyBelong)
{
  const itk::TestColon colon;
  const Chart          chart(colon);
  EXPECT_DOUBLE_EQ(chart.frame.x.upper, itk::TestColon::length);
  EXPECT_DOUBLE_EQ(chart.frame.y.upper, 21.6); // a little more than the greatest calibre
  const int bottom = chart.frame.top + chart.frame.height;
  for (const double distance : { 0.0, 20.0, 100.0, 180.0 }) // every 20 mm
  {
    const int x = static_cast<int>(std::lround(chart.frame.PixelOfX(distance)));
    EXPECT_EQ(itk::At(chart.picture, x, bottom + 3), ink) << distance;
    EXPECT_NE(itk::At(chart.picture, x + 8, bottom + 3), ink) << distance;
  }
  // Full below the curve, empty above it; the curve itself at 20 mm.
  const double wide = 0.8 * itk::TestColon::length;
  EXPECT_GT(chart.At(wide, 18.5)[2], chart.At(wide, 18.5)[0] + 30);
  EXPECT_EQ(chart.At(wide + 1.0, 21.0), itk::MakeColor(255, 255, 255));
  EXPECT_LT(chart.At(wide, 20.0)[0], 100);
}

TEST(DistensionChart, NarrowStretchesAndGapsAreTold)
{
  const itk::TestColon colon;
  const Chart          chart(colon);
  const double         narrow = 0.6 * itk::TestColon::length;
  EXPECT_GT(chart.At(narrow, 4.0)[0], chart.At(narrow, 4.0)[2] + 60); // orange
  EXPECT_EQ(chart.At(0.33 * itk::TestColon::length, 15.0), gapShade);
  EXPECT_EQ(chart.At(0.33 * itk::TestColon::length, 1.5), gapShade); // no calibre is made up
  EXPECT_NE(chart.At(0.28 * itk::TestColon::length, 15.0), gapShade);
  int dashes = 0;
  for (int x = 0; x < chart.frame.width; ++x)
  {
    const int y = static_cast<int>(std::lround(chart.frame.PixelOfY(10.0)));
    dashes += itk::At(chart.picture, chart.frame.left + x, y) == limit ? 1 : 0;
  }
  EXPECT_NEAR(dashes, 0.5 * chart.frame.width, 30);
}

TEST(DistensionChart, BordersOfSegmentsLieAtTheirDistances)
{
  const itk::TestColon colon;
  const auto           segments = itk::TestSegments();
  const itk::PlotFrame frame = itk::DistensionFrame(colon.centreline);
  const auto           picture = itk::DrawDistensionChart(colon.centreline, segments);
  for (const itk::ColonSegment & segment : segments)
  {
    const int x = static_cast<int>(std::lround(frame.PixelOfX(segment.begin)));
    EXPECT_LT(itk::At(picture, x, frame.top - 5)[0], 120) << segment.name;
    EXPECT_EQ(itk::At(picture, x + 6, frame.top - 5), itk::MakeColor(255, 255, 255)) << segment.name;
  }
}

TEST(DistensionChart, RefusesWhatCannotBeDrawn)
{
  itk::TestColon                    colon;
  const itk::DistensionChartOptions small{ "Distension", 499, 460 };
  EXPECT_THROW(itk::DrawDistensionChart(colon.centreline, {}, small), std::invalid_argument);
  colon.centreline.pointArrays.erase(colon.centreline.pointArrays.begin() + 1);
  const std::string message = basetest::MessageOf([&] { itk::DrawDistensionChart(colon.centreline, {}); });
  EXPECT_NE(message.find("radius"), std::string::npos) << message;
}

TEST(DistensionChart, Baseline)
{
  itk::ExpectBaseline(itk::DrawDistensionChart(itk::TestColon().centreline, itk::TestSegments()),
                      "itkDistensionChart.png");
}
