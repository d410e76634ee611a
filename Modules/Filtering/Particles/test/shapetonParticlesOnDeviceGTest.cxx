#include "shapetonExceptions.h"
#include "shapetonDeviceTestTools.h"
#include "shapetonParticleTestRuns.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace shapeton;
using namespace shapeton::test;

struct Case
{
  DirectionSampling sampling;
  PathRule          rule;
};

constexpr Case cases[] = {
  { DirectionSampling::SolidAngle, PathRule::Endpoint },   { DirectionSampling::SectorArea, PathRule::Endpoint },
  { DirectionSampling::BinarySearch, PathRule::Endpoint }, { DirectionSampling::Uniform, PathRule::Endpoint },
  { DirectionSampling::SolidAngle, PathRule::Traversal },  { DirectionSampling::SectorArea, PathRule::Traversal },
  { DirectionSampling::Uniform, PathRule::Traversal }
};

void
ExpectSameState(const ParticleDiffusion & gpu, const ParticleDiffusion & cpu)
{
  const ParticleState a = gpu.GetState();
  const ParticleState b = cpu.GetState();
  EXPECT_EQ(a.identity, b.identity);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.change, b.change);
  EXPECT_EQ(a.steadyHistory, b.steadyHistory);
  EXPECT_EQ(a.places, b.places);
  EXPECT_EQ(a.visits, b.visits);
  const ParticleMeasures & m = gpu.GetMeasures();
  const ParticleMeasures & n = cpu.GetMeasures();
  EXPECT_EQ(m.maximumVisits, n.maximumVisits);
  EXPECT_EQ(m.voxelsReached, n.voxelsReached);
  EXPECT_EQ(m.objectVoxelsReached, n.objectVoxelsReached);
  EXPECT_EQ(m.trappedShapetons, n.trappedShapetons);
  EXPECT_EQ(m.automaticEpsilon, n.automaticEpsilon);
}

void
ExpectTheSame(const Volume &                     volume,
              ParticleDiffusionOptions           settings,
              std::uint64_t                      steps,
              const std::optional<SteadyRule> &  rule = {},
              const std::vector<unsigned char> & mask = {})
{
  settings.device = Device::Cpu;
  ParticleRun cpu(volume, settings, mask);
  settings.device = Device::Cuda;
  ParticleRun gpu(volume, settings, mask);
  EXPECT_TRUE(gpu.diffusion.GetDeviceUse().gpu);
  cpu.diffusion.Run(steps, rule);
  gpu.diffusion.Run(steps, rule);
  ExpectSameState(gpu.diffusion, cpu.diffusion);
  EXPECT_EQ(gpu.SumOfVisits(), gpu.diffusion.GetMeasures().step * settings.shapetons);
}

Volume
MakeVolume(const Size & size)
{
  return MakeScene(size, 0.05);
}

TEST(ShapetonsOnDevice, AllRulesAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeVolume(IsStandIn() ? Size{ 64, 64, 64 } : Size{ 256, 256, 256 });
  for (const Case & each : cases)
  {
    auto settings = MakeSettings(volume, IsStandIn() ? 3001 : 65536, 0.05);
    settings.directionSampling = each.sampling;
    settings.pathRule = each.rule;
    ExpectTheSame(volume, settings, 50);
  }
}

TEST(ShapetonsOnDevice, OddAnisotropicVolumesWithMasksAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  for (const Size & size : { Size{ 33, 17, 29 }, Size{ 1, 1, 1 }, Size{ 2, 40, 3 } })
  {
    const Volume               volume = MakeScene(size, 0.05, { { 0.7, 0.9, 2.5 } });
    std::vector<unsigned char> mask(volume.values.size(), 1);
    for (std::size_t i = 0; i + 1 < mask.size(); i += 2)
    {
      mask[i] = 0;
    }
    for (const Case & each : cases)
    {
      auto settings = MakeSettings(volume, 517, 0.21);
      settings.directionSampling = each.sampling;
      settings.pathRule = each.rule;
      settings.seed = 7;
      ExpectTheSame(volume, settings, 33, {}, mask);
    }
  }
}

TEST(ShapetonsOnDevice, TheSteadyStateIsFoundAtTheSameStep)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeVolume({ 20, 21, 22 });
  ExpectTheSame(volume, MakeSettings(volume, 4000, 0.1), 3000, SteadyRule{ 0.05, true });
}

TEST(ShapetonsOnDevice, ARunGoesOnOnTheOtherDevice)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeVolume({ 33, 17, 29 });
  auto         settings = MakeSettings(volume, 2000, 0.1);
  settings.device = Device::Cpu;
  ParticleRun whole(volume, settings);
  whole.diffusion.Run(100);
  for (const auto & [first, second] : { std::pair(Device::Cpu, Device::Cuda), std::pair(Device::Cuda, Device::Cpu) })
  {
    settings.device = first;
    ParticleRun begun(volume, settings);
    begun.diffusion.Run(37);
    settings.device = second;
    ParticleRun resumed(volume, settings);
    resumed.diffusion.SetState(begun.diffusion.GetState());
    resumed.diffusion.Run(100);
    ExpectSameState(resumed.diffusion, whole.diffusion);
  }
}

TEST(ShapetonsOnDevice, TheObserverSeesTheVisitsOfItsStep)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeVolume({ 33, 17, 29 });
  auto         settings = MakeSettings(volume, 60000, 0.1);
  settings.device = Device::Cuda;
  ParticleRun run(volume, settings);
  unsigned    calls = 0;
  run.diffusion.Run(IsStandIn() ? 40 : 4000, {}, [&](const ParticleMeasures & measures) {
    EXPECT_EQ(run.SumOfVisits(), measures.step * settings.shapetons);
    ++calls;
  });
  EXPECT_GE(calls, 1U);
}

TEST(ShapetonsOnDevice, TooLittleMemoryIsAnErrorOrTheCpu)
{
  SHAPETON_REQUIRE_DEVICE();
  const Volume volume = MakeVolume({ 33, 17, 29 });
  auto         settings = MakeSettings(volume, 2000, 0.1);
  setenv("SHAPETON_DEVICE_MEMORY", "100000", 1);
  settings.device = Device::Cuda;
  EXPECT_THROW(ParticleRun(volume, settings), DeviceError);
  settings.device = Device::Automatic;
  EXPECT_FALSE(ParticleRun(volume, settings).diffusion.GetDeviceUse().gpu);
  unsetenv("SHAPETON_DEVICE_MEMORY");
}
} // namespace
