#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticlePreset.h"

#include "itkImageRegionIteratorWithIndex.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

using namespace shapeton;

namespace
{
using ImageType = itk::Image<float, 3>;
using FilterType = ParticleDiffusionImageFilter<ImageType>;

/** 1 in a cube of 4 voxels, 2 in one of 12 voxels, otherwise 0. */
int
ObjectAt(const ImageType::IndexType & index)
{
  const auto isInside = [&index](long first, long end) {
    return std::all_of(index.begin(), index.end(), [=](long i) { return i >= first && i < end; });
  };
  return isInside(3, 7) ? 1 : isInside(11, 23) ? 2 : 0;
}

ImageType::Pointer
TwoCubes()
{
  auto image = ImageType::New();
  image->SetRegions(ImageType::SizeType::Filled(26));
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    it.Set(ObjectAt(it.GetIndex()) ? 1000.0F : 0.0F);
  }
  return image;
}

/** Mean over the small cube divided by the mean over the large one. */
template <typename TImage>
double
Contrast(const TImage * image)
{
  std::map<int, double> sums, voxels;
  for (itk::ImageRegionConstIteratorWithIndex<TImage> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    const int object = ObjectAt(it.GetIndex());
    sums[object] += it.Get();
    voxels[object] += 1.0;
  }
  return (sums[1] / voxels[1]) / (sums[2] / voxels[2]);
}

FilterType::Pointer
FilterOf(ShapetonPreset preset)
{
  const auto            image = TwoCubes();
  auto                  filter = FilterType::New();
  ShapetonPresetOptions options;
  options.preset = preset;
  filter->SetInput(image);
  filter->SetOptions(ChooseShapetonParameters(VolumeView(image.GetPointer()), options).options);
  return filter;
}

double
ContrastOf(ShapetonPreset preset)
{
  const auto filter = FilterOf(preset);
  filter->Update();
  return Contrast(filter->GetOutput());
}

double
ContrastOfHeat()
{
  auto filter = CumulativeHeatDiffusionImageFilter<ImageType>::New();
  filter->SetInput(TwoCubes());
  filter->SetTimeSteps(1);
  filter->Update();
  return Contrast(filter->GetOutput());
}
} // namespace

// Heat cannot leave a closed object, so its mean visits are those of its initial heat.
TEST(ParticlePreset, ObjectsSeparatesClosedObjectsAsHeatDoes)
{
  const double heat = ContrastOfHeat();
  ASSERT_GT(heat, 2.0);
  EXPECT_NEAR(ContrastOf(ShapetonPreset::Objects) / heat, 1.0, 0.1);
  EXPECT_NEAR(ContrastOf(ShapetonPreset::Surface) / heat, 1.0, 0.1);
  EXPECT_LT(std::abs(ContrastOf(ShapetonPreset::Published) - 1.0), 0.3 * (heat - 1.0));
}

TEST(ParticlePreset, PublishedIsAsPrinted)
{
  const auto filter = FilterOf(ShapetonPreset::Published);
  EXPECT_EQ(filter->GetDirectionSampling(), DirectionSampling::SectorArea);
  EXPECT_EQ(filter->GetPathRule(), PathRule::Endpoint);
  EXPECT_EQ(filter->GetPlacement(), ParticlePlacement::Uniform);
  EXPECT_EQ(filter->GetShapetons(), 65000u); // 3.5.1
  EXPECT_EQ(filter->GetTimeSteps(), 2500u);  // 3.3.1
  EXPECT_EQ(filter->GetDistance(), 0.01);
  EXPECT_EQ(filter->GetP(), 7.0); // Table 3.2, foot
  EXPECT_EQ(filter->GetSmoothing(), 0.0);
  EXPECT_FALSE(filter->GetIntensityWindow());
}

TEST(ParticlePreset, ObjectsStepsByTwoVoxelsOfAnySpacing)
{
  const auto options = OptionsOfPreset(ShapetonPreset::Objects, { { 50, 20, 10 } }, { { 0.5, 0.5, 4.0 } });
  EXPECT_DOUBLE_EQ(options.distance, 2.0 * 0.5 / 40.0);
}

TEST(ParticlePreset, NamesOfGivenValuesAreKnown)
{
  const auto image = TwoCubes();
  EXPECT_THROW(ChooseShapetonParameters(VolumeView(image.GetPointer()), {}, { "Shapetons" }), ParameterError);
}

TEST(ParticlePreset, GivenValuesWin)
{
  for (const auto preset : { ShapetonPreset::Objects, ShapetonPreset::Published, ShapetonPreset::Surface })
  {
    ShapetonPresetOptions given;
    given.preset = preset;
    given.p = 3.5;
    given.smoothing = 0.25;
    given.shapetons = 1234;
    given.distance = 0.125;
    given.timeSteps = 77;
    given.intensityWindow = { { 10.0, 900.0 } };
    given.directionSampling = DirectionSampling::SolidAngle;
    given.pathRule = PathRule::Endpoint;
    given.placement = ParticlePlacement::Uniform;
    std::vector<std::string> names;
    ShapetonPresetOptions::VisitOptions(
      given, [&names](const OptionInfo & info, const auto &) { names.emplace_back(info.GetName()); });
    const auto image = TwoCubes();
    const auto options = ChooseShapetonParameters(VolumeView(image.GetPointer()), given, names).options;
    EXPECT_EQ(options.p, 3.5);
    EXPECT_EQ(options.smoothing, 0.25);
    EXPECT_EQ(options.shapetons, 1234u);
    EXPECT_EQ(options.distance, 0.125);
    EXPECT_EQ(options.timeSteps, 77u);
    EXPECT_EQ(options.intensityWindow, given.intensityWindow);
    EXPECT_EQ(options.directionSampling, DirectionSampling::SolidAngle);
    EXPECT_EQ(options.pathRule, PathRule::Endpoint);
    EXPECT_EQ(options.placement, ParticlePlacement::Uniform);
  }
}

TEST(ParticlePreset, AFeatureSizeSetsTheDistanceAndTheNumberThatIsNotGiven)
{
  const auto            image = TwoCubes();
  const VolumeView      volume(image.GetPointer());
  ShapetonPresetOptions options;
  options.preset = ShapetonPreset::Published;
  options.featureSize = 4.0;
  options.shapetons = 1234;
  const auto both = ChooseShapetonParameters(volume, options);
  const auto feature = ChooseShapetons(volume.size, volume.spacing, 4.0, both.options.timeSteps);
  EXPECT_EQ(both.options.distance, feature.distance);
  EXPECT_EQ(both.options.shapetons, feature.shapetons);
  EXPECT_EQ(both.feature.shapetonsReason, feature.shapetonsReason);
  const auto one = ChooseShapetonParameters(volume, options, { "featureSize", "shapetons" });
  EXPECT_EQ(one.options.distance, feature.distance);
  EXPECT_EQ(one.options.shapetons, 1234u);
  EXPECT_TRUE(one.feature.shapetonsReason.empty());
}

TEST(ParticlePreset, SmoothingReleasesShapetonsTrappedByNoise)
{
  auto          noisy = TwoCubes();
  const auto    voxels = noisy->GetBufferedRegion().GetNumberOfPixels();
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < voxels; ++i)
  {
    state = state * 1664525U + 1013904223U; // Numerical Recipes
    noisy->GetBufferPointer()[i] += static_cast<float>(state >> 24U);
  }
  const auto trapped = [&noisy](double smoothing) {
    auto filter = FilterType::New();
    filter->SetInput(noisy);
    filter->SetP(20.0);
    filter->SetSmoothing(smoothing);
    filter->SetTimeSteps(1);
    filter->Update();
    return filter->GetMeasures().trappedShapetons;
  };
  EXPECT_GT(trapped(0.0), 1000u);
  EXPECT_LT(trapped(1.0), trapped(0.0) / 10);
}
