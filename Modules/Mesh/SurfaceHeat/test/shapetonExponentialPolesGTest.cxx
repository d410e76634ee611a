#include "shapetonExponentialPoles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace shapeton;

double
ValueOf(const ExponentialPoles & rational, double x)
{
  double sum = 0.0;
  for (const auto & term : rational.terms)
  {
    sum += (term.residue / (x + term.pole)).real();
  }
  return sum;
}

TEST(ExponentialPoles, KeepTheErrorThatTheyState)
{
  for (int pairs = 3; pairs <= 8; ++pairs)
  {
    const ExponentialPoles & rational = GetExponentialPoles(pairs);
    EXPECT_EQ(rational.terms.size(), static_cast<std::size_t>(pairs));
    double largest = 0.0;
    double noise = 0.0;
    for (const auto & term : rational.terms)
    {
      noise += 4e-16 * std::abs(term.residue);
    }
    for (int i = 0; i < 20000; ++i)
    {
      const double x = std::expm1(20.0 * i / 20000.0); // to 5e8
      const double weight = (1.0 + x) * (1.0 + x);
      largest = std::max(largest, std::abs(ValueOf(rational, x) - std::exp(-x)) * weight - noise * (1.0 + x));
    }
    EXPECT_LE(largest, rational.error) << pairs;
    EXPECT_GE(largest, 0.2 * rational.error) << pairs;
  }
}

TEST(ExponentialPoles, GainMoreThanADigitWithEachPair)
{
  for (int pairs = 4; pairs <= 8; ++pairs)
  {
    EXPECT_LT(GetExponentialPoles(pairs).error, GetExponentialPoles(pairs - 1).error / 10.0) << pairs;
  }
}

TEST(ExponentialPoles, DecayAndKeepAwayFromTheNegativeAxis)
{
  for (int pairs = 3; pairs <= 8; ++pairs)
  {
    double sum = 0.0;
    for (const auto & term : GetExponentialPoles(pairs).terms)
    {
      sum += term.residue.real();
      EXPECT_LT(std::arg(term.pole), 2.4) << pairs;
      EXPECT_GT(std::arg(term.pole), 0.2) << pairs;
    }
    EXPECT_NEAR(sum, 0.0, 1e-13) << pairs;
  }
}
} // namespace
