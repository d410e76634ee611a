#include "shapetonParticleTestRuns.h"
#include "shapetonParticleTestTools.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
/** The positions of shapetons inside their voxels are uniformly distributed. */
void
ExpectEvenPlacesInVoxels(const ParticleRun & run, std::size_t shapetons)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    std::vector<std::uint64_t> counts(10, 0);
    for (std::size_t i = 0; i < shapetons; ++i)
    {
      const double place = run.PlaceOf(i)[axis];
      ++counts[static_cast<std::size_t>((place - std::floor(place)) * 10.0)];
    }
    EXPECT_LT(std::abs(ChiSquareDeviation(std::vector<double>(10, 0.1), counts)), 4.5);
  }
}

/** (2.3) in double precision. */
std::vector<double>
InitialHeat(const Volume & volume, double p)
{
  return BruteForce(volume, p, 1.0 / 12.0).heat;
}

std::vector<unsigned char>
EveryThird(const Volume & volume)
{
  std::vector<unsigned char> mask(volume.values.size(), 0);
  for (std::size_t i = 0; i < mask.size(); i += 3)
  {
    mask[i] = 7;
  }
  return mask;
}
} // namespace

TEST(ParticlePlacement, UniformPlacesAreEvenlyDistributed)
{
  const Volume              volume = MakeScene({ 13, 7, 9 }, 0.3);
  const auto                settings = MakeSettings(volume, 300000, 0.1);
  ParticleRun               run(volume, settings);
  const std::vector<double> even(volume.values.size(), 1.0);
  EXPECT_LT(std::abs(ChiSquareDeviation(even, run.CountByVoxel())), 4.5);
  ExpectEvenPlacesInVoxels(run, settings.shapetons);
}

TEST(ParticlePlacement, UniformPlacesStayInTheMask)
{
  const Volume        volume = MakeScene({ 13, 7, 9 }, 0.3);
  const auto          settings = MakeSettings(volume, 300000, 0.1);
  const auto          mask = EveryThird(volume);
  ParticleRun         run(volume, settings, mask);
  std::vector<double> expected(mask.size());
  std::transform(mask.begin(), mask.end(), expected.begin(), [](unsigned char value) { return value ? 1.0 : 0.0; });
  EXPECT_LT(std::abs(ChiSquareDeviation(expected, run.CountByVoxel())), 4.5);
  ExpectEvenPlacesInVoxels(run, settings.shapetons);
}

TEST(ParticlePlacement, InitialHeatDrawsThePlaces)
{
  const Volume volume = MakeScene({ 15, 11, 12 }, 0.3, { { 1.0, 1.5, 2.0 } });
  auto         settings = MakeSettings(volume, 500000, 0.1, 3.0);
  settings.placement = ParticlePlacement::InitialHeat;
  ParticleRun run(volume, settings);
  EXPECT_LT(std::abs(ChiSquareDeviation(InitialHeat(volume, settings.p), run.CountByVoxel())), 4.5);
  ExpectEvenPlacesInVoxels(run, settings.shapetons);
}

TEST(ParticlePlacement, InitialHeatDrawsThePlacesInTheMask)
{
  const Volume volume = MakeScene({ 15, 11, 12 }, 0.3);
  auto         settings = MakeSettings(volume, 500000, 0.1, 3.0);
  settings.placement = ParticlePlacement::InitialHeat;
  const auto  mask = EveryThird(volume);
  ParticleRun run(volume, settings, mask);
  auto        expected = InitialHeat(volume, settings.p);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    expected[i] = mask[i] ? expected[i] : 0.0;
  }
  EXPECT_LT(std::abs(ChiSquareDeviation(expected, run.CountByVoxel())), 4.5);
}

TEST(ParticlePlacement, AMaskOfOneVoxelHoldsAllShapetons)
{
  const Volume volume = MakeScene({ 15, 11, 12 }, 0.3);
  for (const std::size_t voxel : { std::size_t{ 0 }, std::size_t{ 777 }, volume.values.size() - 1 })
  {
    for (const auto placement : { ParticlePlacement::Uniform, ParticlePlacement::InitialHeat })
    {
      auto settings = MakeSettings(volume, 1000, 0.1);
      settings.placement = placement;
      std::vector<unsigned char> mask(volume.values.size(), 0);
      mask[voxel] = 255;
      ParticleRun run(volume, settings, mask);
      EXPECT_EQ(run.CountByVoxel()[voxel], 1000U);
    }
  }
}

TEST(ParticlePlacement, RefusesWhatHoldsNoShapeton)
{
  const Volume                     scene = MakeScene({ 6, 6, 6 }, 0.3);
  const std::vector<unsigned char> empty(scene.values.size(), 0);
  auto                             settings = MakeSettings(scene, 10, 0.1);
  EXPECT_THROW(ParticleRun(scene, settings, empty), InputError);
  settings.placement = ParticlePlacement::InitialHeat;
  EXPECT_THROW(ParticleRun(scene, settings, empty), InputError);
  const Volume constant({ 6, 6, 6 }, 1.0F);
  settings.intensityWindow.reset();
  EXPECT_THROW(ParticleRun(constant, settings), InputError);
}
