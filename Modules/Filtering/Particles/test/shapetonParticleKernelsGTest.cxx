#include "shapetonKernelSets.h"
#include "shapetonPhilox.h"
#include "shapetonParticleDirection.h"
#include "shapetonParticleKernelsTestTools.h"
#include "shapetonPrintedEquations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>
#include <utility>

using namespace shapeton;
using namespace shapeton::test;
using namespace shapeton::ParticleKernels;

namespace
{
constexpr DirectionSampling allSamplings[] = { DirectionSampling::SolidAngle,
                                               DirectionSampling::SectorArea,
                                               DirectionSampling::BinarySearch,
                                               DirectionSampling::Uniform };

/** Shapetons at random positions among voxels with various weights: none, smallest, largest, random. */
Crowd
MakeMixedCrowd(std::size_t number)
{
  constexpr std::int32_t side = 12;
  Crowd                  crowd(number, { side, side, side });
  std::mt19937           engine(3);
  for (std::size_t voxel = 0; voxel < side * side * side; ++voxel)
  {
    std::array<std::uint16_t, 6> weights{};
    for (std::uint16_t & weight : weights)
    {
      const auto kind = engine() % 8;
      weight = static_cast<std::uint16_t>(kind < 3 ? 0 : kind == 3 ? 1 : kind == 4 ? 65535 : engine() % 65536);
    }
    crowd.SetWeights(voxel, voxel % 16 == 0 ? std::array<std::uint16_t, 6>{} : weights);
  }
  for (std::size_t i = 0; i < number; ++i)
  {
    std::size_t voxel = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      crowd.places[axis][i] = static_cast<float>(engine() % (side * 1000)) / 1000.0F;
      voxel = voxel * side + static_cast<std::size_t>(crowd.places[axis][i]);
    }
    crowd.voxels[i] = static_cast<std::uint32_t>(voxel);
  }
  crowd.surroundings.step[0] = 2.3F;
  crowd.surroundings.step[1] = 1.1F;
  crowd.surroundings.step[2] = 40.7F;
  return crowd;
}

constexpr int bins = 8;

/** The probabilities of the cells octant x phi x theta. */
std::vector<double>
CellProbabilities(const EdgeWeights & w, DirectionSampling sampling)
{
  std::vector<double> probabilities;
  for (unsigned int octant = 0; octant < 8; ++octant)
  {
    const double w1 = w[octant & 1];
    const double w2 = w[2 + (octant >> 1 & 1)];
    const double w3 = w[4 + (octant >> 2)];
    for (int cell = 0; cell < bins * bins; ++cell)
    {
      const double from = cell % bins * halfPi / bins;
      const double to = (cell % bins + 1) * halfPi / bins;
      const auto   density = [&](double phi) {
        const double across = w2 + (w3 - w2) * phi / halfPi;
        if (sampling != DirectionSampling::SectorArea)
        {
          return SectorVolume(w1, across, from, to);
        }
        const double area = Equation87(w1, across, halfPi);
        const double share = area > 0.0 ? (Equation87(w1, across, to) - Equation87(w1, across, from)) / area : 0.0;
        return SectorVolume(w1, across, 0.0, halfPi) * share;
      };
      const int phi = cell / bins;
      probabilities.push_back(Gauss()(phi * halfPi / bins, (phi + 1) * halfPi / bins, density));
    }
  }
  return probabilities;
}

/** Counts directions in the same cells. */
class CellCounter
{
public:
  CellCounter() : counts(8 * bins * bins, 0)
  {
    for (int edge = 1; edge < bins; ++edge)
    {
      m_Cosines[edge - 1] = std::cos(edge * halfPi / bins);
      m_Sines[edge - 1] = std::sin(edge * halfPi / bins);
    }
  }

  void
  Add(double x, double y, double z)
  {
    const std::size_t octant = (std::signbit(x) ? 0U : 1U) + (std::signbit(y) ? 0U : 2U) + (std::signbit(z) ? 0U : 4U);
    std::size_t       phi = 0;
    std::size_t       theta = 0;
    for (int edge = 0; edge < bins - 1; ++edge)
    {
      phi += std::abs(z) * m_Cosines[edge] > std::abs(y) * m_Sines[edge];
      theta += std::abs(x) < m_Cosines[edge];
    }
    ++counts[(octant * bins + phi) * bins + theta];
  }

  std::vector<std::uint64_t> counts;

private:
  std::array<double, bins - 1> m_Cosines{};
  std::array<double, bins - 1> m_Sines{};
};

struct WeightCase
{
  const char *                 name;
  std::array<std::uint16_t, 6> weights;
};

void
PrintTo(const WeightCase & weightCase, std::ostream * stream)
{
  *stream << weightCase.name;
}

constexpr WeightCase weightCases[] = { { "Equal", { 65535, 65535, 65535, 65535, 65535, 65535 } },
                                       { "EqualAndLeast", { 1, 1, 1, 1, 1, 1 } },
                                       { "Random", { 41234, 7321, 60001, 23456, 15000, 52525 } },
                                       { "OneZero", { 65535, 0, 30000, 45000, 52000, 21000 } },
                                       { "OneDominant", { 3277, 65535, 3277, 3277, 3277, 3277 } },
                                       { "OneDominantAcross", { 3277, 3277, 3277, 3277, 65535, 3277 } },
                                       { "OnlyOne", { 0, 0, 0, 50000, 0, 0 } },
                                       { "OnlyOneFirst", { 50000, 0, 0, 0, 0, 0 } },
                                       { "TwoOpposite", { 0, 0, 0, 0, 65535, 20000 } } };

EdgeWeights
AsDoubles(const std::array<std::uint16_t, 6> & weights)
{
  EdgeWeights numbers{};
  std::transform(weights.begin(), weights.end(), numbers.begin(), [](double weight) { return weight / 65535.0; });
  return numbers;
}

/** Calls `body(x, y, z)` for directions sampled by the best kernels in a voxel with these weights. */
template <typename TBody>
void
ForDirections(const std::array<std::uint16_t, 6> & weights,
              DirectionSampling                    sampling,
              std::size_t                          number,
              const TBody &                        body)
{
  constexpr std::size_t group = 5000;
  Crowd                 crowd(group, { 1, 1, 1 });
  crowd.SetWeights(0, weights);
  for (std::uint64_t step = 1; step <= number / group; ++step)
  {
    BestKernels<Set>().DrawOf(sampling)(
      crowd.GetSurroundings(), crowd.GetShapetons(), Random{ 5, step }, Table(), crowd.GetDirections());
    for (std::size_t i = 0; i < group; ++i)
    {
      body(crowd.directions[0][i], crowd.directions[1][i], crowd.directions[2][i]);
    }
  }
}

/** The four terms of R^3 (8.3), integrated from the first axis to `theta`. */
std::array<double, 4>
TermsBelow(double w1, double across, double theta)
{
  std::array<double, 4> terms{};
  Gauss().ForNodes(0.0, theta, [&](double t, double weight) {
    const double first = w1 * (1.0 - t / halfPi);
    const double second = across * t / halfPi;
    const double density = weight * std::sin(t);
    terms[0] += density * first * first * first;
    terms[1] += density * 3.0 * first * first * second;
    terms[2] += density * 3.0 * first * second * second;
    terms[3] += density * second * second * second;
  });
  return terms;
}

/** The random numbers of a shapeton in kernel order: octant, phi, theta and term. */
std::array<double, 4>
RandomOf(const Random & random, std::uint32_t shapeton)
{
  const auto words =
    Philox4x32(random.seed,
               { shapeton, static_cast<std::uint32_t>(random.step), static_cast<std::uint32_t>(random.step >> 32), 0 });
  const auto unit = [](std::uint32_t word) { return ((word >> 8) + 1.0) / 16777216.0; };
  return { unit(words.a), unit(words.b), unit(words.c), unit(words.d) };
}

/** A direction as the octant, its weights and angles. */
struct Angles
{
  Angles(const std::uint16_t * record, const std::array<double, 3> & direction)
    : octant((std::signbit(direction[0]) ? 0U : 1U) + (std::signbit(direction[1]) ? 0U : 2U) +
             (std::signbit(direction[2]) ? 0U : 4U))
    , w{ record[octant & 1] / 65535.0, record[2 + (octant >> 1 & 1)] / 65535.0, record[4 + (octant >> 2)] / 65535.0 }
    , phi(std::atan2(std::abs(direction[2]), std::abs(direction[1])))
    , theta(std::atan2(std::hypot(direction[1], direction[2]), std::abs(direction[0])))
    , across(w[1] + (w[2] - w[1]) * phi / halfPi)
  {}

  unsigned int          octant;
  std::array<double, 3> w;
  double                phi;
  double                theta;
  double                across;
};

/** Calls a body with the record, the random numbers and the angles of each shapeton that has a direction. */
template <typename TBody>
void
ForAngles(const Crowd & crowd, const Random & random, const TBody & body)
{
  for (std::uint32_t i = 0; i < crowd.number; ++i)
  {
    const std::uint16_t * const record = crowd.records.data() + crowd.voxels[i] * RecordLength;
    if (!(record[MarksOfRecord] & TrapMark))
    {
      body(record,
           RandomOf(random, i),
           Angles(record, { crowd.directions[0][i], crowd.directions[1][i], crowd.directions[2][i] }));
    }
  }
}

/** Cumulative volume fraction of the octants up to `octant`. */
double
ShareOfOctants(const std::uint16_t * record, unsigned int octants)
{
  double part = 0.0;
  double whole = 0.0;
  for (unsigned int octant = 0; octant < 8; ++octant)
  {
    const double volume = Equation86(record[octant & 1], record[2 + (octant >> 1 & 1)], record[4 + (octant >> 2)]);
    whole += volume;
    part += octant < octants ? volume : 0.0;
  }
  return part / whole;
}

/** Deviation of theta from the quantile of its random number, as a fraction of the distribution; by term and its
 * quantile, or by sector area. A number at the border of two terms may select either. */
double
ErrorOfTheta(const Angles & angles, DirectionSampling sampling, const std::array<double, 4> & numbers)
{
  const double w1 = angles.w[0];
  if (sampling == DirectionSampling::SectorArea)
  {
    return Equation87(w1, angles.across, angles.theta) / Equation87(w1, angles.across, halfPi) - numbers[2];
  }
  const auto   below = TermsBelow(w1, angles.across, angles.theta);
  const auto   whole = TermsBelow(w1, angles.across, halfPi);
  const double sum = whole[0] + whole[1] + whole[2] + whole[3];
  double       least = 1.0;
  double       upTo = 0.0;
  for (unsigned int term = 0; term < 4; ++term)
  {
    const double from = upTo / sum;
    upTo += whole[term];
    if (whole[term] > 0.0 && numbers[3] > from - 1e-5 && numbers[3] < upTo / sum + 1e-5)
    {
      least = std::min(least, std::abs(below[term] / whole[term] - numbers[2]));
    }
  }
  return least;
}

/** The angle of a share of a volume or an area by (8.8) and (8.9), and the number of comparisons. */
std::pair<double, int>
SearchedAngle(const std::function<double(double)> & part, double share)
{
  const double wanted = share * part(halfPi);
  double       angle = halfPi / 2.0;
  int          iterations = 1;
  for (; std::abs(wanted - part(angle)) >= 0.01; ++iterations)
  {
    const double change = halfPi / std::pow(2.0, iterations + 1);
    angle += wanted < part(angle) ? -change : change;
  }
  return { angle, iterations };
}

class ParticleKernelsDistribution : public testing::TestWithParam<std::tuple<WeightCase, DirectionSampling>>
{};
} // namespace

TEST_P(ParticleKernelsDistribution, TenMillionDirectionsFollowTheShapeDistribution)
{
  const auto & [weightCase, sampling] = GetParam();
  CellCounter counter;
  ForDirections(weightCase.weights, sampling, 10000000, [&](float x, float y, float z) { counter.Add(x, y, z); });
  const auto probabilities = CellProbabilities(AsDoubles(weightCase.weights), sampling);
  EXPECT_LT(std::abs(ChiSquareDeviation(probabilities, counter.counts)), 4.5);
}

INSTANTIATE_TEST_SUITE_P(Weights,
                         ParticleKernelsDistribution,
                         testing::Combine(testing::ValuesIn(weightCases),
                                          testing::Values(DirectionSampling::SolidAngle,
                                                          DirectionSampling::SectorArea)),
                         [](const auto & info) {
                           return std::string(std::get<0>(info.param).name) +
                                  (std::get<1>(info.param) == DirectionSampling::SolidAngle ? "BySolidAngle"
                                                                                            : "BySectorArea");
                         });

TEST(ParticleKernels, UniformDirectionsAreUniformWhateverTheWeights)
{
  CellCounter counter;
  ForDirections({ 0, 9, 65535, 0, 0, 1 }, DirectionSampling::Uniform, 10000000, [&](float x, float y, float z) {
    counter.Add(x, y, z);
  });
  const auto probabilities = CellProbabilities({ 1, 1, 1, 1, 1, 1 }, DirectionSampling::SolidAngle);
  EXPECT_LT(std::abs(ChiSquareDeviation(probabilities, counter.counts)), 4.5);
}

TEST(ParticleKernels, AllInstructionSetsGiveTheSameDirections)
{
  const auto sets = KernelsOfThisCpu<Set>();
  if (sets.size() == 1)
  {
    GTEST_SKIP() << "this CPU runs the baseline alone";
  }
  for (const auto sampling : allSamplings)
  {
    Crowd reference = MakeMixedCrowd(20011);
    for (const std::uint64_t step : { std::uint64_t{ 1 }, (std::uint64_t{ 7 } << 32) + 3 })
    {
      const Random random{ 0x123456789abcdef0U, step };
      sets[0]->DrawOf(sampling)(
        reference.GetSurroundings(), reference.GetShapetons(4000000000U), random, Table(), reference.GetDirections());
      for (const Set * const set : sets)
      {
        Crowd crowd = MakeMixedCrowd(20011);
        set->DrawOf(sampling)(
          crowd.GetSurroundings(), crowd.GetShapetons(4000000000U), random, Table(), crowd.GetDirections());
        for (unsigned int axis = 0; axis < 3; ++axis)
        {
          EXPECT_TRUE(SameBytes(crowd.directions[axis], reference.directions[axis])) << set->name;
        }
      }
    }
  }
}

TEST(ParticleKernels, DirectionsAreUnitVectorsOrNone)
{
  for (const auto sampling : allSamplings)
  {
    Crowd crowd = MakeMixedCrowd(30000);
    BestKernels<Set>().DrawOf(sampling)(
      crowd.GetSurroundings(), crowd.GetShapetons(), Random{ 1, 1 }, Table(), crowd.GetDirections());
    std::size_t trapped = 0;
    for (std::size_t i = 0; i < crowd.number; ++i)
    {
      double square = 0.0;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        square += std::pow(crowd.directions[axis][i], 2);
      }
      const std::uint16_t * const record = crowd.records.data() + crowd.voxels[i] * RecordLength;
      const bool trap = std::all_of(record, record + MarksOfRecord, [](std::uint16_t weight) { return weight == 0; });
      trapped += trap;
      EXPECT_NEAR(square, trap ? 0.0 : 1.0, trap ? 0.0 : 1e-6);
    }
    EXPECT_GT(trapped, 1000U);
  }
}

TEST(ParticleKernels, RandomNumbersAreTheShareOfTheDistributionUpToTheDirection)
{
  // For various weights; in single precision the kernels invert the distribution functions within 1.5e-6.
  for (const auto sampling : { DirectionSampling::SolidAngle, DirectionSampling::SectorArea })
  {
    Crowd        crowd = MakeMixedCrowd(400000);
    const Random random{ 99, 5 };
    BestKernels<Set>().DrawOf(sampling)(
      crowd.GetSurroundings(), crowd.GetShapetons(), random, Table(), crowd.GetDirections());
    double largestOfOctant = 0.0;
    double largestOfPhi = 0.0;
    double largestOfTheta = 0.0;
    ForAngles(crowd, random, [&](const std::uint16_t * record, const auto & numbers, const Angles & angles) {
      const double volume = Equation86(angles.w[0], angles.w[1], angles.w[2]);
      ASSERT_GT(volume, 0.0);
      largestOfOctant = std::max({ largestOfOctant,
                                   ShareOfOctants(record, angles.octant) - numbers[0],
                                   numbers[0] - ShareOfOctants(record, angles.octant + 1) });
      largestOfPhi = std::max(
        largestOfPhi, std::abs(Equation85(angles.w[0], angles.w[1], angles.w[2], angles.phi) / volume - numbers[1]));
      largestOfTheta = std::max(largestOfTheta, std::abs(ErrorOfTheta(angles, sampling, numbers)));
    });
    EXPECT_LT(largestOfOctant, 1e-6);
    EXPECT_LT(largestOfPhi, 2e-6);
    EXPECT_LT(largestOfTheta, 2e-6);
  }
}

TEST(ParticleKernels, BinarySearchEndsAsPrinted)
{
  Crowd        crowd = MakeMixedCrowd(100000);
  const Random random{ 99, 5 };
  const auto   draw = BestKernels<Set>().DrawOf(DirectionSampling::BinarySearch);
  draw(crowd.GetSurroundings(), crowd.GetShapetons(), random, Table(), crowd.GetDirections());
  int compared = 0;
  int different = 0; // a value at the tolerance may end the search one iteration earlier in single precision
  ForAngles(crowd, random, [&](const std::uint16_t *, const auto & numbers, const Angles & angles) {
    const auto & w = angles.w;
    const double phi = SearchedAngle([&](double x) { return Equation85(w[0], w[1], w[2], x); }, numbers[1]).first;
    const double across = w[1] + (w[2] - w[1]) * phi / halfPi;
    const double theta = SearchedAngle([&](double x) { return Equation87(w[0], across, x); }, numbers[2]).first;
    ++compared;
    different += std::abs(phi - angles.phi) > 1e-4 || std::abs(theta - angles.theta) > 1e-4;
  });
  EXPECT_LT(90000, compared);
  EXPECT_GT(compared / 1000, different);
}

TEST(ParticleKernels, BinarySearchTakesTheIterationsThatArePublished)
{
  // Weights in the interior of an object: 1. The dissertation states four iterations on average.
  std::mt19937  engine(7);
  double        iterations = 0.0;
  constexpr int trials = 10000;
  for (int trial = 0; trial < trials; ++trial)
  {
    const double random = (engine() + 1.0) / 4294967296.0;
    iterations += SearchedAngle([](double x) { return Equation87(1.0, 1.0, x); }, random).second;
  }
  EXPECT_NEAR(4.0, iterations / trials, 1.0);
}

TEST(ParticleKernels, DirectionsDependOnTheShapetonAndTheStepAlone)
{
  // The last 16 of 48 shapetons get the same directions with and without the others.
  Crowd all = MakeMixedCrowd(48);
  Crowd some = MakeMixedCrowd(48);
  some.number = 16;
  std::copy_n(all.voxels.begin() + 32, 16, some.voxels.begin());
  const auto draw = BestKernels<Set>().DrawOf(DirectionSampling::SolidAngle);
  draw(all.GetSurroundings(), all.GetShapetons(100), Random{ 2, 77 }, Table(), all.GetDirections());
  draw(some.GetSurroundings(), some.GetShapetons(132), Random{ 2, 77 }, Table(), some.GetDirections());
  EXPECT_TRUE(std::equal(all.directions[0].begin() + 32, all.directions[0].end(), some.directions[0].begin()));
  draw(some.GetSurroundings(), some.GetShapetons(132), Random{ 2, 78 }, Table(), some.GetDirections());
  EXPECT_FALSE(std::equal(all.directions[0].begin() + 32, all.directions[0].end(), some.directions[0].begin()));
}

TEST(ParticleKernels, MeanSquaredComponentsOfEqualWeights)
{
  const std::array<std::uint16_t, 6> weights = { 65535, 65535, 65535, 65535, 65535, 65535 };
  for (const auto sampling : allSamplings)
  {
    std::array<double, 3> squares{};
    ForDirections(weights, sampling, 1000000, [&](double x, double y, double z) {
      squares[0] += x * x / 1e6;
      squares[1] += y * y / 1e6;
      squares[2] += z * z / 1e6;
    });
    const bool published = sampling == DirectionSampling::SectorArea || sampling == DirectionSampling::BinarySearch;
    EXPECT_NEAR(squares[0], published ? 0.50 : 1.0 / 3.0, 0.003);
    EXPECT_NEAR(squares[1], published ? 0.25 : 1.0 / 3.0, 0.003);
    EXPECT_NEAR(squares[2], published ? 0.25 : 1.0 / 3.0, 0.003);
  }
}

TEST(ParticleKernels, TheThetaTableIsRightAtAndBetweenItsEntries)
{
  for (int term = 0; term < 4; ++term)
  {
    const auto share = [&](double theta) {
      return Gauss()(0.0, theta, [&](double t) {
        return std::pow(1.0 - t / halfPi, 3 - term) * std::pow(t / halfPi, term) * std::sin(t);
      });
    };
    const double whole = share(halfPi);
    for (int i = 0; i < 8 * ThetaTableSize; ++i)
    {
      const int    cell = i / 8;
      const double within = i % 8 / 8.0;
      const double quantile = 0.5 * std::pow((cell + within) / ThetaTableSize, 2);
      const auto   between = [&](const float * entries) {
        return entries[cell] + within * (entries[cell + 1] - entries[cell]);
      };
      const double low = 2.0 * std::asin(std::sqrt(0.5 * between(Table().low[term])));
      const double high = std::acos(std::min(1.0, between(Table().high[term])));
      const double tolerance = i % 8 == 0 ? 1e-6 : 1e-5;
      EXPECT_NEAR(share(low) / whole, quantile, tolerance);
      EXPECT_NEAR(share(high) / whole, 1.0 - quantile, tolerance);
    }
  }
}
