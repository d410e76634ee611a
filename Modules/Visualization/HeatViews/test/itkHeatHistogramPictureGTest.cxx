#include "itkHeatHistogramPicture.h"
#include "itkPictureTestUtilities.h"

#include "itkColorMap.h"

#include <cmath>
#include <stdexcept>

namespace
{
/** Objects whose heats converge to 0.1, 0.2 and 0.4 while the background cools down. */
itk::HeatHistogram
ConvergingLines()
{
  std::vector<std::uint64_t> timeSteps;
  for (unsigned int row = 0; row < 128; ++row)
  {
    timeSteps.push_back(10 * row);
  }
  itk::HeatHistogram histogram(timeSteps);
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
BrightnessOf(const itk::RGBColor & color)
{
  return color[0] + color[1] + color[2];
}

int
ColumnOf(double heat, const itk::HeatAxis & axis, const itk::PlotArea & area)
{
  const unsigned int bin = itk::HeatHistogram::BinOf(static_cast<float>(heat));
  const double       middle = 0.5 * (itk::HeatHistogram::LowerEdge(bin) + itk::HeatHistogram::LowerEdge(bin + 1));
  return area.left + static_cast<int>(std::lround(axis.PositionOf(middle) * (area.width - 1)));
}

bool
IsPink(const itk::RGBColor & color)
{
  return color == itk::MakeColor(255, 105, 180);
}
} // namespace

class HeatHistogramPicture : public testing::TestWithParam<itk::HeatScale>
{};

TEST_P(HeatHistogramPicture, LinesStandAtTheirPlaceInTheirColour)
{
  itk::HeatHistogramPictureOptions options;
  options.scale = GetParam();
  const itk::HeatHistogram histogram = ConvergingLines();
  const itk::HeatAxis      axis(histogram, options.scale);
  const auto               picture = itk::DrawHeatHistogram(histogram, options);
  const itk::PlotArea      area = itk::PlotAreaOf(options);
  const int                bottom = area.top + area.height - 3;
  std::vector<bool>        isLine(options.width, false);
  for (const double heat : { 0.1, 0.2, 0.4 })
  {
    const int           x = ColumnOf(heat, axis, area);
    const itk::RGBColor color = itk::At(picture, x, bottom);
    const itk::RGBColor expected = itk::HeatColor((x - area.left) / (area.width - 1.0));
    EXPECT_GT(BrightnessOf(color), 0.8 * BrightnessOf(expected)) << heat;
    for (int near = x - 4; near <= x + 4; ++near)
    {
      isLine[near] = true;
    }
  }
  // At the end there is nothing but the three lines.
  const itk::RGBColor dark = itk::At(picture, area.left - 2, bottom);
  for (int x = area.left; x < area.left + area.width; ++x)
  {
    EXPECT_TRUE(isLine[x] || itk::At(picture, x, bottom) == dark) << x;
  }
}

INSTANTIATE_TEST_SUITE_P(Scales,
                         HeatHistogramPicture,
                         testing::Values(itk::HeatScale::Equalized, itk::HeatScale::Normalized));

TEST(HeatHistogramPictures, TimeRunsDownwards)
{
  itk::HeatHistogram histogram({ 0, 1, 2, 3 });
  const float        first = 0.25F;
  const float        last = 0.75F;
  histogram.AddToRow(0, &first, 1);
  histogram.AddToRow(3, &last, 1);
  itk::HeatHistogramPictureOptions options;
  const auto                       picture = itk::DrawHeatHistogram(histogram, options);
  const itk::PlotArea              area = itk::PlotAreaOf(options);
  const itk::HeatAxis              axis(histogram);
  const int                        columns[2] = { ColumnOf(first, axis, area), ColumnOf(last, axis, area) };
  const itk::RGBColor              dark = itk::At(picture, area.left - 2, area.top + 1);
  for (int row = 0; row < 4; ++row)
  {
    const int y = area.top + (2 * row + 1) * area.height / 8;
    EXPECT_EQ(itk::At(picture, columns[0], y) != dark, row == 0) << row;
    EXPECT_EQ(itk::At(picture, columns[1], y) != dark, row == 3) << row;
  }
}

TEST(HeatHistogramPictures, TheBackgroundIsAWhiteLineAtTheLeft)
{
  itk::HeatHistogram histogram({ 0, 1 });
  histogram.AddToRow(1, std::vector<float>(1000, 0.0F).data(), 1000);
  const auto          picture = itk::DrawHeatHistogram(histogram);
  const itk::PlotArea area = itk::PlotAreaOf({});
  EXPECT_EQ(itk::At(picture, area.left - 6, area.top + 3 * area.height / 4), itk::MakeColor(255, 255, 255));
  EXPECT_LT(BrightnessOf(itk::At(picture, area.left - 6, area.top + area.height / 4)), 60.0);
}

TEST(HeatHistogramPictures, ChosenTimeStepsAreMarkedInPink)
{
  const itk::HeatHistogram         histogram = ConvergingLines();
  itk::HeatHistogramPictureOptions options;
  options.markedTimeSteps = { 1000, 20, 4000 }; // the last one was not recorded
  const auto          picture = itk::DrawHeatHistogram(histogram, options);
  const itk::PlotArea area = itk::PlotAreaOf(options);
  std::vector<int>    pinkRows;
  for (int y = area.top; y < area.top + area.height; ++y)
  {
    if (IsPink(itk::At(picture, area.left + area.width / 2, y)) && IsPink(itk::At(picture, area.left + 3, y)))
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
  const itk::HeatHistogram         histogram = ConvergingLines();
  itk::HeatHistogramPictureOptions options;
  options.range = { 0.15, 0.25 };
  const auto          picture = itk::DrawHeatHistogram(histogram, options);
  const itk::PlotArea area = itk::PlotAreaOf(options);
  const int           bottom = area.top + area.height - 3;
  int                 lit = 0;
  const itk::RGBColor dark = itk::At(picture, area.left - 2, bottom);
  for (int x = area.left; x < area.left + area.width; ++x)
  {
    lit += itk::At(picture, x, bottom) != dark ? 1 : 0;
  }
  EXPECT_GT(lit, 0);
  EXPECT_LE(lit, 9); // the line at 0.2 alone
  const itk::HeatAxis part(histogram, itk::HeatScale::Equalized, options.range);
  EXPECT_NE(itk::At(picture, ColumnOf(0.2, part, area), bottom), dark);
}

TEST(HeatHistogramPictures, EqualInputGivesEqualPictures)
{
  const itk::HeatHistogram histogram = ConvergingLines();
  EXPECT_EQ(itk::GreatestDifference(itk::DrawHeatHistogram(histogram), itk::DrawHeatHistogram(histogram)), 0);
}

TEST(HeatHistogramPictures, RefusesWhatCannotBeDrawn)
{
  EXPECT_THROW(itk::DrawHeatHistogram(itk::HeatHistogram()), std::invalid_argument);
  itk::HeatHistogramPictureOptions options;
  options.width = 599;
  EXPECT_THROW(itk::DrawHeatHistogram(ConvergingLines(), options), std::invalid_argument);
  options.width = 600;
  options.height = 400;
  EXPECT_NO_THROW(itk::DrawHeatHistogram(ConvergingLines(), options));
}

TEST(HeatHistogramPictures, Baseline)
{
  itk::HeatHistogramPictureOptions options;
  options.title = "Three lines";
  options.width = 720;
  options.height = 480;
  options.markedTimeSteps = { 100, 1000 };
  const double edges[4] = { 0.05, 0.15, 0.3, 0.45 };
  for (unsigned int i = 0; i < 3; ++i)
  {
    itk::HeatClass heatClass;
    heatClass.label = i + 1;
    heatClass.lowerHeat = edges[i];
    heatClass.upperHeat = edges[i + 1];
    heatClass.meanHeat = 0.1 * (1U << i);
    options.classes.push_back(heatClass);
  }
  itk::ExpectBaseline(itk::DrawHeatHistogram(ConvergingLines(), options), "itkHeatHistogramPicture.png");
}
