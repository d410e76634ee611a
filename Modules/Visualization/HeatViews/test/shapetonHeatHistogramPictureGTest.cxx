#include "shapetonHeatHistogramPicture.h"
#include "shapetonPictureTestUtilities.h"

#include "shapetonColorMap.h"

#include <cmath>
#include <stdexcept>

namespace shapeton
{
void
PrintTo(HeatScale scale, std::ostream * stream)
{
  *stream << (scale == HeatScale::Equalized ? "Equalized" : "Normalized");
}
} // namespace shapeton

namespace
{
/** Objects whose heat converges to 0.1, 0.2 and 0.4 while the background cools down. */
shapeton::HeatHistogram
ConvergingLines()
{
  std::vector<std::uint64_t> timeSteps;
  for (unsigned int row = 0; row < 128; ++row)
  {
    timeSteps.push_back(10 * row);
  }
  shapeton::HeatHistogram histogram(timeSteps);
  for (std::size_t row = 0; row < timeSteps.size(); ++row)
  {
    const double left = std::exp(-static_cast<double>(row) / 12.0);
    const auto   add = [&](double converged, double spread, int voxels) {
      for (int i = 0; i < voxels; ++i)
      {
        const auto heat = static_cast<float>(converged * (1.0 + spread * left * (2.0 * i / voxels - 1.0)));
        histogram.AddToRow(row, &heat, 1);
      }
    };
    add(0.1, 0.5, 200);
    add(0.2, 0.5, 300);
    add(0.4, 0.3, 500);
    for (int i = 0; i < 1500; ++i)
    {
      const auto heat = static_cast<float>(0.05 * left * left * left * (i + 1) / 1500.0);
      histogram.AddToRow(row, &heat, 1);
    }
  }
  return histogram;
}

double
BrightnessOf(const shapeton::RGBColor & color)
{
  return color[0] + color[1] + color[2];
}

int
ColumnOf(double heat, const shapeton::HeatAxis & axis, const shapeton::PlotArea & area)
{
  const unsigned int bin = shapeton::HeatHistogram::BinOf(static_cast<float>(heat));
  const double middle = 0.5 * (shapeton::HeatHistogram::LowerEdge(bin) + shapeton::HeatHistogram::LowerEdge(bin + 1));
  return area.left + static_cast<int>(std::lround(axis.PositionOf(middle) * (area.width - 1)));
}

bool
IsPink(const shapeton::RGBColor & color)
{
  return color == shapeton::MakeColor(255, 105, 180);
}
} // namespace

class HeatHistogramPicture : public testing::TestWithParam<shapeton::HeatScale>
{};

TEST_P(HeatHistogramPicture, LinesStandAtTheirPlaceInTheirColor)
{
  shapeton::HeatHistogramPictureOptions options;
  options.scale = GetParam();
  const shapeton::HeatHistogram histogram = ConvergingLines();
  const shapeton::HeatAxis      axis(histogram, options.scale);
  const auto                    picture = shapeton::DrawHeatHistogram(histogram, options);
  const shapeton::PlotArea      area = shapeton::PlotAreaOf(options);
  const int                     bottom = area.top + area.height - 3;
  std::vector<bool>             isLine(options.width, false);
  for (const double heat : { 0.1, 0.2, 0.4 })
  {
    const int                x = ColumnOf(heat, axis, area);
    const shapeton::RGBColor color = shapeton::At(picture, x, bottom);
    const shapeton::RGBColor expected = shapeton::HeatColor((x - area.left) / (area.width - 1.0));
    EXPECT_GT(BrightnessOf(color), 0.8 * BrightnessOf(expected)) << heat;
    for (int near = x - 4; near <= x + 4; ++near)
    {
      isLine[near] = true;
    }
  }
  // Only the three lines remain at the end.
  const shapeton::RGBColor dark = shapeton::At(picture, area.left - 2, bottom);
  for (int x = area.left; x < area.left + area.width; ++x)
  {
    EXPECT_TRUE(isLine[x] || shapeton::At(picture, x, bottom) == dark) << x;
  }
}

INSTANTIATE_TEST_SUITE_P(Scales,
                         HeatHistogramPicture,
                         testing::Values(shapeton::HeatScale::Equalized, shapeton::HeatScale::Normalized));

TEST(HeatHistogramPictures, TimeRunsDownwards)
{
  shapeton::HeatHistogram histogram({ 0, 1, 2, 3 });
  const float             first = 0.25F;
  const float             last = 0.75F;
  histogram.AddToRow(0, &first, 1);
  histogram.AddToRow(3, &last, 1);
  shapeton::HeatHistogramPictureOptions options;
  const auto                            picture = shapeton::DrawHeatHistogram(histogram, options);
  const shapeton::PlotArea              area = shapeton::PlotAreaOf(options);
  const shapeton::HeatAxis              axis(histogram);
  const int                             columns[2] = { ColumnOf(first, axis, area), ColumnOf(last, axis, area) };
  const shapeton::RGBColor              dark = shapeton::At(picture, area.left - 2, area.top + 1);
  for (int row = 0; row < 4; ++row)
  {
    const int y = area.top + (2 * row + 1) * area.height / 8;
    EXPECT_EQ(shapeton::At(picture, columns[0], y) != dark, row == 0) << row;
    EXPECT_EQ(shapeton::At(picture, columns[1], y) != dark, row == 3) << row;
  }
}

TEST(HeatHistogramPictures, TheBackgroundIsAWhiteLineAtTheLeft)
{
  shapeton::HeatHistogram histogram({ 0, 1 });
  histogram.AddToRow(1, std::vector<float>(1000, 0.0F).data(), 1000);
  const auto               picture = shapeton::DrawHeatHistogram(histogram);
  const shapeton::PlotArea area = shapeton::PlotAreaOf({});
  EXPECT_EQ(shapeton::At(picture, area.left - 6, area.top + 3 * area.height / 4), shapeton::MakeColor(255, 255, 255));
  EXPECT_LT(BrightnessOf(shapeton::At(picture, area.left - 6, area.top + area.height / 4)), 60.0);
}

TEST(HeatHistogramPictures, ChosenTimeStepsAreMarkedInPink)
{
  const shapeton::HeatHistogram         histogram = ConvergingLines();
  shapeton::HeatHistogramPictureOptions options;
  options.markedTimeSteps = { 1000, 20, 4000 }; // the last one was not recorded
  const auto               picture = shapeton::DrawHeatHistogram(histogram, options);
  const shapeton::PlotArea area = shapeton::PlotAreaOf(options);
  std::vector<int>         pinkRows;
  for (int y = area.top; y < area.top + area.height; ++y)
  {
    if (IsPink(shapeton::At(picture, area.left + area.width / 2, y)) && IsPink(shapeton::At(picture, area.left + 3, y)))
    {
      pinkRows.push_back(y);
    }
  }
  ASSERT_EQ(pinkRows.size(), 2U);
  EXPECT_NEAR(pinkRows[0], area.top + 2.5 / 128.0 * area.height, 1.0);
  EXPECT_NEAR(pinkRows[1], area.top + 100.5 / 128.0 * area.height, 1.0);
}

TEST(HeatHistogramPictures, APartOfTheHeatsFillsThePlot)
{
  const shapeton::HeatHistogram         histogram = ConvergingLines();
  shapeton::HeatHistogramPictureOptions options;
  options.ranges = { { 0.15, 0.25 } };
  const auto               picture = shapeton::DrawHeatHistogram(histogram, options);
  const shapeton::PlotArea area = shapeton::PlotAreaOf(options);
  const int                bottom = area.top + area.height - 3;
  int                      lit = 0;
  const shapeton::RGBColor dark = shapeton::At(picture, area.left - 2, bottom);
  for (int x = area.left; x < area.left + area.width; ++x)
  {
    lit += shapeton::At(picture, x, bottom) != dark ? 1 : 0;
  }
  EXPECT_GT(lit, 0);
  EXPECT_LE(lit, 9); // only the line at 0.2
  const shapeton::HeatAxis part(histogram, shapeton::HeatScale::Equalized, options.ranges.back());
  EXPECT_NE(shapeton::At(picture, ColumnOf(0.2, part, area), bottom), dark);
}

TEST(HeatHistogramPictures, AStripAboveShowsWhereARangeOpens)
{
  const shapeton::HeatHistogram         histogram = ConvergingLines();
  shapeton::HeatHistogramPictureOptions options;
  options.ranges = { { 0.15, 0.45 }, { 0.15, 0.25 } };
  const auto               picture = shapeton::DrawHeatHistogram(histogram, options);
  const shapeton::PlotArea area = shapeton::PlotAreaOf(options);
  const int                above = area.top - shapeton::PlotAreaOf({}).top;
  ASSERT_EQ(area.height, shapeton::PlotAreaOf({}).height - above);
  for (const std::size_t level : { 0, 1 })
  {
    const shapeton::HeatRange shown = level == 0 ? shapeton::HeatRange() : options.ranges[0];
    const shapeton::HeatAxis  axis(histogram, shapeton::HeatScale::Equalized, shown);
    const int                 y = area.top - above + static_cast<int>(level) * above / 2 + 3;
    for (const double heat : { 0.1, 0.2, 0.4 })
    {
      const int  x = ColumnOf(heat, axis, area);
      const bool isOpened = heat >= options.ranges[level].lower && heat <= options.ranges[level].upper;
      const bool isBright = shapeton::At(picture, x, y) == shapeton::HeatColor((x - area.left) / (area.width - 1.0));
      EXPECT_EQ(isBright, isOpened || (level == 1 && heat == 0.1 && axis.PositionOf(0.15) == 0.0)) << level << heat;
    }
  }
}

TEST(HeatHistogramPictures, AnyNumberOfRangesFits)
{
  shapeton::HeatHistogramPictureOptions options;
  options.height = 480;
  for (int i = 0; i < 40; ++i)
  {
    options.ranges.push_back({ 0.1 + 0.002 * i, 0.3 - 0.002 * i });
  }
  EXPECT_GT(shapeton::PlotAreaOf(options).height, 100);
  EXPECT_NO_THROW(shapeton::DrawHeatHistogram(ConvergingLines(), options));
}

TEST(HeatHistogramPictures, EqualInputGivesEqualPictures)
{
  const shapeton::HeatHistogram histogram = ConvergingLines();
  EXPECT_EQ(
    shapeton::GreatestDifference(shapeton::DrawHeatHistogram(histogram), shapeton::DrawHeatHistogram(histogram)), 0);
}

TEST(HeatHistogramPictures, RefusesWhatCannotBeDrawn)
{
  EXPECT_THROW(shapeton::DrawHeatHistogram(shapeton::HeatHistogram()), std::invalid_argument);
  shapeton::HeatHistogramPictureOptions options;
  options.width = 599;
  EXPECT_THROW(shapeton::DrawHeatHistogram(ConvergingLines(), options), std::invalid_argument);
  options.width = 600;
  options.height = 400;
  EXPECT_NO_THROW(shapeton::DrawHeatHistogram(ConvergingLines(), options));
}

TEST(HeatHistogramPictures, Baseline)
{
  shapeton::HeatHistogramPictureOptions options;
  options.title = "Three lines";
  options.width = 720;
  options.height = 480;
  options.markedTimeSteps = { 100, 1000 };
  const double edges[4] = { 0.05, 0.15, 0.3, 0.45 };
  for (unsigned int i = 0; i < 3; ++i)
  {
    shapeton::HeatClass heatClass;
    heatClass.label = i + 1;
    heatClass.lowerHeat = edges[i];
    heatClass.upperHeat = edges[i + 1];
    heatClass.meanHeat = 0.1 * (1U << i);
    options.classes.push_back(heatClass);
  }
  shapeton::ExpectBaseline(shapeton::DrawHeatHistogram(ConvergingLines(), options), "shapetonHeatHistogramPicture.png");
}
