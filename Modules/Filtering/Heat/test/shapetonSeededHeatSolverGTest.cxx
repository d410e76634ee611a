#include "shapetonSeededHeatSolver.h"

#include "shapetonExceptions.h"
#include "shapetonPhilox.h"
#include "shapetonTestThreads.h"

#include "gtest/gtest.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{
using shapeton::SeededHeatOptions;
using shapeton::SeededHeatSolver;
using shapeton::VolumeGradientOperator;
using shapeton::VolumeGradientOptions;
using shapeton::VolumeView;
using Size = std::array<std::size_t, 3>;
using Seeds = std::vector<unsigned short>;

std::size_t
NumberOf(const Size & size)
{
  return size[0] * size[1] * size[2];
}

/** Two noisy halves of different intensity. */
std::vector<float>
MakeNoisyHalves(const Size & size)
{
  std::mt19937                          random(7);
  std::uniform_real_distribution<float> noise(-0.04F, 0.04F);
  std::vector<float>                    volume(NumberOf(size));
  for (std::size_t i = 0; i < volume.size(); ++i)
  {
    volume[i] = (i % size[0] < size[0] / 2 ? 0.3F : 0.6F) + noise(random);
  }
  return volume;
}

VolumeGradientOperator
MakeOperator(const std::vector<float> & volume, const Size & size, double p, const std::array<double, 3> & spacing)
{
  VolumeGradientOptions options;
  options.p = p;
  options.intensityWindow = { { 0.0, 1.0 } };
  return VolumeGradientOperator(
    VolumeView(volume.data(), size, spacing), options, VolumeGradientOperator::Conductance::Physical, 1e-4);
}

Seeds
ScatterSeeds(const Size & size, unsigned short labels, int each)
{
  std::mt19937 random(3);
  Seeds        seeds(NumberOf(size), 0);
  for (unsigned short label = 1; label <= labels; ++label)
  {
    for (int i = 0; i < each; ++i)
    {
      seeds[random() % seeds.size()] = label;
    }
  }
  return seeds;
}

std::vector<float>
ProbabilitiesOf(const SeededHeatSolver & solver, unsigned short label)
{
  std::vector<float> probabilities(solver.GetResult().labels.size());
  solver.GetProbabilities(label, probabilities.data());
  return probabilities;
}

/** The same equations, solved by relaxation in double precision until convergence. */
std::vector<double>
SolveByRelaxation(const VolumeGradientOperator & op,
                  const Seeds &                  seeds,
                  unsigned short                 label,
                  const Seeds &                  before = {})
{
  const auto          size = op.GetGrid().GetSize();
  const Size          stride{ { 1, size[0], size[0] * size[1] } };
  std::vector<double> heat(seeds.size(), 0.0);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    heat[i] = seeds[i] == label ? 1.0 : 0.0;
  }
  const auto weight = [&](std::size_t x, std::size_t y, std::size_t z, unsigned int axis) {
    return double{ op.GetConductances(axis)[op.GetGrid().GetRow(y, z) + x] };
  };
  for (double change = 1.0; change > 1e-11;)
  {
    change = 0.0;
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      const Size v{ { i % size[0], i / stride[1] % size[1], i / stride[2] } };
      double     total = !before.empty() && before[i] != 0 ? SeededHeatSolver::ConductanceToLabelBefore : 0.0;
      double     sum = total > 0.0 && before[i] == label ? total : 0.0;
      for (unsigned int axis = 0; axis < 3 && seeds[i] == 0; ++axis)
      {
        Size below = v;
        if (v[axis] > 0)
        {
          --below[axis];
          const double c = weight(below[0], below[1], below[2], axis);
          sum += c * heat[i - stride[axis]];
          total += c;
        }
        if (v[axis] + 1 < size[axis])
        {
          const double c = weight(v[0], v[1], v[2], axis);
          sum += c * heat[i + stride[axis]];
          total += c;
        }
      }
      if (seeds[i] == 0)
      {
        // over-relaxed
        const double next = heat[i] + 1.7 * (sum / total - heat[i]);
        change = std::max(change, std::abs(next - heat[i]));
        heat[i] = next;
      }
    }
  }
  return heat;
}

/** Grady's random walker, weights exp(-beta (I_i - I_j)^2), by a sparse factorization in double precision: the heat
 * of a label in each voxel. */
std::vector<double>
WalkAtRandom(const std::vector<float> & volume,
             const Size &               size,
             const Seeds &              seeds,
             unsigned short             label,
             double                     beta)
{
  const auto                          number = static_cast<Eigen::Index>(volume.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd                     inflow = Eigen::VectorXd::Zero(number);
  const auto                          addWeight = [&](std::size_t i, std::size_t j) {
    if (seeds[i] != 0)
    {
      return;
    }
    const double weight = std::exp(-beta * std::pow(static_cast<double>(volume[i]) - volume[j], 2));
    entries.emplace_back(i, i, weight);
    if (seeds[j] == 0)
    {
      entries.emplace_back(i, j, -weight);
    }
    inflow[i] += seeds[j] == label ? weight : 0.0;
  };
  std::size_t stride = 1;
  for (const std::size_t length : size)
  {
    for (std::size_t i = 0; i < volume.size(); ++i)
    {
      if (i / stride % length + 1 < length)
      {
        addWeight(i, i + stride);
        addWeight(i + stride, i);
      }
    }
    stride *= length;
  }
  for (std::size_t i = 0; i < volume.size(); ++i)
  {
    if (seeds[i] != 0)
    {
      entries.emplace_back(i, i, 1.0);
      inflow[i] = seeds[i] == label ? 1.0 : 0.0;
    }
  }
  Eigen::SparseMatrix<double> laplacian(number, number);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd heat = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(inflow);
  return { heat.data(), heat.data() + number };
}

double
GreatestDifference(const std::vector<float> & a, const std::vector<double> & b)
{
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    difference = std::max(difference, std::abs(a[i] - b[i]));
  }
  return difference;
}
} // namespace

TEST(SeededHeatSolver, AWindowWithoutContrastIsRemarked)
{
  const std::vector<float> values{ 0.0F, 1.0F, 0.0F, 1.0F };
  const VolumeView         volume(values.data(), { { 4, 1, 1 } });
  EXPECT_TRUE(shapeton::RemarksOnWindow(volume, { { 0.0, 1.0 } }).empty());
  EXPECT_TRUE(shapeton::RemarksOnWindow(volume, { { 0.0, 99.0 } }).empty());
  ASSERT_EQ(shapeton::RemarksOnWindow(volume, { { -160.0, 240.0 } }).size(), 1U);
  EXPECT_NE(shapeton::RemarksOnWindow(volume, { { -160.0, 240.0 } })[0].find("from 0 to 1"), std::string::npos);
  EXPECT_NE(shapeton::RemarksOnWindow(volume, { { 5000.0, 6000.0 } })[0].find("no edges"), std::string::npos);
}

TEST(SeededHeatSolver, BetweenTwoPlatesHeatFallsInAStraightLine)
{
  const Size size{ { 33, 5, 4 } };
  for (const std::array<double, 3> & spacing : { std::array<double, 3>{ { 1, 1, 1 } }, { { 0.7, 1.1, 2.5 } } })
  {
    const std::vector<float> volume(NumberOf(size), 0.5F);
    const auto               op = MakeOperator(volume, size, 20.0, spacing);
    Seeds                    seeds(volume.size(), 0);
    for (std::size_t i = 0; i < seeds.size(); i += size[0])
    {
      seeds[i] = 9;
      seeds[i + size[0] - 1] = 4;
    }
    SeededHeatSolver solver(op);
    const auto &     result = solver.Solve(seeds.data());
    EXPECT_EQ(result.labelValues, (Seeds{ 4, 9 }));
    const auto probabilities = ProbabilitiesOf(solver, 9);
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      const double x = static_cast<double>(i % size[0]);
      EXPECT_NEAR(probabilities[i], 1.0 - x / 32.0, 1e-5);
      EXPECT_NEAR(result.uncertainty[i], 1.0 - std::abs(1.0 - x / 16.0), 2e-5);
      if (x != 16)
      {
        EXPECT_EQ(result.labels[i], x < 16 ? 9 : 4); // the boundary is at one half
      }
    }
  }
}

TEST(SeededHeatSolver, MatchesRelaxationInDoublePrecision)
{
  const Size size{ { 13, 11, 9 } };
  const auto volume = MakeNoisyHalves(size);
  for (const std::array<double, 3> & spacing : { std::array<double, 3>{ { 1, 1, 1 } }, { { 0.8, 0.8, 3.0 } } })
  {
    for (const double p : { 0.0, 7.0, 20.0 })
    {
      for (const unsigned short labels : { 2, 3, 4, 7 })
      {
        const auto       op = MakeOperator(volume, size, p, spacing);
        const auto       seeds = ScatterSeeds(size, labels, 4);
        SeededHeatSolver solver(op);
        solver.Solve(seeds.data());
        for (const unsigned short label : solver.GetResult().labelValues)
        {
          EXPECT_LE(GreatestDifference(ProbabilitiesOf(solver, label), SolveByRelaxation(op, seeds, label)), 1e-5)
            << "p " << p << ", label " << label << " of " << labels;
        }
      }
    }
  }
}

TEST(SeededHeatSolver, IsARandomWalkerWhereItsWeightsAreSetEqual)
{
  const Size         size{ { 19, 17, 15 } };
  std::mt19937       random(11);
  std::vector<float> volume(NumberOf(size));
  for (std::size_t i = 0; i < volume.size(); ++i) // a block of ones in zeros; every sixth voxel is flipped
  {
    volume[i] = ((i % size[0] < 8) != (random() % 6 == 0)) ? 1.0F : 0.0F;
  }
  const auto seeds = ScatterSeeds(size, 3, 5);
  for (const double weight : { 0.5, 0.1, 0.01, 0.001 }) // edge from 0 to 1: 1 - p, and exp(-beta) for Grady's walker
  {
    const auto       op = MakeOperator(volume, size, 1.0 - weight, { { 1, 1, 1 } });
    SeededHeatSolver solver(op);
    solver.Solve(seeds.data());
    for (const unsigned short label : { 1, 2, 3 })
    {
      const auto expected = WalkAtRandom(volume, size, seeds, label, -std::log(weight));
      EXPECT_LE(GreatestDifference(ProbabilitiesOf(solver, label), expected), 1e-5) << weight << ", label " << label;
    }
  }
}

TEST(SeededHeatSolver, ProbabilitiesSumToOneAndTheGreatestGivesTheLabel)
{
  const Size         size{ { 40, 33, 27 } };
  const auto         volume = MakeNoisyHalves(size);
  const auto         op = MakeOperator(volume, size, 12.0, { { 1, 1, 1 } });
  const auto         seeds = ScatterSeeds(size, 11, 5);
  SeededHeatSolver   solver(op);
  const auto &       result = solver.Solve(seeds.data());
  std::vector<float> sum(seeds.size(), 0.0F);
  std::vector<float> ofLabel(seeds.size(), 0.0F);
  std::vector<float> greatest(seeds.size(), 0.0F);
  for (unsigned short label = 1; label <= 11; ++label)
  {
    const auto probabilities = ProbabilitiesOf(solver, label);
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      ASSERT_GE(probabilities[i], 0.0F);
      ASSERT_LE(probabilities[i], 1.0F);
      sum[i] += probabilities[i];
      greatest[i] = std::max(greatest[i], probabilities[i]);
      ofLabel[i] = result.labels[i] == label ? probabilities[i] : ofLabel[i];
      if (seeds[i] != 0)
      {
        ASSERT_EQ(probabilities[i], seeds[i] == label ? 1.0F : 0.0F);
      }
    }
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    ASSERT_NEAR(sum[i], 1.0F, 1e-5F);
    ASSERT_EQ(ofLabel[i], greatest[i]);
  }
}

TEST(SeededHeatSolver, LabelsStopAtAnEdgeThatInsulates)
{
  const Size size{ { 24, 20, 16 } };
  const auto volume = MakeNoisyHalves(size);
  const auto op = MakeOperator(volume, size, 5.0, { { 1, 1, 1 } }); // noise of .08 passes, a step of .3 does not
  Seeds      seeds(volume.size(), 0);
  seeds[0] = 1;
  seeds[size[0] - 1] = 2;
  SeededHeatSolver solver(op);
  const auto &     result = solver.Solve(seeds.data());
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    ASSERT_EQ(result.labels[i], i % size[0] < 12 ? 1 : 2);
  }
}

// In a uniform volume a walker that starts next to a point reaches it with the probability 0.3405 (Polya). A point
// surrounded by other seeds thus gains no voxel; a ball of seeds gains voxels up to about twice its radius.
TEST(SeededHeatSolver, APointInAnEvenVolumeGetsNoVoxelAndIsRemarkedOn)
{
  const std::size_t        side = 41;
  const Size               size{ { side, side, side } };
  const std::vector<float> volume(NumberOf(size), 0.5F);
  const auto               volumeGradient = MakeOperator(volume, size, 7.0, { { 1.0, 1.0, 1.0 } });
  SeededHeatSolver         solver(volumeGradient);
  const auto               solve = [&](double radius) {
    Seeds seeds(NumberOf(size), 0);
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      double square = 0.0;
      for (const std::size_t x : { i % side, i / side % side, i / side / side })
      {
        seeds[i] = x == 0 || x == side - 1 ? 1 : seeds[i];
        square += (static_cast<double>(x) - 20.0) * (static_cast<double>(x) - 20.0);
      }
      seeds[i] = square <= radius * radius ? 2 : seeds[i];
    }
    const auto & result = solver.Solve(seeds.data());
    return std::count(result.labels.begin(), result.labels.end(), 2) - std::count(seeds.begin(), seeds.end(), 2);
  };
  EXPECT_EQ(solve(0.0), 0);
  EXPECT_NEAR(ProbabilitiesOf(solver, 2)[(20 * side + 20) * side + 21], 0.3405, 0.02) << "the faces are 20 voxels away";
  ASSERT_EQ(solver.GetResult().remarks.size(), 1u);
  EXPECT_EQ(solver.GetResult().remarks.front().find("label 2 has 1 seed and gains only 0 voxels; "), 0u);
  EXPECT_GT(solve(4.0), 2 * 257) << "two times its seeds, and less than the seven times of an endless volume";
  EXPECT_TRUE(solver.GetResult().remarks.empty());
}

TEST(SeededHeatSolver, WhereNearlyAllVoxelsHaveSeedsThereIsNothingToRemarkOn)
{
  const Size size{ { 13, 11, 9 } };
  const auto volume = MakeNoisyHalves(size);
  const auto volumeGradient = MakeOperator(volume, size, 7.0, { { 1.0, 1.0, 1.0 } });
  Seeds      seeds(NumberOf(size), 1);
  seeds[0] = 2;
  std::fill(seeds.begin() + 100, seeds.begin() + 200, 0);
  EXPECT_TRUE(SeededHeatSolver(volumeGradient).Solve(seeds.data()).remarks.empty());
}

TEST(SeededHeatSolver, SameBytesForAnyNumberOfThreads)
{
  const Size size{ { 37, 29, 31 } };
  const auto volume = MakeNoisyHalves(size);
  const auto seeds = ScatterSeeds(size, 6, 3);
  const auto op = MakeOperator(volume, size, 20.0, { { 1, 1, 1 } });
  basetest::ExpectSameWithAnyThreads(
    [&] {
      SeededHeatSolver solver(op);
      solver.Solve(seeds.data());
      return std::make_tuple(solver.GetResult().labels, solver.GetResult().uncertainty, ProbabilitiesOf(solver, 3));
    },
    { 2, 3, 8 });
}

TEST(SeededHeatSolver, AChangedSeedStartsFromTheLastSolution)
{
  const Size       size{ { 48, 48, 48 } };
  const auto       volume = MakeNoisyHalves(size);
  const auto       op = MakeOperator(volume, size, 15.0, { { 1, 1, 1 } });
  auto             seeds = ScatterSeeds(size, 4, 40);
  SeededHeatSolver solver(op);
  solver.Solve(seeds.data());
  const unsigned int cold = solver.GetResult().iterations;
  EXPECT_EQ(solver.Solve(seeds.data()).iterations, 0u); // unchanged seeds
  const auto & uncertainty = solver.GetResult().uncertainty;
  std::size_t  sure = 0; // a seed that agrees with the solution
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    sure = seeds[i] == 0 && (seeds[sure] != 0 || uncertainty[i] < uncertainty[sure]) ? i : sure;
  }
  seeds[sure] = solver.GetResult().labels[sure];
  EXPECT_LT(solver.Solve(seeds.data()).iterations, cold);
  *std::find(seeds.begin(), seeds.end(), 2) = 0; // a seed is removed, another one is added
  seeds[seeds.size() / 2] = 3;
  EXPECT_LE(solver.Solve(seeds.data()).iterations, cold);
  SeededHeatSolver anew(op);
  anew.Solve(seeds.data());
  for (const unsigned short label : { 1, 2, 3, 4 })
  {
    const auto expected = ProbabilitiesOf(anew, label);
    EXPECT_LE(GreatestDifference(ProbabilitiesOf(solver, label), { expected.begin(), expected.end() }), 2e-5);
  }
}

TEST(SeededHeatSolver, WithoutKeptProbabilitiesLabelsAreTheSame)
{
  const Size        size{ { 30, 22, 18 } };
  const auto        volume = MakeNoisyHalves(size);
  const auto        op = MakeOperator(volume, size, 15.0, { { 1, 1, 1 } });
  const auto        seeds = ScatterSeeds(size, 9, 4);
  SeededHeatOptions settings;
  settings.keepProbabilities = false;
  SeededHeatSolver keeps(op);
  SeededHeatSolver forgets(op, settings);
  EXPECT_EQ(keeps.Solve(seeds.data()).labels, forgets.Solve(seeds.data()).labels);
  EXPECT_EQ(keeps.GetResult().uncertainty, forgets.GetResult().uncertainty);
  std::vector<float> probabilities(seeds.size());
  EXPECT_THROW(forgets.GetProbabilities(1, probabilities.data()), shapeton::ParameterError);
  EXPECT_THROW(keeps.GetProbabilities(10, probabilities.data()), shapeton::ParameterError);
}

TEST(SeededHeatSolver, RefusesWhatItCannotSolve)
{
  const Size               size{ { 4, 4, 4 } };
  const std::vector<float> volume(64, 0.5F);
  const auto               op = MakeOperator(volume, size, 7.0, { { 1, 1, 1 } });
  Seeds                    seeds(64, 0);
  SeededHeatSolver         solver(op);
  EXPECT_THROW(solver.Solve(seeds.data()), shapeton::InputError);
  seeds[5] = 3;
  EXPECT_THROW(solver.Solve(seeds.data()), shapeton::InputError);
  SeededHeatOptions settings;
  settings.tolerance = 0.5;
  EXPECT_THROW(SeededHeatSolver(op, settings), shapeton::ParameterError);
  const VolumeGradientOperator insulating(VolumeView(volume.data(), size));
  EXPECT_THROW(SeededHeatSolver{ insulating }, shapeton::ParameterError);
}

TEST(SeededHeatSolver, AbortsAndStartsAnew)
{
  const Size       size{ { 32, 32, 32 } };
  const auto       volume = MakeNoisyHalves(size);
  const auto       op = MakeOperator(volume, size, 15.0, { { 1, 1, 1 } });
  const auto       seeds = ScatterSeeds(size, 3, 4);
  SeededHeatSolver solver(op);
  EXPECT_THROW(solver.Solve(seeds.data(),
                            [](double share) {
                              if (share > 0.3)
                              {
                                throw std::runtime_error("enough");
                              }
                            }),
               std::runtime_error);
  SeededHeatSolver other(op);
  EXPECT_EQ(solver.Solve(seeds.data()).labels, other.Solve(seeds.data()).labels);
}

TEST(SeededHeatSolver, SeedsCorrectLabelsBefore)
{
  const Size size{ { 24, 20, 18 } };
  const auto volume = MakeNoisyHalves(size);
  const auto op = MakeOperator(volume, size, 5.0, { { 1.0, 1.0, 1.0 } });
  Seeds      seeds(NumberOf(size), 0);
  Seeds      before(NumberOf(size), 2);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    before[i] = i % size[0] < 6 ? 0 : i % size[0] < 16 ? 1 : 2; // the edge is at 12: four layers are wrong
  }
  seeds[(9 * size[1] + 10) * size[0] + 14] = 2;
  SeededHeatOptions options;
  options.keepProbabilities = true;
  options.tolerance = 1e-5;
  SeededHeatSolver solver(op, options);
  const auto &     result = solver.Solve(seeds.data(), {}, before.data());
  EXPECT_EQ(result.labelValues, (std::vector<unsigned short>{ 1, 2 }));
  const auto expected = SolveByRelaxation(op, seeds, 1, before);
  const auto found = ProbabilitiesOf(solver, 1);
  double     corrected = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_NEAR(found[i], expected[i], 1e-4);
    corrected += before[i] == 1 && result.labels[i] == 2 ? 1.0 : 0.0;
    EXPECT_EQ(result.labels[i] == 1, i % size[0] < 12) << i % size[0];
  }
  EXPECT_EQ(corrected, 4.0 * size[1] * size[2]);
  EXPECT_TRUE(result.remarks.empty());
}
