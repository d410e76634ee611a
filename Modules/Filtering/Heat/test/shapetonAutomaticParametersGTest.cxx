#include "shapetonAutomaticParameters.h"
#include "shapetonDiffusionTestVolumes.h"

#include <gtest/gtest.h>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
VolumeGradientOptions
Window(double lower, double upper)
{
  VolumeGradientOptions options;
  options.intensityWindow = { { lower, upper } };
  return options;
}

Volume
TwoBoxes(double contrast, double noise)
{
  Volume volume({ 40, 40, 40 });
  volume.Fill([&](std::size_t x, std::size_t y, std::size_t z) {
    const bool inside = x >= 8 && x < 30 && y >= 8 && y < 30 && z >= 8 && z < 30;
    return (inside ? contrast : 0.0) + noise * Noise(x, y, z);
  });
  return volume;
}
} // namespace

TEST(AutomaticParameters, CleanEdgesInsulateWithRoom)
{
  const Volume volume = TwoBoxes(0.25, 0.0);
  const auto   choice = ChooseP(volume, Window(0.0, 1.0));
  EXPECT_EQ(choice.noise, 0.0);
  EXPECT_NEAR(choice.edgeContrast, 0.25, 1e-4);
  EXPECT_NEAR(choice.p, 8.0, 0.01); // 1/p half of the contrast
  EXPECT_FALSE(choice.reason.empty());
}

TEST(AutomaticParameters, NoiseIsMeasuredAndDoesNotInsulate)
{
  const Volume volume = TwoBoxes(0.6, 0.1);
  const auto   choice = ChooseP(volume, Window(-0.1, 0.9));
  EXPECT_NEAR(choice.noise, 0.1 / std::sqrt(6.0), 0.002); // the difference of two uniform variables of width 0.1
  EXPECT_GT(choice.edgeContrast, 0.4);
  EXPECT_NEAR(choice.p, 1.0 / std::sqrt(4.0 * choice.noise * choice.edgeContrast), 1e-9);
  EXPECT_LT(1.0 / choice.p, 0.5);
}

TEST(AutomaticParameters, AConstantVolumeKeepsTheDefault)
{
  const Volume volume({ 8, 8, 8 }, 3.0F);
  EXPECT_EQ(ChooseP(volume, {}).p, 7.0);
}

TEST(AutomaticParameters, SnapshotStepsAscendFromZeroToTheLast)
{
  const auto linear = MakeSnapshotSteps(1000, 11, SnapshotSpacing::Linear);
  EXPECT_EQ(linear, (std::vector<std::uint64_t>{ 0, 100, 200, 300, 400, 500, 600, 700, 800, 900, 1000 }));
  const auto logarithmic = MakeSnapshotSteps(10000, 6, SnapshotSpacing::Logarithmic);
  EXPECT_EQ(logarithmic, (std::vector<std::uint64_t>{ 0, 6, 40, 251, 1585, 10000 }));
  EXPECT_EQ(MakeSnapshotSteps(3, 512, SnapshotSpacing::Linear), (std::vector<std::uint64_t>{ 0, 1, 2, 3 }));
  EXPECT_EQ(MakeSnapshotSteps(1, 1, SnapshotSpacing::Logarithmic), (std::vector<std::uint64_t>{ 0, 1 }));
}
