#ifndef shapetonParticleTestTools_h
#define shapetonParticleTestTools_h

#include "shapetonParticleDiffusion.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <vector>

namespace shapeton
{
/** Test name for this parameter. */
inline void
PrintTo(DirectionSampling sampling, std::ostream * stream)
{
  *stream << NameOf(sampling);
}

namespace test
{
constexpr double pi = 3.14159265358979323846;
constexpr double halfPi = 0.5 * pi;

/** Gauss quadrature. With 24 points it is exact for polynomials up to degree 47, and accurate to rounding for the
 * smooth functions here. */
template <int Points>
class GaussRule
{
public:
  GaussRule()
  {
    for (int i = 0; i < Points; ++i)
    {
      double x = std::cos(pi * (i + 0.75) / (Points + 0.5));
      double slope = 0.0;
      for (int iteration = 0; iteration < 8; ++iteration)
      {
        double previous = 1.0;
        double value = x;
        for (int n = 2; n <= Points; ++n)
        {
          const double next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
          previous = value;
          value = next;
        }
        slope = Points * (x * value - previous) / (x * x - 1.0);
        x -= value / slope;
      }
      m_Nodes[i] = x;
      m_Weights[i] = 2.0 / ((1.0 - x * x) * slope * slope);
    }
  }

  /** Calls `body(place, weight)` for the nodes between two places. */
  template <typename TBody>
  void
  ForNodes(double from, double to, const TBody & body) const
  {
    const double half = 0.5 * (to - from);
    for (int i = 0; i < Points; ++i)
    {
      body(from + half * (1.0 + m_Nodes[i]), half * m_Weights[i]);
    }
  }

  template <typename TFunction>
  double
  operator()(double from, double to, const TFunction & function) const
  {
    double sum = 0.0;
    this->ForNodes(from, to, [&](double place, double weight) { sum += weight * function(place); });
    return sum;
  }

private:
  std::array<double, Points> m_Nodes{};
  std::array<double, Points> m_Weights{};
};

inline const GaussRule<24> &
Gauss()
{
  static const GaussRule<24> rule;
  return rule;
}

/** Deviation of counts from their expectations: Pearson's statistic as a number of standard deviations (Wilson and
 * Hilferty). Adjacent entries are merged until 20 are expected. Infinite if an impossible event was counted. The
 * probability of values beyond +-4.5 is below 1e-5. */
inline double
ChiSquareDeviation(const std::vector<double> & probabilities, const std::vector<std::uint64_t> & counts)
{
  double total = 0.0;
  double wholeProbability = 0.0;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    if (probabilities[i] <= 0.0 && counts[i] > 0)
    {
      return std::numeric_limits<double>::infinity();
    }
    total += static_cast<double>(counts[i]);
    wholeProbability += probabilities[i];
  }
  double statistic = 0.0;
  double expected = 0.0;
  double counted = 0.0;
  int    freedom = -1;
  double left = total;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    expected += probabilities[i] / wholeProbability * total;
    counted += static_cast<double>(counts[i]);
    if (expected >= 20.0 && left - expected >= 20.0)
    {
      statistic += (counted - expected) * (counted - expected) / expected;
      left -= expected;
      expected = counted = 0.0;
      ++freedom;
    }
  }
  statistic += (counted - expected) * (counted - expected) / expected;
  ++freedom;
  const double spread = 2.0 / (9.0 * freedom);
  return freedom < 1 ? 0.0 : (std::cbrt(statistic / freedom) - (1.0 - spread)) / std::sqrt(spread);
}
} // namespace test
} // namespace shapeton

#endif
