#include "shapetonParticleExactWalk.h"
#include "shapetonParticleTestRuns.h"

#include <gtest/gtest.h>

#include <string>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
constexpr std::size_t   side = 16;
constexpr double        p = 2.5;
constexpr double        step = 0.95;
constexpr std::uint64_t steps = 6;

/** A ball in noise, with weights from 0 to 1. */
Volume
MakeVolume()
{
  Volume volume({ side, side, side });
  volume.Fill([](double x, double y, double z) {
    const double ball = std::clamp(5.5 - std::hypot(x - 7.0, y - 8.0, z - 7.5), 0.0, 1.0);
    return 0.55 * ball + 0.45 * (Noise(x, y, z) + 0.5);
  });
  return volume;
}

/** Some voxels in and around part of the ball, for a varying density. */
std::vector<unsigned char>
MakeStart()
{
  std::vector<unsigned char> mask(side * side * side, 0);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = i % side < 9 && i / side % side < 12 && i / side / side > 4;
  }
  return mask;
}

ParticleDiffusionOptions
TraversalSettings(const Volume & volume, DirectionSampling sampling, double stepInVoxels, double shapetons)
{
  auto settings = MakeSettings(volume, static_cast<std::uint32_t>(shapetons), stepInVoxels / side, p);
  settings.pathRule = PathRule::Traversal;
  settings.directionSampling = sampling;
  return settings;
}

/** The mean visits of one shapeton in all steps, and its density after the last one. */
struct Expectation
{
  template <typename TMatrix>
  explicit Expectation(const TMatrix & matrix) : visits(side * side * side, 0.0), density(visits.size())
  {
    const auto   mask = MakeStart();
    const double number = static_cast<double>(std::count(mask.begin(), mask.end(), 1));
    std::transform(
      mask.begin(), mask.end(), density.begin(), [number](unsigned char inside) { return inside / number; });
    for (std::uint64_t taken = 0; taken < steps; ++taken)
    {
      density = matrix.Apply(density);
      std::transform(visits.begin(), visits.end(), density.begin(), visits.begin(), std::plus<>());
    }
  }

  std::vector<double> visits;
  std::vector<double> density;
};

/** The root mean squared deviation of a run from the expectation, per visit of a shapeton. */
double
ErrorOf(const ParticleRun & run, double shapetons, const std::vector<double> & expected)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    sum += std::pow(run.visits[i] / shapetons - expected[i], 2);
  }
  return std::sqrt(sum / static_cast<double>(expected.size()));
}

double
SlopeOf(const std::vector<double> & x, const std::vector<double> & y)
{
  const double number = static_cast<double>(x.size());
  const double meanX = std::accumulate(x.begin(), x.end(), 0.0) / number;
  const double meanY = std::accumulate(y.begin(), y.end(), 0.0) / number;
  double       products = 0.0;
  double       squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    products += (x[i] - meanX) * (y[i] - meanY);
    squares += (x[i] - meanX) * (x[i] - meanX);
  }
  return products / squares;
}

/** The density of a direction in an octant with these weights. */
double
DensityOf(double w1, double w2, double w3, double phi, double theta, DirectionSampling sampling)
{
  const double across = w2 + (w3 - w2) * phi / halfPi;
  const double radius = w1 + (across - w1) * theta / halfPi;
  const double area = Equation87(w1, across, halfPi);
  if (sampling == DirectionSampling::SectorArea)
  {
    return area > 0.0 ? SectorVolume(w1, across, 0.0, halfPi) * 0.5 * radius * radius / area : 0.0;
  }
  return sampling == DirectionSampling::Uniform ? std::sin(theta) : radius * radius * radius / 3.0 * std::sin(theta);
}

/** The distribution of the end voxels of a step, from a lattice in six dimensions: octant and angles of the direction,
 * weighted by its density, and position in the voxel. */
std::vector<double>
EndsByLattice(const ExactWalk & walk, std::size_t voxel, DirectionSampling sampling, double stepInVoxels)
{
  constexpr int         points = 1 << 19;
  constexpr double      root = 1.1127756842787055; // of x^7 = x + 1: its powers spread the points evenly
  std::array<double, 6> numbers{ 0.5, 0.5, 0.5, 0.5, 0.5, 0.5 };
  std::vector<double>   ends(side * side * side, 0.0);
  for (int point = 0; point < points; ++point)
  {
    double power = 1.0;
    for (double & number : numbers)
    {
      power /= root;
      number += power;
      number -= number > 1.0 ? 1.0 : 0.0;
    }
    const auto   octant = std::min(7U, static_cast<unsigned int>(8.0 * numbers[0]));
    const double phi = numbers[1] * halfPi;
    const double theta = numbers[2] * halfPi;
    const auto & w = walk.GetWeights(voxel);
    const double density =
      DensityOf(w[octant & 1], w[2 + (octant >> 1 & 1)], w[4 + (octant >> 2)], phi, theta, sampling);
    const double way[3] = { std::cos(theta), std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi) };
    const auto   along = [&](unsigned int axis) { return (octant >> axis & 1 ? 1 : -1) * stepInVoxels * way[axis]; };
    walk.Follow(voxel, { numbers[3], numbers[4], numbers[5] }, { along(0), along(1), along(2) }, density, ends);
  }
  const double whole = std::accumulate(ends.begin(), ends.end(), 0.0);
  std::transform(ends.begin(), ends.end(), ends.begin(), [=](double end) { return end / whole; });
  return ends;
}

class ParticleTransition : public testing::TestWithParam<DirectionSampling>
{};
} // namespace

TEST_P(ParticleTransition, TheQuadratureHasConverged)
{
  const Volume               volume = MakeVolume();
  const ExactWalk            walk(volume, p);
  const TransitionMatrix<10> coarse(walk, volume.values.size(), GetParam(), step);
  const TransitionMatrix<14> fine(walk, volume.values.size(), GetParam(), step);
  double                     largest = 0.0;
  for (std::size_t voxel = 0; voxel < volume.values.size(); ++voxel)
  {
    double whole = 0.0;
    for (const auto & [end, probability] : fine.GetRow(voxel))
    {
      EXPECT_GE(probability, 0.0);
      whole += probability;
      largest = std::max(largest, std::abs(probability - coarse.Get(voxel, end)));
    }
    EXPECT_NEAR(whole, 1.0, 1e-13);
  }
  EXPECT_LT(largest, 1e-5);
}

TEST_P(ParticleTransition, TheMatrixIsThatOfTheWalk)
{
  const Volume               volume = MakeVolume();
  const ExactWalk            walk(volume, p);
  const TransitionMatrix<14> matrix(walk, volume.values.size(), GetParam(), step);
  // The lattice error is 5e-4, half the error of random points.
  for (const std::size_t voxel : { 0, 1911, 2056 })
  {
    const auto ends = EndsByLattice(walk, voxel, GetParam(), step);
    for (std::size_t end = 0; end < ends.size(); ++end)
    {
      EXPECT_NEAR(matrix.Get(voxel, end), ends[end], 1e-3);
    }
  }
}

TEST_P(ParticleTransition, ErrorsFallWithTheRootOfTheNumberOfShapetons)
{
  const Volume               volume = MakeVolume();
  const ExactWalk            walk(volume, p);
  const TransitionMatrix<14> matrix(walk, volume.values.size(), GetParam(), step);
  const Expectation          expected(matrix);
  std::vector<double>        logShapetons;
  std::vector<double>        logErrors;
  for (int half = 0; half <= 5; ++half)
  {
    const double        shapetons = std::round(std::pow(10.0, 3.5 + 0.5 * half));
    const std::uint64_t seeds = half < 2 ? 10 : half < 4 ? 4 : 1;
    double              square = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    {
      auto settings = TraversalSettings(volume, GetParam(), step, shapetons);
      settings.seed = seed;
      ParticleRun run(volume, settings, MakeStart());
      run.diffusion.Run(steps);
      square += std::pow(ErrorOf(run, shapetons, expected.visits), 2) / static_cast<double>(seeds);
      EXPECT_LT(std::abs(ChiSquareDeviation(expected.density, run.CountByVoxel())), 4.5);
    }
    logShapetons.push_back(std::log10(shapetons));
    logErrors.push_back(0.5 * std::log10(square));
  }
  EXPECT_NEAR(SlopeOf(logShapetons, logErrors), -0.5, 0.05);
  RecordProperty("slope", std::to_string(SlopeOf(logShapetons, logErrors)));
}

TEST_P(ParticleTransition, LongStepsEndAsTheWalkDoes)
{
  // Up to three faces per axis: from a corner of the volume, its border, the surface of the ball.
  const Volume    volume = MakeVolume();
  const ExactWalk walk(volume, p);
  for (const std::size_t voxel : { 0, 1911, 2056, 2560 })
  {
    std::vector<unsigned char> mask(volume.values.size(), 0);
    mask[voxel] = 1;
    const double stepInVoxels = voxel % 2 ? 1.4 : 2.7;
    ParticleRun  run(volume, TraversalSettings(volume, GetParam(), stepInVoxels, 1e5), mask);
    run.diffusion.Run(1);
    const auto ends = EndsByLattice(walk, voxel, GetParam(), stepInVoxels);
    EXPECT_LT(std::abs(ChiSquareDeviation(ends, run.CountByVoxel())), 4.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Samplings,
                         ParticleTransition,
                         testing::Values(DirectionSampling::SolidAngle,
                                         DirectionSampling::SectorArea,
                                         DirectionSampling::Uniform),
                         [](const auto & info) { return std::string(NameOf(info.param)); });

TEST(ParticleTransition, UniformDirectionsGiveASymmetricMatrix)
{
  const Volume               volume = MakeVolume();
  const ExactWalk            walk(volume, p);
  const TransitionMatrix<10> uniform(walk, volume.values.size(), DirectionSampling::Uniform, step);
  const TransitionMatrix<10> drawn(walk, volume.values.size(), DirectionSampling::SolidAngle, step);
  double                     asymmetry = 0.0;
  double                     asymmetryOfDrawn = 0.0;
  for (std::size_t voxel = 0; voxel < volume.values.size(); ++voxel)
  {
    for (const auto & [end, probability] : uniform.GetRow(voxel))
    {
      asymmetry = std::max(asymmetry, std::abs(probability - uniform.Get(end, voxel)));
      asymmetryOfDrawn = std::max(asymmetryOfDrawn, std::abs(drawn.Get(voxel, end) - drawn.Get(end, voxel)));
    }
  }
  EXPECT_LT(asymmetry, 1e-14);
  EXPECT_GT(asymmetryOfDrawn, 0.01);
}

TEST(ParticleTransition, UniformDirectionsKeepAnEvenDensity)
{
  const Volume volume = MakeVolume();
  ParticleRun  run(volume, TraversalSettings(volume, DirectionSampling::Uniform, 1.7, 1e6));
  run.diffusion.Run(10);
  const std::vector<double> even(volume.values.size(), 1.0);
  EXPECT_LT(std::abs(ChiSquareDeviation(even, run.CountByVoxel())), 4.5);
}
