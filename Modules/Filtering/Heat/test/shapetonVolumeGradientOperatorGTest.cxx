#include "shapetonDiffusionTestVolumes.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

using namespace shapeton;
using namespace shapeton::test;

TEST(VolumeGradientOperator, EdgeWeightFollowsEquation25)
{
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.0, 7.0), 1.0);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.1, 7.0), 1.0 - 0.7);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.5, 7.0), 0.0);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.5, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.1, 7.0, 0.01), 1.0 - 0.7);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.1, 10.0, 0.01), 0.01);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::EdgeWeight(0.5, 20.0, 0.01), 0.01 / 100.0);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::HalfGradient(0.2, 0.8, 2.0), 0.3);
  EXPECT_DOUBLE_EQ(VolumeGradientOperator::HalfGradient(0.8, 0.2, 2.0), 0.3);
}

TEST(VolumeGradientOperator, RoundingOfAnInsulatingEdgeIsNoLeak)
{
  // 1 - 10 * 0.1 is not 0 in floating point for all of these pairs.
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_EQ(
      VolumeGradientOperator::EdgeWeight(VolumeGradientOperator::HalfGradient(0.1 * i, 0.1 * (i + 1), 1.0), 10.0), 0.0);
  }
}

TEST(VolumeGradientOperator, ConductancesOfAnAnisotropicVolume)
{
  Volume volume({ 4, 3, 3 });
  volume.Fill([](double x, double, double z) { return 0.2 * x + 0.1 * z; });
  volume.spacing = { { 0.5, 1.0, 2.0 } };
  const double range = volume.Window()[1] - volume.Window()[0];

  const VolumeGradientOperator physical(volume, OptionsWith(2.0));
  const std::size_t            i = physical.GetGrid().GetRow(1, 1) + 1;
  EXPECT_NEAR(physical.GetConductances(0)[i], 1.0 - 2.0 * 0.2 / range, 1e-6);
  EXPECT_NEAR(physical.GetConductances(1)[i], 0.25, 1e-6);
  EXPECT_NEAR(physical.GetConductances(2)[i], (1.0 - 2.0 * 0.1 / range / 4.0) / 16.0, 1e-6);
  EXPECT_NEAR(physical.GetEigenvalueBound(), 4.0 * (1.0 + 0.25 + 0.0625), 1e-12);

  const VolumeGradientOperator published(volume, OptionsWith(2.0), VolumeGradientOperator::Conductance::Published);
  EXPECT_NEAR(published.GetConductances(2)[i], 1.0 - 2.0 * 0.1 / range / 4.0, 1e-6);
  EXPECT_NEAR(published.GetEigenvalueBound(), 12.0, 1e-12);

  const VolumeGradientOperator sum(volume, OptionsWith(2.0), VolumeGradientOperator::Conductance::Sum);
  EXPECT_NEAR(sum.GetConductances(0)[i], 1.0 - 2.0 * 0.2 / range, 1e-6);
  EXPECT_NEAR(sum.GetConductances(1)[i], 0.25, 1e-6);
  EXPECT_NEAR(sum.GetConductances(2)[i], std::max(0.0, 0.0625 - 2.0 * 0.1 / range / 4.0), 1e-6);
}

TEST(VolumeGradientOperator, AConstantVolumeHasNoInitialHeat)
{
  const Volume                 volume({ 5, 6, 7 }, 3.5F);
  const VolumeGradientOperator volumeGradient(volume);
  PaddedField                  heat(volumeGradient.GetGrid());
  volumeGradient.ComputeInitialHeat(heat);
  for (const float h : Values(volumeGradient.GetGrid(), heat))
  {
    EXPECT_EQ(h, 0.0F);
  }
}

TEST(VolumeGradientOperator, InitialHeatOfACubeCountsItsCutFaces)
{
  Volume volume({ 12, 12, 12 });
  volume.Fill([](std::size_t x, std::size_t y, std::size_t z) {
    return x >= 3 && x < 9 && y >= 3 && y < 9 && z >= 3 && z < 9 ? 1.0 : 0.0;
  });
  const VolumeGradientOperator volumeGradient(volume);
  PaddedField                  heat(volumeGradient.GetGrid());
  volumeGradient.ComputeInitialHeat(heat);
  const auto at = [&](std::size_t x, std::size_t y, std::size_t z) {
    return heat.GetData()[volumeGradient.GetGrid().GetRow(y, z) + x];
  };
  EXPECT_NEAR(at(3, 3, 3), 3.0 / 6.0, 1e-6); // corner
  EXPECT_NEAR(at(3, 3, 5), 2.0 / 6.0, 1e-6); // edge
  EXPECT_NEAR(at(5, 5, 8), 1.0 / 6.0, 1e-6); // face
  EXPECT_NEAR(at(5, 5, 5), 0.0, 1e-6);       // inside
  EXPECT_NEAR(at(2, 5, 5), 1.0 / 6.0, 1e-6); // outside, at a face
}

TEST(VolumeGradientOperator, AWindowClampsWhatLiesBeyond)
{
  Volume volume({ 4, 4, 4 });
  volume.Fill([](double x, double, double) { return x < 2 ? -1000.0 : 3000.0; });
  auto options = OptionsWith(0.5);
  options.intensityWindow = { { -100.0, 100.0 } };
  const VolumeGradientOperator volumeGradient(volume, options);
  EXPECT_NEAR(volumeGradient.GetConductances(0)[volumeGradient.GetGrid().GetRow(1, 1) + 1], 0.5, 1e-6);
}

TEST(EdgeVolume, APartHasTheEdgesOfTheWholeVolume)
{
  const Volume volume = MakeScene({ 14, 12, 16 }, 0.3, { { 1.0, 1.2, 1.5 } });
  auto         options = OptionsWith(3.0);
  options.smoothing = 0.9;
  const VolumeGradientOperator whole(volume, options);
  const EdgeVolume             edges(volume, options);
  constexpr std::size_t        first = 5;
  const VolumeGradientOperator part(VolumeView(edges.volume.values + first * 14 * 12, { 14, 12, 6 }, volume.spacing),
                                    edges.options);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    for (std::size_t z = 0; z < 5; ++z) // the last slice of the part has its border above
    {
      const float * const expected = whole.GetConductances(axis) + whole.GetGrid().GetRow(7, z + first);
      EXPECT_TRUE(std::equal(expected, expected + 14, part.GetConductances(axis) + part.GetGrid().GetRow(7, z)));
    }
  }
  const VolumeGradientOperator rough(volume, OptionsWith(3.0));
  const std::size_t            voxel = whole.GetGrid().GetRow(7, 7) + 7;
  EXPECT_NE(whole.GetConductances(0)[voxel], rough.GetConductances(0)[voxel]);
}

TEST(VolumeGradientOperator, RefusesBadParametersAndBadValues)
{
  Volume     volume({ 4, 4, 4 }, 1.0F);
  const auto make = [&](const VolumeGradientOptions & options, double leastWeight = 0.0) {
    return VolumeGradientOperator(volume, options, VolumeGradientOperator::Conductance::Physical, leastWeight);
  };
  EXPECT_THROW(make(OptionsWith(-1.0)), ParameterError);
  EXPECT_THROW(make({}, 1.5), ParameterError);
  VolumeGradientOptions options;
  options.intensityWindow = { { 2.0, 1.0 } };
  EXPECT_THROW(make(options), ParameterError);
  volume.spacing[1] = 0.0;
  EXPECT_THROW(make({}), InputError);
  volume.spacing[1] = 1.0;
  EXPECT_THROW(VolumeGradientOperator(Volume({ 4, 0, 4 })), InputError);
  volume.values[17] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(make({}), InputError);
  volume.values[17] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(make({}), InputError);
}
