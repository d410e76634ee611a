#include "shapetonQuantiles.h"

#include "gtest/gtest.h"

namespace
{
const std::vector<double> four{ 7.0, 1.0, 5.0, 3.0 }; // 1, 3, 5, 7 in ascending order
const std::vector<double> sorted{ 1.0, 3.0, 5.0, 7.0 };
} // namespace

TEST(Quantiles, MediansOfAnEvenNumberDiffer)
{
  EXPECT_EQ(shapeton::UpperMedian(four), 5.0);
  EXPECT_EQ(shapeton::LowerQuantile(four, 0.5), 3.0);
  EXPECT_EQ(shapeton::NearestQuantile(four, 0.5), 5.0);
  EXPECT_EQ(shapeton::InterpolatedQuantile(four, 0.5), 4.0);
  EXPECT_EQ(shapeton::SortedQuantile(sorted, 0.5), 5.0);
}

TEST(Quantiles, RanksAreRoundedAsStated)
{
  EXPECT_EQ(shapeton::LowerQuantile(four, 0.99), 5.0);
  EXPECT_EQ(shapeton::NearestQuantile(four, 0.49), 3.0);
  EXPECT_EQ(shapeton::NearestQuantile(four, 0.99), 7.0);
  EXPECT_DOUBLE_EQ(shapeton::InterpolatedQuantile(four, 0.9), 6.4);
  EXPECT_EQ(shapeton::SortedQuantile(sorted, 0.24), 1.0);
  EXPECT_EQ(shapeton::SortedQuantile(sorted, 0.26), 3.0);
}

TEST(Quantiles, EndsAreTheLeastAndTheGreatest)
{
  for (const double share : { 0.0, 1.0 })
  {
    const double end = share == 0.0 ? 1.0 : 7.0;
    EXPECT_EQ(shapeton::LowerQuantile(four, share), end);
    EXPECT_EQ(shapeton::NearestQuantile(four, share), end);
    EXPECT_EQ(shapeton::InterpolatedQuantile(four, share), end);
    EXPECT_EQ(shapeton::SortedQuantile(sorted, share), end);
  }
}

TEST(Quantiles, AreZeroWithoutValues)
{
  EXPECT_EQ(shapeton::UpperMedian(std::vector<float>()), 0.0F);
  EXPECT_EQ(shapeton::LowerQuantile(std::vector<float>(), 0.5), 0.0F);
  EXPECT_EQ(shapeton::NearestQuantile(std::vector<float>(), 0.5), 0.0F);
  EXPECT_EQ(shapeton::InterpolatedQuantile({}, 0.5), 0.0);
  EXPECT_EQ(shapeton::SortedQuantile(std::vector<float>(), 0.5), 0.0F);
}
