#include "ConditionalLogit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
Eigen::VectorXd
Term(double value)
{
  return Eigen::VectorXd::Constant(1, value);
}
} // namespace

TEST(ConditionalLogit, WeightIsTheLogarithmOfTheOdds)
{
  // The alternative with the term 2 is right three times as often as the one with the term 0: e^(2 w) = 3.
  const std::vector<ChoiceSet> sets{ { { Term(0.0), Term(2.0) }, { 0, 1 }, 3.0 },
                                     { { Term(0.0), Term(2.0) }, { 1, 0 }, 1.0 } };
  EXPECT_NEAR(FitConditionalLogit(sets, 0.0)[0], 0.5 * std::log(3.0), 1e-9);
}

TEST(ConditionalLogit, SeveralRightAlternativesShareTheirProbability)
{
  // With x = e^w, the sets have the probabilities (1 + x^2) / (1 + x + x^2) and x / (1 + x + x^2), of importance 1 and
  // 2: the greatest product has x = 1.
  const std::vector<ChoiceSet> sets{ { { Term(0.0), Term(1.0), Term(2.0) }, { 1, 0, 1 }, 1.0 },
                                     { { Term(0.0), Term(1.0), Term(2.0) }, { 0, 1, 0 }, 2.0 } };
  EXPECT_NEAR(FitConditionalLogit(sets, 0.0)[0], 0.0, 1e-9);
  EXPECT_EQ(sets[0].Best(Term(1.0)), 2U);
  EXPECT_EQ(sets[0].Best(Term(-1.0)), 0U);
}
