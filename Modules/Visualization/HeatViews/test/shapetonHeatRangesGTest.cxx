#include "shapetonHeatRanges.h"

#include "shapetonTestErrors.h"
#include "shapetonJson.h"

#include "gtest/gtest.h"

#include <cmath>

namespace
{
/** The heat at a bin coordinate: 2002.5 is the middle of bin 2002. */
double
HeatAt(double coordinate)
{
  const auto   bin = static_cast<unsigned int>(coordinate);
  const double lower = shapeton::HeatHistogram::LowerEdge(bin);
  return lower + (coordinate - bin) * (shapeton::HeatHistogram::LowerEdge(bin + 1) - lower);
}

shapeton::HeatHistogram
HistogramOf(const shapeton::Json & rows)
{
  shapeton::HeatHistogram histogram(std::vector<std::uint64_t>(rows.size(), 0));
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    std::vector<std::uint32_t> counts(shapeton::HeatHistogram::NumberOfBins, 0);
    for (const auto & entry : rows[row])
    {
      counts[entry[0].get<std::size_t>()] = entry[1].get<std::uint32_t>();
    }
    histogram.AddToRow(row, counts.data());
  }
  return histogram;
}

/** Error message of HeatRangesOf(). */
std::string
ErrorOf(const std::vector<double> & ends)
{
  return basetest::ErrorOf<shapeton::ParameterError>([&] { shapeton::HeatRangesOf(ends); });
}
} // namespace

TEST(HeatRanges, NestedAxesAreThoseOfTheExplorer)
{
  const shapeton::Json example = shapeton::ReadJson(SHAPETON_NESTED_RANGES);
  const auto           histogram = HistogramOf(example["rows"]);
  std::vector<double>  ends;
  for (const auto & level : example["levels"])
  {
    ends.push_back(HeatAt(level["bins"][0]));
    ends.push_back(HeatAt(level["bins"][1]));
    const shapeton::HeatRange range = shapeton::HeatRangesOf(ends).back();
    const shapeton::HeatAxis  axis(histogram, shapeton::HeatScale::Equalized, range);
    for (const auto & place : level["places"])
    {
      EXPECT_NEAR(axis.PositionOf(HeatAt(place[0])), place[1].get<double>(), 1e-9) << level["bins"] << place;
    }
  }
}

TEST(HeatRanges, EachLiesWithinTheOneBefore)
{
  EXPECT_TRUE(shapeton::HeatRangesOf({}).empty());
  const shapeton::HeatRanges ranges = shapeton::HeatRangesOf({ 0.1, 0.4, 0.1, 0.25, 0.2, 0.25 });
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_EQ(ranges[1].upper, 0.25);
  EXPECT_EQ(ranges[2].lower, 0.2);
}

TEST(HeatRanges, WrongOnesAreNamed)
{
  EXPECT_NE(ErrorOf({ 0.1 }).find("pairs of numbers"), std::string::npos);
  EXPECT_NE(ErrorOf({ 0.1, 0.2, 0.15 }).find("pairs of numbers"), std::string::npos);
  for (const auto & ends : { std::vector<double>{ 0.4, 0.1 }, { 0.2, 0.2 }, { -0.1, 0.2 }, { 0.1, 1.5 } })
  {
    EXPECT_NE(ErrorOf(ends).find("is not a range"), std::string::npos) << ends[0];
  }
  EXPECT_NE(ErrorOf({ std::nan(""), 0.5 }).find("is not a range"), std::string::npos);
  EXPECT_NE(ErrorOf({ 0.1, 0.4, 0.05, 0.2 }).find("0.05 to 0.2 is not inside the previous range, 0.1 to 0.4"),
            std::string::npos);
  EXPECT_NE(ErrorOf({ 0.1, 0.2, 0.1, 0.3 }).find("is not inside"), std::string::npos);
}

TEST(HeatRanges, ASingleBinCannotBeOpened)
{
  EXPECT_NE(ErrorOf({ HeatAt(2000.2), HeatAt(2000.8) }).find("one bin"), std::string::npos);
  EXPECT_NE(ErrorOf({ HeatAt(2000), HeatAt(2001) }).find("one bin"), std::string::npos);
  EXPECT_NE(ErrorOf({ HeatAt(4096), 1.0 }).find("one bin"), std::string::npos);
  EXPECT_EQ(ErrorOf({ HeatAt(2000.8), HeatAt(2001.2) }), "");
  EXPECT_EQ(ErrorOf({ HeatAt(4095), 1.0 }), "");
}

TEST(HeatRanges, LinesThatAClassOfAllHeatsJoinsAreFoundInside)
{
  // Ten lines, 3 % apart, each with a hundredth of the voxels of a large object, too few for separate classes.
  shapeton::HeatHistogram histogram({ 0 });
  histogram.AddToRow(0, std::vector<float>(3000000, 0.5F).data(), 3000000);
  for (int line = 0; line < 10; ++line)
  {
    histogram.AddToRow(0, std::vector<float>(100, static_cast<float>(0.1 * std::pow(1.03, line))).data(), 100);
  }
  const shapeton::HeatRange range{ 0.09, 0.15 };
  const auto                lines = shapeton::FindClassesInside(histogram, 0, range);
  ASSERT_EQ(lines.size(), 10U);
  EXPECT_EQ(lines.front().lowerHeat, range.lower);
  EXPECT_EQ(lines.back().upperHeat, range.upper);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    EXPECT_EQ(lines[i].label, i + 1);
    EXPECT_EQ(lines[i].voxels, 100U);
    EXPECT_NEAR(lines[i].meanHeat / (0.1 * std::pow(1.03, i)), 1.0, 0.004);
    EXPECT_EQ(lines[i].lowerHeat, i == 0 ? range.lower : lines[i - 1].upperHeat);
  }
  EXPECT_TRUE(shapeton::FindClassesInside(histogram, 0, { 0.2, 0.3 }).empty());
}
