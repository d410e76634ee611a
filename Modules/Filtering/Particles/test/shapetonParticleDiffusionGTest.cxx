#include "shapetonParticleDiffusion.h"
#include "itkMultiThreaderBase.h"
#include "shapetonExceptions.h"
#include "shapetonParticleTestRuns.h"
#include "shapetonParticleTestTools.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
constexpr PathRule          bothRules[] = { PathRule::Endpoint, PathRule::Traversal };
constexpr DirectionSampling allSamplings[] = { DirectionSampling::SolidAngle,
                                               DirectionSampling::SectorArea,
                                               DirectionSampling::Uniform };

/** Voxels whose intensity differs from all six neighbors by more than 1 / p. Border voxels are excluded because their
 * outer edges have weight 1. */
std::vector<bool>
FindTraps(const Volume & volume, double p)
{
  const double             range = volume.Window()[1] - volume.Window()[0];
  const std::size_t        strides[3] = { 1, volume.size[0], volume.size[0] * volume.size[1] };
  std::vector<bool>        traps(volume.values.size(), false);
  const std::vector<float> values = volume.values;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t index[3] = { i % volume.size[0], i / strides[1] % volume.size[1], i / strides[2] };
    bool              trap = true;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const bool inside = index[axis] > 0 && index[axis] + 1 < volume.size[axis];
      const auto closed = [&](std::size_t neighbor) {
        return range > 0.0 && p * std::abs(double{ values[i] } - values[neighbor]) >= range;
      };
      trap = trap && inside && closed(i - strides[axis]) && closed(i + strides[axis]);
    }
    traps[i] = trap;
  }
  return traps;
}

/** The measures computed from visits and positions. */
void
ExpectMeasuresOfTheVisits(const ParticleRun & run, const Volume & volume, const ParticleDiffusionOptions & settings)
{
  const ParticleMeasures & measures = run.diffusion.GetMeasures();
  std::uint64_t            reached = 0;
  std::uint64_t            objects = 0;
  std::uint64_t            objectsReached = 0;
  const float              lower = static_cast<float>((*settings.intensityWindow)[0]);
  const bool               constant = *std::max_element(volume.values.begin(), volume.values.end()) <= lower;
  for (std::size_t i = 0; i < run.visits.size(); ++i)
  {
    const bool object = constant || volume.values[i] > lower;
    reached += run.visits[i] > 0;
    objects += object;
    objectsReached += object && run.visits[i] > 0;
  }
  EXPECT_EQ(run.SumOfVisits(), measures.step * settings.shapetons);
  EXPECT_EQ(measures.maximumVisits, *std::max_element(run.visits.begin(), run.visits.end()));
  EXPECT_EQ(measures.voxelsReached, reached);
  EXPECT_EQ(measures.objectVoxels, objects);
  EXPECT_EQ(measures.objectVoxelsReached, objectsReached);
  EXPECT_EQ(measures.GetCoverage(), static_cast<double>(objectsReached) / static_cast<double>(objects));
  const auto    traps = FindTraps(volume, settings.p);
  std::uint32_t trapped = 0;
  for (std::size_t i = 0; i < settings.shapetons; ++i)
  {
    trapped += traps[run.VoxelOf(i)];
  }
  EXPECT_EQ(measures.trappedShapetons, trapped);
  const double n = settings.shapetons;
  const double mean = n * static_cast<double>(measures.step) / static_cast<double>(reached);
  const double epsilon =
    n * (1.0 + n / static_cast<double>(reached)) / std::pow(100.0 * measures.maximumVisits / mean, 2);
  EXPECT_NEAR(measures.automaticEpsilon, epsilon, 1e-12 * epsilon);
}

/** (3.10) with normalized densities, from the visits before and after a step. */
double
ChangeBetween(const std::vector<std::uint32_t> & before, const std::vector<std::uint32_t> & after)
{
  const double maximumBefore = std::max(1U, *std::max_element(before.begin(), before.end()));
  const double maximumAfter = *std::max_element(after.begin(), after.end());
  double       sum = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    sum += std::pow(after[i] / maximumAfter - before[i] / maximumBefore, 2);
  }
  return sum;
}

/** Two alternating values along all axes: every inner voxel is a trap. */
Volume
MakeCheckerboard(const test::Size & size)
{
  Volume volume(size);
  volume.Fill([](std::size_t x, std::size_t y, std::size_t z) { return (x + y + z) % 2; });
  return volume;
}
} // namespace

TEST(ParticleDiffusion, VisitsAndMeasuresAreThoseOfTheShapetons)
{
  const Volume volumes[] = { MakeScene({ 20, 18, 16 }, 0.1), MakeScene({ 15, 14, 13 }, 1.0),
                             Volume({ 9, 8, 7 }, 5.0F),      Volume({ 1, 1, 1 }, 3.0F),
                             MakeScene({ 1, 1, 40 }, 0.2),   MakeScene({ 1, 30, 25 }, 0.2) };
  for (const Volume & volume : volumes)
  {
    for (const PathRule rule : bothRules)
    {
      for (const DirectionSampling sampling : allSamplings)
      {
        auto settings = MakeSettings(volume, 1003, 0.07, 12.0);
        settings.pathRule = rule;
        settings.directionSampling = sampling;
        ParticleRun run(volume, settings);
        EXPECT_EQ(run.SumOfVisits(), 0U);
        for (const std::uint64_t step : { 1, 2, 3, 20 })
        {
          run.diffusion.Run(step);
          EXPECT_EQ(run.diffusion.GetMeasures().step, step);
          ExpectMeasuresOfTheVisits(run, volume, settings);
        }
      }
    }
  }
}

TEST(ParticleDiffusion, VisitsAreThePlacesAfterEachStep)
{
  const Volume volume = MakeScene({ 20, 18, 16 }, 0.1);
  for (const PathRule rule : bothRules)
  {
    auto settings = MakeSettings(volume, 5000, 0.1);
    settings.pathRule = rule;
    ParticleRun                run(volume, settings);
    std::vector<std::uint32_t> expected(volume.values.size(), 0);
    for (std::uint64_t step = 1; step <= 5; ++step)
    {
      run.diffusion.Run(step);
      const auto counts = run.CountByVoxel();
      std::transform(counts.begin(), counts.end(), expected.begin(), expected.begin(), std::plus<>());
      EXPECT_EQ(run.visits, expected);
    }
  }
}

TEST(ParticleDiffusion, AnyNumberOfThreadsGivesTheSameBytes)
{
  const Volume                    volume = MakeScene({ 24, 20, 22 }, 0.2);
  const std::optional<SteadyRule> rules[] = { std::nullopt, SteadyRule{ 1e-9, false } };
  const auto                      usual = itk::MultiThreaderBase::GetGlobalDefaultNumberOfThreads();
  for (const PathRule pathRule : bothRules)
  {
    for (const auto & rule : rules)
    {
      auto settings = MakeSettings(volume, 66000, 0.05);
      settings.pathRule = pathRule;
      itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(1);
      ParticleRun reference(volume, settings);
      reference.diffusion.Run(12, rule);
      for (const unsigned int threads : { 2, 3, 8 })
      {
        itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
        ParticleRun run(volume, settings);
        run.diffusion.Run(12, rule);
        EXPECT_EQ(run.visits, reference.visits);
        EXPECT_EQ(run.Places(), reference.Places());
        EXPECT_EQ(Tied(run.diffusion.GetMeasures()), Tied(reference.diffusion.GetMeasures()));
      }
    }
  }
  itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(usual);
}

TEST(ParticleDiffusion, ARunCutIntoPiecesGivesTheSameBytes)
{
  const Volume                    volume = MakeScene({ 24, 20, 22 }, 0.2);
  const std::optional<SteadyRule> rules[] = { std::nullopt, SteadyRule{ 1e-9, false } };
  for (const PathRule pathRule : bothRules)
  {
    for (const auto & rule : rules)
    {
      auto settings = MakeSettings(volume, 3001, 0.05);
      settings.pathRule = pathRule;
      ParticleRun reference(volume, settings);
      reference.diffusion.Run(100, rule);
      ParticleRun run(volume, settings);
      for (const std::uint64_t step : { 0, 1, 2, 2, 9, 30, 31, 99, 100 })
      {
        run.diffusion.Run(step, rule);
      }
      EXPECT_EQ(run.visits, reference.visits);
      EXPECT_EQ(run.Places(), reference.Places());
      EXPECT_EQ(Tied(run.diffusion.GetMeasures()), Tied(reference.diffusion.GetMeasures()));
    }
  }
}

TEST(ParticleDiffusion, AnotherSeedGivesOtherVisits)
{
  const Volume volume = MakeScene({ 12, 12, 12 }, 0.2);
  auto         settings = MakeSettings(volume, 1000, 0.1);
  ParticleRun  one(volume, settings);
  settings.seed = (std::uint64_t{ 1 } << 32) + 1;
  ParticleRun two(volume, settings);
  EXPECT_NE(one.Places(), two.Places());
  one.diffusion.Run(3);
  two.diffusion.Run(3);
  EXPECT_NE(one.visits, two.visits);
}

TEST(ParticleDiffusion, TheChangeIsThatOfNormalizedDensities)
{
  // 40000 shapetons use several threads; with 7, the maximum number of visits jumps.
  const Volume volume = MakeScene({ 14, 13, 12 }, 0.4);
  for (const std::uint32_t shapetons : { 7, 40000 })
  {
    ParticleRun                run(volume, MakeSettings(volume, shapetons, 0.1));
    std::vector<std::uint32_t> before(volume.values.size(), 0);
    for (std::uint64_t step = 1; step <= 60; ++step)
    {
      run.diffusion.Run(step);
      const double expected = ChangeBetween(before, run.visits);
      EXPECT_NEAR(run.diffusion.GetMeasures().change, expected, 1e-9 * expected);
      before = run.visits;
    }
  }
}

TEST(ParticleDiffusion, OneVoxelIsSteadyAfterFiftySteps)
{
  // The density is always 1, so the change is 1 in the first step and 0 in all others.
  const Volume volume({ 1, 1, 1 }, 1.0F);
  ParticleRun  run(volume, MakeSettings(volume, 10, 0.5));
  run.diffusion.Run(1, SteadyRule());
  EXPECT_EQ(run.diffusion.GetMeasures().change, 1.0);
  run.diffusion.Run(1000, SteadyRule());
  EXPECT_TRUE(run.diffusion.GetMeasures().steady);
  EXPECT_EQ(run.diffusion.GetMeasures().step, 50U);
  EXPECT_EQ(run.visits[0], 500U);
  EXPECT_NEAR(run.diffusion.GetMeasures().change, 0.0, 1e-15);
}

TEST(ParticleDiffusion, SteadyIsWhenTheChangeIsSmallInNineOfTenOfFiftySteps)
{
  const Volume volume = MakeScene({ 8, 8, 8 }, 0.4);
  const auto   settings = MakeSettings(volume, 300, 0.2);
  for (const SteadyRule rule : { SteadyRule{ 0.02, false }, SteadyRule{ 0.005, false }, SteadyRule{ 0.0, true } })
  {
    ParticleRun       counted(volume, settings);
    std::vector<bool> small;
    std::uint64_t     expected = 0;
    for (std::uint64_t step = 1; expected == 0 && step < 3000; ++step)
    {
      counted.diffusion.Run(step);
      const ParticleMeasures & measures = counted.diffusion.GetMeasures();
      small.push_back(measures.change <= (rule.automatic ? measures.automaticEpsilon : rule.epsilon));
      const bool last50 = step >= 50 && std::count(small.end() - 50, small.end(), true) >= 45;
      expected = last50 ? step : 0;
    }
    ASSERT_GT(expected, 50U);
    ParticleRun run(volume, settings);
    run.diffusion.Run(100000, rule);
    EXPECT_TRUE(run.diffusion.GetMeasures().steady);
    EXPECT_EQ(run.diffusion.GetMeasures().step, expected);
    EXPECT_EQ(run.visits, counted.visits);
    run.diffusion.Run(100001, rule);
    EXPECT_EQ(run.diffusion.GetMeasures().step, expected);
  }
}

TEST(ParticleDiffusion, TheObserverSeesWholeSteps)
{
  // A step is divided if there are more shapetons than are moved between two clock checks.
  const Volume volume = MakeScene({ 30, 30, 30 }, 0.1);
  for (const PathRule rule : bothRules)
  {
    auto settings = MakeSettings(volume, rule == PathRule::Endpoint ? 600000 : 70000, 0.05);
    settings.pathRule = rule;
    ParticleRun run(volume, settings);
    std::size_t calls = 0;
    run.diffusion.Run(4, {}, [&](const ParticleMeasures & measures) {
      ++calls;
      EXPECT_EQ(run.SumOfVisits(), measures.step * settings.shapetons);
    });
    EXPECT_GE(calls, 4U);
    EXPECT_THROW(run.diffusion.Run(8, {}, [](const ParticleMeasures &) { throw std::runtime_error("enough"); }),
                 std::runtime_error);
    EXPECT_EQ(run.diffusion.GetMeasures().step, 5U);
  }
}

TEST(ParticleDiffusion, ALongStepCanBeAbortedByThePoll)
{
  const Volume               volume({ 10, 10, 10 }, 1.0F);
  auto                       settings = MakeSettings(volume, 70000, 0.05);
  std::vector<std::uint32_t> visits(volume.values.size());
  bool                       enough = false;
  settings.pathRule = PathRule::Traversal;
  ParticleDiffusion diffusion(volume, settings, nullptr, visits.data(), [&] {
    if (enough)
    {
      throw std::runtime_error("enough");
    }
  });
  diffusion.Run(1);
  enough = true;
  EXPECT_THROW(diffusion.Run(2), std::runtime_error);
}

TEST(ParticleDiffusion, WithoutWeightsShapetonsStay)
{
  const Volume               volume = MakeCheckerboard({ 7, 6, 5 });
  const std::size_t          start = (2 * 6 + 3) * 7 + 4;
  std::vector<unsigned char> mask(volume.values.size(), 0);
  mask[start] = 1;
  for (const PathRule rule : bothRules)
  {
    for (const DirectionSampling sampling : allSamplings)
    {
      auto settings = MakeSettings(volume, 777, 0.5);
      settings.pathRule = rule;
      settings.directionSampling = sampling;
      ParticleRun run(volume, settings, mask);
      EXPECT_EQ(run.diffusion.GetMeasures().trappedShapetons, 777U);
      run.diffusion.Run(30);
      EXPECT_EQ(run.visits[start], 777U * 30U);
      EXPECT_EQ(run.SumOfVisits(), 777U * 30U);
      EXPECT_EQ(run.diffusion.GetMeasures().trappedShapetons, 777U);
      EXPECT_EQ(run.diffusion.GetMeasures().GetCoverage(), 1.0);
    }
  }
}

TEST(ParticleDiffusion, TraversalStopsAtAWallAndAnEndpointMayLieBehindIt)
{
  Volume                     volume({ 20, 20, 20 }, 0.0F);
  std::vector<unsigned char> inside(volume.values.size(), 0);
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    const std::size_t place[3] = { i % 20, i / 20 % 20, i / 400 };
    const bool        box = std::all_of(place, place + 3, [](std::size_t index) { return index >= 6 && index < 13; });
    inside[i] = box;
    volume.values[i] = box ? 1.0F : 0.0F;
  }
  for (const PathRule rule : bothRules)
  {
    auto settings = MakeSettings(volume, 2000, 0.4);
    settings.pathRule = rule;
    ParticleRun run(volume, settings, inside);
    run.diffusion.Run(50);
    std::uint64_t outside = 0;
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
      outside += inside[i] ? 0 : run.visits[i];
    }
    EXPECT_EQ(outside > 0, rule == PathRule::Endpoint);
  }
}

TEST(ParticleDiffusion, AStepHasOneLengthInMillimeters)
{
  Volume volume({ 60, 50, 20 }, 1.0F);
  volume.spacing = { 0.7, 0.9, 2.5 };
  const auto            settings = MakeSettings(volume, 60000, 0.1);
  const double          length = 0.1 * 50.0; // the longest side has 20 x 2.5 mm
  ParticleRun           run(volume, settings);
  const auto            before = run.Places();
  std::array<double, 3> squares{};
  std::size_t           number = 0;
  run.diffusion.Run(1);
  for (std::size_t i = 0; i < settings.shapetons; ++i)
  {
    const auto            place = run.PlaceOf(i);
    std::array<double, 3> way{};
    bool                  central = true;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double spacing = volume.spacing[axis];
      const double start = before[axis][i] * spacing;
      central = central && start > length && start + length < static_cast<double>(volume.size[axis]) * spacing;
      way[axis] = (place[axis] - before[axis][i]) * spacing;
    }
    if (central)
    {
      ++number;
      EXPECT_NEAR(std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]), length, 1e-4);
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        squares[axis] += way[axis] * way[axis];
      }
    }
  }
  ASSERT_GT(number, 20000U);
  for (const double square : squares)
  {
    // The standard deviation of one squared component is 0.298.
    EXPECT_NEAR(square / static_cast<double>(number) / (length * length), 1.0 / 3.0, 5.0 * 0.298 / std::sqrt(number));
  }
}

TEST(ParticleDiffusion, RefusesSettingsOutOfRange)
{
  Volume     volume = MakeScene({ 8, 8, 8 }, 0.1);
  const auto construct = [&](const auto & spoil) {
    auto settings = MakeSettings(volume, 100, 0.1);
    spoil(settings);
    ParticleRun run(volume, settings);
  };
  EXPECT_NO_THROW(construct([](auto &) {}));
  EXPECT_THROW(construct([](auto & settings) { settings.shapetons = 0; }), ParameterError);
  for (const double distance : { 0.0, -0.1, 1.0001, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(construct([&](auto & settings) { settings.distance = distance; }), ParameterError);
  }
  EXPECT_THROW(construct([](auto & settings) { settings.p = -1.0; }), ParameterError);
  EXPECT_THROW(construct([](auto & settings) { settings.intensityWindow = { { 9.0, 1.0 } }; }), ParameterError);
  volume.spacing[1] = 0.0;
  EXPECT_THROW(construct([](auto &) {}), InputError);
}

TEST(ParticleDiffusion, RefusesVolumesThatItCannotIndex)
{
  const auto settings = MakeSettings(Volume({ 1, 1, 1 }), 100, 0.1);
  const auto construct = [&](const test::Size & size) {
    const float       intensity = 0.0F;
    std::uint32_t     visits = 0;
    ParticleDiffusion diffusion(VolumeView(&intensity, size), settings, nullptr, &visits);
  };
  EXPECT_THROW(construct({ 0, 5, 5 }), InputError);
  EXPECT_THROW(construct({ std::size_t{ 1 } << 31, 1, 1 }), InputError);
  EXPECT_THROW(construct({ 2048, 1024, 1024 }), InputError);
  EXPECT_THROW(construct({ std::size_t{ 1 } << 32, std::size_t{ 1 } << 32, 1 }), InputError);
  EXPECT_THROW(construct({ 3, std::size_t{ 1 } << 63, 1 }), InputError);
}

TEST(ParticleDiffusion, RefusesMoreVisitsThanItCanCount)
{
  // Two million shapetons in one voxel exceed 2^32 visits in step 2148. A saved state avoids the preceding steps.
  const Volume volume({ 1, 1, 1 }, 1.0F);
  ParticleRun  run(volume, MakeSettings(volume, 2000000, 0.5));
  run.diffusion.Run(1);
  ParticleState state = run.diffusion.GetState();
  state.step = 2146;
  state.visits[0] = 2146U * 2000000U;
  run.diffusion.SetState(state);
  EXPECT_NO_THROW(run.diffusion.Run(2147));
  EXPECT_EQ(run.visits[0], 2147U * 2000000U);
  EXPECT_THROW(run.diffusion.Run(2148), InputError);
}

TEST(ParticleDiffusion, TheEquivalentTimeOfHeatIsThatOfTheSameSpread)
{
  const Volume               volume({ 41, 41, 41 }, 1.0F);
  const std::size_t          center = (20 * 41 + 20) * 41 + 20;
  std::vector<unsigned char> mask(volume.values.size(), 0);
  mask[center] = 1;
  for (const double step : { 0.3, 0.8, 1.0, 1.16, 1.5, 2.5 })
  {
    // The component along an axis and the position in the voxel are uniformly distributed.
    const auto square = [](double way) {
      const double whole = std::floor(way);
      return whole * whole + (way - whole) * (2.0 * whole + 1.0);
    };
    double variance = 0.0;
    for (double begin = 0.0; begin < step; begin += 1.0)
    {
      variance += Gauss()(begin, std::min(begin + 1.0, step), square) / step;
    }
    const double dt = 1.0 / 12.0;
    EXPECT_NEAR(2.0 * dt * EquivalentHeatTimeSteps(10, step, dt), 10.0 * variance, 1e-9 * variance);

    auto settings = MakeSettings(volume, 100000, step / 41.0);
    settings.pathRule = PathRule::Traversal;
    settings.directionSampling = DirectionSampling::Uniform;
    ParticleRun run(volume, settings, mask);
    run.diffusion.Run(10);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < settings.shapetons; ++i)
      {
        sum += std::pow(std::floor(run.PlaceOf(i)[axis]) - 20.0, 2);
      }
      // The displacement is close to normal: its square has the relative deviation sqrt(2).
      EXPECT_NEAR(
        sum / settings.shapetons, 10.0 * variance, 5.0 * std::sqrt(2.2 / settings.shapetons) * 10.0 * variance);
    }
  }
}
