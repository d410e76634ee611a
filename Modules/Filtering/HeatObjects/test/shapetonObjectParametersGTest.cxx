#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatObjects.h"
#include "shapetonObjectParameters.h"
#include "shapetonTestImages.h"
#include "shapetonVoxelGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace shapeton;

namespace
{
constexpr int phantomSide = 64;

struct Phantom
{
  itk::Image<float, 3>::Pointer image =
    basetest::NewImage<itk::Image<float, 3>>(itk::Size<3>::Filled(phantomSide), { { 1.0, 1.0, 1.3 } });
  itk::Image<unsigned char, 3>::Pointer labels = NewImageOn<itk::Image<unsigned char, 3>>(image, true);
};

/** Two balls joined by a thin rod, a box, and a cylinder (intensities 600 to 1000) in noise, in anisotropic voxels. */
Phantom
MakePhantom()
{
  const Phantom                   phantom;
  const VoxelGrid                 grid(phantomSide, phantomSide, phantomSide);
  std::mt19937                    random(7);
  std::normal_distribution<float> noise(0.0F, 60.0F);
  const auto                      isInBall = [](const auto & v, int x) {
    return (v[0] - x) * (v[0] - x) + (v[1] - 16) * (v[1] - 16) + (v[2] - 16) * (v[2] - 16) <= 64;
  };
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    const auto v = grid.Voxel(voxel);
    const bool isInBox = v[0] >= 8 && v[0] < 28 && v[1] >= 36 && v[1] < 48 && v[2] >= 20 && v[2] < 40;
    const bool isInRod = v[0] >= 16 && v[0] < 42 && v[1] >= 16 && v[1] < 18 && v[2] >= 16 && v[2] < 18;
    const int  fromAxis = (v[0] - 46) * (v[0] - 46) + (v[1] - 46) * (v[1] - 46);
    const int  label = isInBall(v, 16)                             ? 1
                       : isInBall(v, 42)                           ? 2
                       : isInBox                                   ? 3
                       : fromAxis <= 49 && v[2] >= 10 && v[2] < 50 ? 4
                                                                   : 0;
    phantom.labels->GetBufferPointer()[voxel] = static_cast<unsigned char>(label);
    const float intensity = label > 0 ? 500.0F + 125.0F * static_cast<float>(label) : isInRod ? 600.0F : 0.0F;
    phantom.image->GetBufferPointer()[voxel] = intensity + noise(random);
  }
  return phantom;
}

double
Dice(const itk::Image<unsigned char, 3> * mask, const itk::Image<unsigned char, 3> * labels, int label)
{
  double both = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < labels->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    const bool isIn = mask->GetBufferPointer()[i] != 0;
    const bool isLabel = labels->GetBufferPointer()[i] == label;
    both += isIn && isLabel ? 1.0 : 0.0;
    sum += (isIn ? 1.0 : 0.0) + (isLabel ? 1.0 : 0.0);
  }
  return 2.0 * both / sum;
}
} // namespace

TEST(ObjectParameters, EachShapeOfAPhantomBecomesAnObject)
{
  const Phantom phantom = MakePhantom();
  const auto    filter = CumulativeHeatDiffusionImageFilter<itk::Image<float, 3>>::New();
  filter->SetInput(phantom.image);
  const auto choice = ChooseObjectParameters(VolumeView(phantom.image.GetPointer()));
  filter->UseParameters(choice);
  EXPECT_GT(choice.intensityWindow[0], 150.0); // objects 625 to 1000, background 0
  EXPECT_LT(choice.intensityWindow[1], 625.0);
  EXPECT_FALSE(choice.windowReason.empty());
  filter->Update();
  const std::vector<const itk::Image<float, 3> *> heats{ filter->GetOutput() };
  const auto                                      list = FindHeatObjects(heats);
  ASSERT_EQ(list.objects.size(), 4U);
  for (int label = 1; label <= 4; ++label)
  {
    double best = 0.0;
    for (int object = 1; object <= 4; ++object)
    {
      best = std::max(best, Dice(MaskOfObject(list, object), phantom.labels, label));
    }
    EXPECT_GT(best, 0.9) << label;
  }
}

TEST(ObjectParameters, GivenValuesAreKept)
{
  const Phantom       phantom = MakePhantom();
  GivenHeatParameters given;
  given.intensityWindow = { { 400.0, 500.0 } };
  given.timeSteps = 50;
  const auto choice = ChooseObjectParameters(VolumeView(phantom.image.GetPointer()), {}, given);
  EXPECT_EQ(choice.intensityWindow, *given.intensityWindow);
  EXPECT_EQ(choice.timeSteps, 50U);
  EXPECT_TRUE(choice.windowReason.empty());
  EXPECT_TRUE(choice.timeReason.empty());
  EXPECT_FALSE(choice.pReason.empty());
}

TEST(ObjectParameters, AConstantVolumeHasNoObjects)
{
  const std::vector<float> values(20 * 20 * 20, 5.0F);
  const auto               choice = ChooseObjectParameters(VolumeView(values.data(), { 20, 20, 20 }));
  EXPECT_NE(choice.windowReason.find("constant"), std::string::npos);
  EXPECT_LT(choice.intensityWindow[0], choice.intensityWindow[1]);
}

TEST(ObjectParameters, ThereIsAWindowForEachScaleOfIntensity)
{
  // A body of 300 with two bones of 1000: one threshold shows the body, another shows the bones.
  constexpr int                   side = 48;
  const VoxelGrid                 grid(side, side, side);
  std::vector<float>              values(grid.NumberOfVoxels(), 0.0F);
  std::mt19937                    random(3);
  std::normal_distribution<float> noise(0.0F, 15.0F);
  for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
  {
    const auto v = grid.Voxel(voxel);
    const auto isIn = [&](int x, int halfX, int half) {
      return std::abs(v[0] - x) < halfX && std::abs(v[1] - 24) < half && std::abs(v[2] - 24) < half;
    };
    const bool isBone = isIn(17, 5, 8) || isIn(31, 5, 8);
    values[voxel] = (isBone ? 1000.0F : isIn(24, 14, 13) ? 300.0F : 0.0F) + noise(random);
  }
  const VolumeView volume(values.data(), { side, side, side });
  const auto       windows = ChooseObjectWindows(volume);
  const auto       isThresholdIn = [&](double lower, double upper) {
    return std::any_of(windows.begin(), windows.end(), [&](const HeatParameterChoice & choice) {
      return choice.intensityWindow[0] > lower && choice.intensityWindow[1] < upper;
    });
  };
  ASSERT_GE(windows.size(), 2U);
  EXPECT_TRUE(isThresholdIn(0.0, 300.0));
  EXPECT_TRUE(isThresholdIn(300.0, 1000.0));
  const auto first = ChooseObjectParameters(volume);
  EXPECT_EQ(first.intensityWindow, windows.front().intensityWindow);
  GivenHeatParameters given;
  given.intensityWindow = { { 400.0, 420.0 } };
  EXPECT_EQ(ChooseObjectWindows(volume, {}, given).size(), 1U);
}
