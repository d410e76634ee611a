#include "shapetonGaussianWeights.h"

#include <gtest/gtest.h>

using shapeton::GaussianWeights;

TEST(GaussianWeights, HaveTheSumAndTheVarianceOfAGaussian)
{
  for (const double deviation : { 0.7, 1.0, 2.5, 10.0 })
  {
    const std::vector<double> weights = GaussianWeights(deviation, 6.0);
    const auto                middle = static_cast<double>(weights.size() / 2);
    double                    sum = 0.0;
    double                    mean = 0.0;
    double                    variance = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      const double place = static_cast<double>(i) - middle;
      sum += weights[i];
      mean += weights[i] * place;
      variance += weights[i] * place * place;
    }
    EXPECT_NEAR(1.0, sum, 1e-12);
    EXPECT_NEAR(0.0, mean, 1e-12);
    EXPECT_NEAR(deviation * deviation, variance, 1e-2 * deviation * deviation);
  }
}

TEST(GaussianWeights, ReachAsFarAsAsked)
{
  EXPECT_EQ(7U, GaussianWeights(1.0, 3.0).size());
  EXPECT_EQ(9U, GaussianWeights(1.3, 3.0).size());
  EXPECT_EQ(std::vector<double>{ 1.0 }, GaussianWeights(0.0, 3.0));
}
