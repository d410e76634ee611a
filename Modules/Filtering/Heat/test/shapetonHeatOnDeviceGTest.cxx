#include "shapetonExceptions.h"
#include "shapetonAutomaticParameters.h"
#include "shapetonCumulativeHeatDiffusion.h"
#include "shapetonDeviceTestTools.h"
#include "shapetonDiffusionTestVolumes.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>

namespace
{
using namespace shapeton;
using namespace shapeton::test;
using Settings = CumulativeHeatDiffusionSettings;

struct Run
{
  std::vector<float>                          heat;
  std::map<std::uint64_t, std::vector<float>> snapshots;
  CumulativeHeatDiffusionResult               result;
};

Run
Diffuse(const Volume & volume, Settings settings, Device device)
{
  Run run;
  settings.device = device;
  run.heat.resize(volume.values.size());
  run.result = DiffuseCumulativeHeat(
    volume, settings, run.heat.data(), nullptr, [&](std::uint64_t step, const std::vector<float> & heat) {
      run.snapshots[step] = heat;
    });
  return run;
}

bool
SameBytes(const std::vector<float> & a, const std::vector<float> & b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

void
ExpectTheSame(const Volume & volume, const Settings & settings)
{
  const Run cpu = Diffuse(volume, settings, Device::Cpu);
  const Run gpu = Diffuse(volume, settings, Device::Cuda);
  EXPECT_EQ(cpu.result.device, "cpu");
  EXPECT_NE(gpu.result.device, "cpu");
  EXPECT_TRUE(SameBytes(gpu.heat, cpu.heat)) << LargestDifference(gpu.heat, cpu.heat);
  EXPECT_TRUE(gpu.result.histogram == cpu.result.histogram);
  EXPECT_EQ(gpu.result.timeStep, cpu.result.timeStep);
  EXPECT_EQ(gpu.result.steady, cpu.result.steady);
  EXPECT_EQ(gpu.result.operatorApplications, cpu.result.operatorApplications);
  ASSERT_EQ(gpu.snapshots.size(), settings.snapshotSteps.size());
  for (const auto & [step, heat] : cpu.snapshots)
  {
    EXPECT_TRUE(SameBytes(gpu.snapshots.at(step), heat)) << step;
  }
}

Settings
MakeSettings(std::uint64_t steps)
{
  Settings settings;
  settings.timeSteps = steps;
  settings.snapshotSteps = { 0, 5, steps / 2, steps };
  settings.histogramSteps = MakeSnapshotSteps(steps, 65, SnapshotSpacing::Logarithmic);
  return settings;
}

/** Edge lengths of volumes with acceptable run time on a GPU; smaller for the emulation. */
Size
Large()
{
  return IsStandIn() ? Size{ 64, 64, 64 } : Size{ 256, 256, 256 };
}

TEST(HeatOnDevice, ExpansionAndHistogramAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume   volume = MakeScene(Large(), 0.05);
  const Settings settings = MakeSettings(20000);
  ExpectTheSame(volume, settings);
  const auto heat = Diffuse(volume, settings, Device::Cuda).heat;
  EXPECT_GT(*std::max_element(heat.begin(), heat.end()), 0.1F); // otherwise the comparison is not meaningful
}

TEST(HeatOnDevice, SlicesCountedForTheirNeighborsAreTheSame)
{
  SHAPETON_REQUIRE_DEVICE();
  Settings settings;
  settings.timeSteps = 1001; // two intervals
  settings.histogramSteps = MakeSnapshotSteps(1001, 20, SnapshotSpacing::Linear);
  ExpectTheSame(MakeScene({ 165, 160, 171 }, 0.05), settings); // every second slice, and a last one
}

TEST(HeatOnDevice, OddSizesAndAnisotropicVoxelsAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  for (const Size & size :
       { Size{ 33, 17, 29 }, Size{ 1, 1, 1 }, Size{ 1, 40, 3 }, Size{ 65, 2, 7 }, Size{ 5, 9, 131 } })
  {
    ExpectTheSame(MakeScene(size, 0.3, { { 0.7, 0.9, 2.5 } }), MakeSettings(700));
  }
}

TEST(HeatOnDevice, ExplicitStepsAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeScene({ 40, 31, 22 }, 0.05);
  Settings     settings = MakeSettings(333);
  settings.solver = HeatDiffusionSolver::Method::Explicit;
  ExpectTheSame(volume, settings);
  settings.untilSteady = true;
  settings.timeSteps = 3000;
  ExpectTheSame(volume, settings);
}

TEST(HeatOnDevice, TheSteadyStateIsFoundAtTheSameStep)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeScene({ 40, 31, 22 }, 0.05);
  Settings     settings = MakeSettings(1000000);
  settings.snapshotSteps = { 64 };
  settings.untilSteady = true;
  ExpectTheSame(volume, settings);
}

// Decaying heat passes through subnormal numbers.
TEST(HeatOnDevice, VanishingHeatIsTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  Volume volume({ 24, 24, 24 });
  volume.Fill([](std::size_t x, std::size_t, std::size_t) { return x == 12 ? 1.0 : 0.97; });
  Settings settings = MakeSettings(30000);
  ExpectTheSame(volume, settings);
  settings.solver = HeatDiffusionSolver::Method::Explicit;
  ExpectTheSame(volume, settings);
}

TEST(HeatOnDevice, SlabsOfALargerVolumeAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeScene({ 12, 9, 400 }, 0.05);
  setenv("SHAPETON_DEVICE_MEMORY", "20000000", 1);
  for (const auto method : { HeatDiffusionSolver::Method::Chebyshev, HeatDiffusionSolver::Method::Explicit })
  {
    Settings settings = MakeSettings(900);
    settings.solver = method;
    EXPECT_EQ(Diffuse(volume, settings, Device::Automatic).result.device.rfind("cpu (no GPU: this volume requires", 0),
              0U);
    ExpectTheSame(volume, settings);
  }
  setenv("SHAPETON_DEVICE_MEMORY", "1000000", 1);
  EXPECT_THROW(Diffuse(volume, MakeSettings(900), Device::Cuda), DeviceError);
  unsetenv("SHAPETON_DEVICE_MEMORY");
}

TEST(HeatOnDevice, ThreadsDoNotChangeABit)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeScene({ 33, 17, 29 }, 0.05);
  for (const unsigned int threads : { 1, 3, 8 })
  {
    const basetest::ThreadNumber number(threads);
    ExpectTheSame(volume, MakeSettings(500));
  }
}
} // namespace
