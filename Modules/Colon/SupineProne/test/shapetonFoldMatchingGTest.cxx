#include "shapetonFoldMatching.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

namespace
{
constexpr double turn = 120.0; // mm

/** A platform-independent pseudorandom sequence. */
double
Uneven(int i)
{
  const double value = std::sin(12.9898 * i + 4.1414) * 43758.5453;
  return value - std::floor(value);
}

std::vector<shapeton::FoldFeature>
SomeFolds(int number, int seed, double length)
{
  std::vector<shapeton::FoldFeature> folds;
  for (int i = 0; i < number; ++i)
  {
    const int k = 5 * i + 1000 * seed;
    folds.push_back(
      { length * Uneven(k), turn * Uneven(k + 1), 15.0 + 20.0 * Uneven(k + 2), 40.0 + 80.0 * Uneven(k + 3) });
  }
  return folds;
}

double
PairCost(const shapeton::FoldFeature &         a,
         const shapeton::FoldFeature &         b,
         const shapeton::FoldMatchingOptions & options)
{
  double around = std::fmod(std::abs(a.y - b.y), turn);
  around = std::min(around, turn - around);
  if (std::abs(a.x - b.x) >= options.reachAlong || around >= options.reachAround)
  {
    return 1e9;
  }
  return std::pow((a.x - b.x) / options.deviationAlong, 2) + std::pow(around / options.deviationAround, 2) +
         std::pow(std::log(a.length / b.length) / options.deviationLength, 2) +
         std::pow(std::log(a.area / b.area) / options.deviationArea, 2);
}

/** Minimum over all one-to-one matchings of `sources` to `targets`, by brute force. */
double
LeastCost(std::size_t                                                  sources,
          std::size_t                                                  targets,
          const std::function<double(std::size_t, std::size_t)> &      pairCost,
          const std::function<double(std::size_t)> &                   sourceAlone,
          const std::function<double(const std::set<std::size_t> &)> & targetsAlone)
{
  std::function<double(std::size_t, std::set<std::size_t> &)> least = [&](std::size_t             i,
                                                                          std::set<std::size_t> & taken) {
    if (i == sources)
    {
      return targetsAlone(taken);
    }
    double best = sourceAlone(i) + least(i + 1, taken);
    for (std::size_t j = 0; j < targets; ++j)
    {
      if (taken.insert(j).second)
      {
        best = std::min(best, pairCost(i, j) + least(i + 1, taken));
        taken.erase(j);
      }
    }
    return best;
  };
  std::set<std::size_t> taken;
  return least(0, taken);
}

double
LeastCost(const std::vector<shapeton::FoldFeature> & a,
          const std::vector<shapeton::FoldFeature> & b,
          const shapeton::FoldMatchingOptions &      options)
{
  return LeastCost(
    a.size(),
    b.size(),
    [&](std::size_t i, std::size_t j) { return PairCost(a[i], b[j], options); },
    [&](std::size_t) { return options.alone; },
    [&](const std::set<std::size_t> & taken) { return options.alone * static_cast<double>(b.size() - taken.size()); });
}

/** The energy printed in 4.3.1, within the neighborhood of FoldMatchingOptions. */
double
LeastPrintedEnergy(const std::vector<shapeton::FeaturePoint> & a,
                   const std::vector<shapeton::FeaturePoint> & b,
                   double                                      lambda)
{
  const shapeton::FoldMatchingOptions options;
  const auto                          pairCost = [&](std::size_t i, std::size_t j) {
    double around = std::fmod(std::abs(a[i].y - b[j].y), turn);
    around = std::min(around, turn - around);
    const double along = std::abs(a[i].x - b[j].x);
    const bool   isNear = along < options.reachAlong && around < options.reachAround;
    return isNear ? lambda * (along * along + around * around) : 1e9;
  };
  return LeastCost(
    a.size(),
    b.size(),
    pairCost,
    [](std::size_t) { return 0.0; },
    [&](const std::set<std::size_t> & taken) {
      double sum = 0.0;
      for (std::size_t j = 0; j < b.size(); ++j)
      {
        sum += taken.count(j) == 0 ? (1.0 - lambda) * b[j].fromCenter * b[j].fromCenter : 0.0;
      }
      return sum;
    });
}

std::vector<shapeton::FeaturePoint>
SomePoints(int number, int seed)
{
  std::vector<shapeton::FeaturePoint> points;
  for (int i = 0; i < number; ++i)
  {
    const int k = 5 * i + 1000 * seed;
    points.push_back({ 60.0 * Uneven(k), turn * Uneven(k + 1), 70.0 * Uneven(k + 2), 0 });
  }
  return points;
}
} // namespace

TEST(FoldMatching, HungarianFindsTheLeastCost)
{
  shapeton::FoldMatchingOptions options;
  options.reachAround = 30.0;
  for (int seed = 0; seed < 20; ++seed)
  {
    const auto                   a = SomeFolds(6, seed, 60.0);
    const auto                   b = SomeFolds(5, seed + 100, 60.0);
    const shapeton::FoldMatching matching = shapeton::MatchFolds(a, b, turn, options);
    EXPECT_NEAR(matching.primal, LeastCost(a, b, options), 1e-9) << seed;
    EXPECT_EQ(matching.primal, matching.bound);
  }
}

TEST(FoldMatching, ThePrintedEnergyIsMinimized)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    const auto   a = SomePoints(5, seed);
    const auto   b = SomePoints(6, seed + 100);
    const double lambda = 0.5 + 0.02 * seed;
    const auto   matching = shapeton::MatchFeaturePoints(a, b, turn, lambda);
    EXPECT_NEAR(matching.primal, LeastPrintedEnergy(a, b, lambda), 1e-9) << seed;
  }
}

/** Two points are at the same distance from a third: the one near the border is matched. */
TEST(FoldMatching, ThePrintedEnergyFavorsTheBorder)
{
  const std::vector<shapeton::FeaturePoint> a{ { 10.0, 30.0, 30.0, 0 } };
  const std::vector<shapeton::FeaturePoint> b{ { 10.0, 35.0, 25.0, 0 }, { 10.0, 25.0, 35.0, 0 } };
  const auto                                matching = shapeton::MatchFeaturePoints(a, b, turn, 0.9);
  ASSERT_EQ(matching.pairs.size(), 1U);
  EXPECT_EQ(matching.pairs[0].second, 1);
}

TEST(FoldMatching, DualDecompositionWithoutPairTermsIsHungarian)
{
  shapeton::FoldMatchingOptions options;
  const auto                    a = SomeFolds(40, 1, 400.0);
  const auto                    b = SomeFolds(40, 2, 400.0);
  const double                  least = shapeton::MatchFolds(a, b, turn, options).primal;
  options.method = shapeton::FoldMatchingMethod::DualDecomposition;
  options.pairWeight = 0.0;
  const shapeton::FoldMatching matching = shapeton::MatchFolds(a, b, turn, options);
  EXPECT_NEAR(matching.primal, least, 1e-9);
  EXPECT_NEAR(matching.Gap(), 0.0, 1e-9);
}

TEST(FoldMatching, TheBoundLiesBelowAndNeighborsMoveAlike)
{
  // All folds move by 13 mm; a spurious fold is nearer than the true one to the original position of one of them.
  auto a = SomeFolds(30, 3, 500.0);
  auto b = a;
  for (shapeton::FoldFeature & fold : b)
  {
    fold.x += 13.0;
  }
  shapeton::FoldFeature stray = a[4];
  stray.x -= 9.0;
  b.push_back(stray);
  shapeton::FoldMatchingOptions options;
  const auto                    targetOf4 = [](const shapeton::FoldMatching & matching) {
    for (const auto & [i, j] : matching.pairs)
    {
      if (i == 4)
      {
        return j;
      }
    }
    return -1;
  };
  EXPECT_EQ(targetOf4(shapeton::MatchFolds(a, b, turn, options)), 30);
  options.method = shapeton::FoldMatchingMethod::DualDecomposition;
  const shapeton::FoldMatching matching = shapeton::MatchFolds(a, b, turn, options);
  EXPECT_EQ(targetOf4(matching), 4);
  EXPECT_LE(matching.bound, matching.primal + 1e-9);
  EXPECT_LT(matching.Gap(), 0.05);
}

TEST(FoldMatching, TheCutIsNoBorder)
{
  const std::vector<shapeton::FoldFeature> a{ { 10.0, 1.0, 20.0, 50.0 } };
  const std::vector<shapeton::FoldFeature> b{ { 10.0, turn - 1.0, 20.0, 50.0 } };
  EXPECT_EQ(shapeton::MatchFolds(a, b, turn).pairs.size(), 1U);
}

TEST(FoldMatching, GroupsStayApart)
{
  std::vector<shapeton::FoldFeature> a{ { 10.0, 1.0, 20.0, 50.0 } };
  std::vector<shapeton::FoldFeature> b = a;
  b[0].group = 1;
  EXPECT_TRUE(shapeton::MatchFolds(a, b, turn).pairs.empty());
}

TEST(FoldMatching, WrongOptionsAreRefused)
{
  shapeton::FoldMatchingOptions options;
  options.deviationAlong = 0.0;
  EXPECT_THROW(shapeton::MatchFolds({}, {}, turn, options), shapeton::ParameterError);
}
