#include "shapetonHeatDiffusionSolver.h"
#include "shapetonAutomaticParameters.h"
#include "shapetonDiffusionTestVolumes.h"
#include "shapetonPi.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <numeric>
#include <stdexcept>

using namespace shapeton;
using namespace shapeton::test;
using Method = HeatDiffusionSolver::Method;

namespace
{
constexpr double dt = HeatDiffusionSolver::MaximumTimeStepLength;

/** All requested fields, in the order of the steps. */
struct Trajectory
{
  std::vector<std::vector<float>> fields;
  std::uint64_t                   lastStep{ 0 };
  std::vector<float>              last;
  bool                            steady{ false };
};

Trajectory
Diffuse(const VolumeGradientOperator &     volumeGradient,
        Method                             method,
        std::uint64_t                      lastStep,
        const std::vector<std::uint64_t> & steps,
        double                             timeStepLength = dt,
        bool                               untilSteady = false)
{
  const PaddedGrid &  grid = volumeGradient.GetGrid();
  HeatDiffusionSolver solver(volumeGradient, method, timeStepLength, 1e-5);
  if (untilSteady)
  {
    solver.StopWhenSteady({});
  }
  PaddedField heat(grid);
  volumeGradient.ComputeInitialHeat(heat);
  Trajectory trajectory;
  trajectory.fields.assign(steps.size(), std::vector<float>(grid.GetNumberOfVoxels()));
  const std::size_t nx = grid.GetSize()[0];
  trajectory.lastStep =
    solver.Run(heat, lastStep, steps, [&](std::size_t snapshot, std::size_t row, const float * values, unsigned int) {
      std::copy(values, values + nx, trajectory.fields[snapshot].data() + row * nx);
    });
  trajectory.last = Values(grid, heat);
  trajectory.steady = solver.IsSteady();
  return trajectory;
}

/** The largest error of all fields relative to brute force. */
double
LargestError(const Trajectory & trajectory, const std::vector<std::uint64_t> & steps, BruteForce brute)
{
  double        largest = 0.0;
  std::uint64_t step = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    for (; step < steps[i]; ++step)
    {
      brute.Step();
    }
    largest = std::max(largest, LargestDifference(trajectory.fields[i], brute.heat));
  }
  return largest;
}
} // namespace

TEST(HeatDiffusionSolver, CoefficientsEqualTheBinomialClosedForm)
{
  // ((1 + x) / 2)^t = cos^2t(theta / 2) = 4^-t (C(2t, t) + 2 sum_k C(2t, t + k) cos(k theta))
  for (const std::uint64_t t : { 1, 7, 100, 5000 })
  {
    const auto c = HeatDiffusionSolver::ChebyshevCoefficients(t, 1.0, 1e-12);
    double     expected = std::exp(std::lgamma(2.0 * t + 1.0) - 2.0 * std::lgamma(t + 1.0) - t * std::log(4.0));
    EXPECT_NEAR(c[0], expected, 1e-10);
    for (std::size_t k = 1; k < c.size(); ++k)
    {
      expected *= (k == 1 ? 2.0 : 1.0) * (t - k + 1.0) / (t + k);
      EXPECT_NEAR(c[k], expected, 1e-10) << "t = " << t << ", k = " << k;
    }
    EXPECT_NEAR(std::accumulate(c.begin(), c.end(), 0.0), 1.0, 1e-9);
  }
}

TEST(HeatDiffusionSolver, EverySnapshotMatchesBruteForce)
{
  const auto steps = MakeSnapshotSteps(10000, 512, SnapshotSpacing::Logarithmic);
  struct Case
  {
    double                p;
    std::array<double, 3> spacing;
  };
  for (const Case & c :
       { Case{ 2.0, { { 1.0, 1.0, 1.0 } } }, Case{ 7.0, { { 1.0, 1.0, 1.0 } } }, Case{ 15.0, { { 0.7, 0.9, 2.5 } } } })
  {
    const Volume                 volume = MakeScene({ 32, 32, 32 }, 0.05, c.spacing);
    const VolumeGradientOperator volumeGradient(volume, OptionsWith(c.p));
    const auto                   trajectory = Diffuse(volumeGradient, Method::Chebyshev, 10000, steps);
    EXPECT_LT(LargestError(trajectory, steps, BruteForce(volume, c.p, dt)), 1e-5) << "p = " << c.p;
  }
}

TEST(HeatDiffusionSolver, LinearlySpacedSnapshotsMatchBruteForce)
{
  const auto                   steps = MakeSnapshotSteps(2000, 512, SnapshotSpacing::Linear);
  const Volume                 volume = MakeScene({ 20, 17, 13 }, 0.05);
  const VolumeGradientOperator volumeGradient(volume);
  for (const Method method : { Method::Chebyshev, Method::Explicit })
  {
    const auto trajectory = Diffuse(volumeGradient, method, 2000, steps);
    EXPECT_LT(LargestError(trajectory, steps, BruteForce(volume, 7.0, dt)), 1e-5);
  }
}

TEST(HeatDiffusionSolver, FinalStateOfALargerVolumeMatchesBruteForce)
{
  const Volume                     volume = MakeScene({ 64, 64, 64 }, 0.05);
  const VolumeGradientOperator     volumeGradient(volume);
  const std::vector<std::uint64_t> steps{ 10, 3000 };
  const BruteForce                 brute(volume, 7.0, dt);
  EXPECT_LT(LargestError(Diffuse(volumeGradient, Method::Chebyshev, 3000, steps), steps, brute), 1e-5);
}

TEST(HeatDiffusionSolver, AShorterTimeStepMatchesBruteForce)
{
  const Volume                     volume = MakeScene({ 18, 16, 15 }, 0.1, { { 1.0, 1.0, 3.0 } });
  const VolumeGradientOperator     volumeGradient(volume, OptionsWith(5.0));
  const std::vector<std::uint64_t> steps{ 1, 2, 17, 900 };
  for (const Method method : { Method::Chebyshev, Method::Explicit })
  {
    const auto trajectory = Diffuse(volumeGradient, method, 900, steps, 0.03);
    EXPECT_LT(LargestError(trajectory, steps, BruteForce(volume, 5.0, 0.03)), 1e-5);
  }
}

TEST(HeatDiffusionSolver, AnEigenfunctionOfTheFreeVolumeDecaysAsItsEigenvalueSays)
{
  // All weights 1, heat 0 in the border: sin(pi (x+1) / (n+1)) along each axis.
  const Volume                 volume({ 15, 10, 12 }, 1.0F);
  const VolumeGradientOperator volumeGradient(volume);
  const PaddedGrid &           grid = volumeGradient.GetGrid();
  const std::uint64_t          t = 400;
  PaddedField                  heat(grid);
  std::vector<double>          expected;
  double                       eigenvalue = 0.0;
  for (const std::size_t n : volume.size)
  {
    eigenvalue += 2.0 - 2.0 * std::cos(shapeton::Pi / (n + 1.0));
  }
  ForVoxels(volume.size, [&](std::size_t, std::size_t x, std::size_t y, std::size_t z) {
    const double h = std::sin(shapeton::Pi * (x + 1) / 16.0) * std::sin(shapeton::Pi * (y + 1) / 11.0) *
                     std::sin(shapeton::Pi * (z + 1) / 13.0);
    heat.GetData()[grid.GetRow(y, z) + x] = static_cast<float>(h);
    expected.push_back(h * std::pow(1.0 - dt * eigenvalue, t));
  });
  HeatDiffusionSolver solver(volumeGradient, Method::Chebyshev, dt, 1e-5);
  EXPECT_EQ(solver.Run(heat, t), t);
  EXPECT_LT(LargestDifference(Values(grid, heat), expected), 1e-5);
}

TEST(HeatDiffusionSolver, AClosedObjectKeepsItsHeatAndEndsAtItsMean)
{
  Volume     volume({ 24, 24, 24 });
  const auto inside = [](std::size_t x, std::size_t y, std::size_t z) {
    return x >= 6 && x < 16 && y >= 5 && y < 12 && z >= 8 && z < 20;
  };
  volume.Fill([&](std::size_t x, std::size_t y, std::size_t z) { return inside(x, y, z) ? 1.0 : 0.0; });
  const VolumeGradientOperator volumeGradient(volume);
  const auto   trajectory = Diffuse(volumeGradient, Method::Chebyshev, 1000000, { 0, 50, 1000, 1000000 });
  const double voxels = 10 * 7 * 12;
  const double cutFaces = 2 * (10 * 7 + 7 * 12 + 12 * 10);
  for (const auto & field : trajectory.fields)
  {
    double sum = 0.0;
    ForVoxels(volume.size, [&](std::size_t i, std::size_t x, std::size_t y, std::size_t z) {
      sum += inside(x, y, z) ? field[i] : 0.0;
    });
    EXPECT_NEAR(sum, cutFaces / 6.0, 1e-5 * voxels);
  }
  ForVoxels(volume.size, [&](std::size_t i, std::size_t x, std::size_t y, std::size_t z) {
    EXPECT_NEAR(trajectory.last[i], inside(x, y, z) ? cutFaces / 6.0 / voxels : 0.0, 1e-5);
  });
}

TEST(HeatDiffusionSolver, ThreadsDoNotChangeABit)
{
  const Volume                 volume = MakeScene({ 70, 41, 53 }, 0.05);
  const VolumeGradientOperator volumeGradient(volume);
  const auto                   steps = MakeSnapshotSteps(3000, 40, SnapshotSpacing::Logarithmic);
  const auto                   fieldsOf = [](const Trajectory & run) { return std::make_pair(run.last, run.fields); };
  basetest::ExpectSameWithAnyThreads([&] { return fieldsOf(Diffuse(volumeGradient, Method::Chebyshev, 3000, steps)); },
                                     { 2, 3, 8 });
  basetest::ExpectSameWithAnyThreads(
    [&] {
      return fieldsOf(Diffuse(volumeGradient, Method::Explicit, 100, { 7, 100 }));
    },
    { 2, 3, 8 });
}

TEST(HeatDiffusionSolver, RequestedStepsDoNotChangeABit)
{
  const Volume                 volume = MakeScene({ 31, 22, 27 }, 0.05);
  const VolumeGradientOperator volumeGradient(volume);
  const auto                   compare = [&](Method method, std::uint64_t last, bool untilSteady) {
    const auto alone = Diffuse(volumeGradient, method, last, {}, dt, untilSteady);
    for (const std::size_t number : { 3, 60, 512 })
    {
      for (const auto spacing : { SnapshotSpacing::Linear, SnapshotSpacing::Logarithmic })
      {
        const auto run =
          Diffuse(volumeGradient, method, last, MakeSnapshotSteps(last, number, spacing), dt, untilSteady);
        EXPECT_EQ(run.last, alone.last) << last << " steps, " << number << " of them requested";
        EXPECT_EQ(run.lastStep, alone.lastStep);
        EXPECT_TRUE(untilSteady || run.fields.back() == run.last);
      }
    }
  };
  for (const std::uint64_t last : { 10, 900, 40000 })
  {
    compare(Method::Chebyshev, last, false);
  }
  compare(Method::Chebyshev, 100000, true);
  compare(Method::Explicit, 300, false);
}

TEST(HeatDiffusionSolver, StopsWhenSteadyAndNotBefore)
{
  Volume volume({ 20, 20, 20 });
  volume.Fill([](std::size_t x, std::size_t y, std::size_t z) {
    return x >= 5 && x < 15 && y >= 5 && y < 15 && z >= 5 && z < 15 ? 1.0 : 0.0;
  });
  const VolumeGradientOperator volumeGradient(volume);
  for (const Method method : { Method::Chebyshev, Method::Explicit })
  {
    const auto run = Diffuse(volumeGradient, method, 100000, {}, dt, true);
    EXPECT_TRUE(run.steady);
    EXPECT_LT(run.lastStep, 100000U);
    const auto end = Diffuse(volumeGradient, Method::Chebyshev, 1000000, {});
    EXPECT_LT(LargestDifference(run.last, end.last), 0.01); // the cube converges to 0.1
    const auto early = Diffuse(volumeGradient, method, run.lastStep / 3, {}, dt, true);
    EXPECT_FALSE(early.steady);
    EXPECT_EQ(early.lastStep, run.lastStep / 3);
  }
}

TEST(HeatDiffusionSolver, ALastStretchThatIsTooShortIsNotCalledSteady)
{
  Volume volume({ 40, 40, 40 });
  volume.Fill([](std::size_t x, std::size_t y, std::size_t z) {
    return std::min({ x, y, z }) >= 4 && std::max({ x, y, z }) < 36 ? 1.0 : 0.0;
  });
  const VolumeGradientOperator volumeGradient(volume);
  for (const Method method : { Method::Chebyshev, Method::Explicit })
  {
    // Time intervals end at 16, 40, 100, 250, 625; the cube becomes steady much later.
    for (const std::uint64_t last : { 17, 41, 101, 251, 626, 627 })
    {
      EXPECT_FALSE(Diffuse(volumeGradient, method, last, {}, dt, true).steady) << last;
    }
  }
}

TEST(HeatDiffusionSolver, AHotVoxelDoesNotHideThatOthersStillMove)
{
  const auto stop = [](bool withHotVoxel) {
    Volume volume({ 30, 30, 30 });
    volume.Fill([](std::size_t x, std::size_t y, std::size_t z) {
      return std::min({ x, y, z }) >= 3 && std::max({ x, y, z }) < 27 ? 0.5 : 0.0;
    });
    volume.At(0, 0, 0) = 1.0F; // use the same window for both volumes
    volume.At(28, 1, 28) = withHotVoxel ? 1.0F : 0.0F;
    const VolumeGradientOperator volumeGradient(volume);
    return Diffuse(volumeGradient, Method::Chebyshev, 1000000, {}, dt, true).lastStep;
  };
  EXPECT_EQ(stop(true), stop(false));
}

TEST(HeatDiffusionSolver, AFailureInAnyThreadReachesTheCaller)
{
  const Volume                 volume = MakeScene({ 16, 16, 16 }, 0.05);
  const VolumeGradientOperator volumeGradient(volume);
  const basetest::ThreadNumber four(4);
  for (const std::size_t failing : { 0, 100, 255 })
  {
    HeatDiffusionSolver solver(volumeGradient, Method::Chebyshev, dt, 1e-5);
    PaddedField         heat(volumeGradient.GetGrid());
    const auto          visitor = [failing](std::size_t, std::size_t row, const float *, unsigned int) {
      if (row == failing)
      {
        throw std::runtime_error("row");
      }
    };
    EXPECT_THROW(solver.Run(heat, 10, { 5 }, visitor), std::runtime_error);
  }
}

TEST(HeatDiffusionSolver, ProgressAscendsToOneAndMayAbort)
{
  const Volume                 volume = MakeScene({ 16, 16, 16 }, 0.05);
  const VolumeGradientOperator volumeGradient(volume);
  HeatDiffusionSolver          solver(volumeGradient, Method::Chebyshev, dt, 1e-5);
  PaddedField                  heat(volumeGradient.GetGrid());
  volumeGradient.ComputeInitialHeat(heat);
  std::vector<double> seen;
  solver.SetProgress([&](double share) { seen.push_back(share); });
  solver.Run(heat, 5000);
  ASSERT_GT(seen.size(), 5U);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_DOUBLE_EQ(seen.back(), 1.0);
  solver.SetProgress([](double) { throw std::runtime_error("stop"); });
  EXPECT_THROW(solver.Run(heat, 5000), std::runtime_error);
}

TEST(HeatDiffusionSolver, RefusesWhatItCannotDo)
{
  const Volume                 volume({ 4, 4, 4 }, 1.0F);
  const VolumeGradientOperator volumeGradient(volume);
  EXPECT_THROW(HeatDiffusionSolver(volumeGradient, Method::Chebyshev, 0.1, 1e-5), ParameterError);
  EXPECT_THROW(HeatDiffusionSolver(volumeGradient, Method::Chebyshev, 0.0, 1e-5), ParameterError);
  EXPECT_THROW(HeatDiffusionSolver(volumeGradient, Method::Chebyshev, dt, 1e-9), ParameterError);
  HeatDiffusionSolver solver(volumeGradient, Method::Chebyshev, dt, 1e-5);
  PaddedField         heat(volumeGradient.GetGrid());
  const auto          ignore = [](std::size_t, std::size_t, const float *, unsigned int) {};
  EXPECT_THROW(solver.Run(heat, 10, { 5, 3 }, ignore), ParameterError);
  EXPECT_THROW(solver.Run(heat, 10, { 5, 11 }, ignore), ParameterError);
  EXPECT_THROW(solver.Run(heat, 10, { 5, 5 }, ignore), ParameterError);
}
