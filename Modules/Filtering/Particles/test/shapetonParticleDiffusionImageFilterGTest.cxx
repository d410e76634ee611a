#include "shapetonParticleDiffusionImageFilter.h"
#include "shapetonParticleParameters.h"
#include "shapetonParticleTestRuns.h"
#include "shapetonVisitDensity.h"
#include "shapetonDiffusionTestImages.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

using namespace shapeton;
using test::MakeImage;
using test::VoxelsOf;

namespace
{
/** Integers from 0 to 200, which every pixel type can represent. */
test::Volume
MakeWholeNumbers()
{
  test::Volume volume = test::MakeScene({ 18, 16, 14 }, 0.1);
  for (float & value : volume.values)
  {
    value = std::round(100.0F * std::clamp(value + 0.5F, 0.0F, 2.0F));
  }
  return volume;
}

template <typename TImage>
typename ParticleDiffusionImageFilter<TImage>::Pointer
MakeFilter(TImage * image, std::uint64_t timeSteps)
{
  auto filter = ParticleDiffusionImageFilter<TImage>::New();
  filter->SetInput(image);
  filter->SetShapetons(3000);
  filter->SetDistance(0.1);
  filter->SetTimeSteps(timeSteps);
  return filter;
}

template <typename TPixel>
std::vector<std::uint32_t>
VisitsWithPixels(const test::Volume & volume)
{
  const auto image = MakeImage<TPixel>(volume);
  const auto filter = MakeFilter(image.GetPointer(), 20);
  filter->Update();
  return VoxelsOf(filter->GetOutput());
}

itk::Image<unsigned char, 3>::Pointer
MakeMask(const test::Volume & volume)
{
  const auto mask = MakeImage<unsigned char>(volume, 0.0);
  std::fill_n(mask->GetBufferPointer(), volume.values.size() / 2, static_cast<unsigned char>(1));
  return mask;
}

/** The message of an exception. */
template <typename TFilter>
std::string
Refusal(TFilter * filter)
{
  return basetest::ErrorOf<itk::ExceptionObject>([&] { filter->Update(); });
}
} // namespace

TEST(ParticleDiffusionImageFilter, EqualsTheDiffusionOnArrays)
{
  const test::Volume volume = test::MakeScene({ 18, 16, 14 }, 0.1, { { 0.7, 0.8, 2.5 } });
  const auto         image = MakeImage<float>(volume);
  image->SetSpacing(volume.spacing.data());
  const auto mask = MakeMask(volume);
  mask->SetSpacing(image->GetSpacing());
  const auto filter = MakeFilter(image.GetPointer(), 30);
  filter->SetMaskImage(mask);
  filter->SetP(5.0);
  filter->SetIntensityWindow(0.2, 0.9);
  filter->SetDirectionSampling(DirectionSampling::SectorArea);
  filter->SetPathRule(PathRule::Traversal);
  filter->SetPlacement(ParticlePlacement::InitialHeat);
  filter->SetSeed(77);
  filter->Update();

  auto settings = test::MakeSettings(volume, 3000, 0.1, 5.0);
  settings.intensityWindow = { { 0.2, 0.9 } };
  settings.directionSampling = DirectionSampling::SectorArea;
  settings.pathRule = PathRule::Traversal;
  settings.placement = ParticlePlacement::InitialHeat;
  settings.seed = 77;
  const unsigned char * const inside = mask->GetBufferPointer();
  test::ParticleRun           run(volume, settings, { inside, inside + volume.values.size() });
  run.diffusion.Run(30);
  EXPECT_EQ(VoxelsOf(filter->GetOutput()), run.visits);
  EXPECT_EQ(test::Tied(filter->GetMeasures()), test::Tied(run.diffusion.GetMeasures()));
}

TEST(ParticleDiffusionImageFilter, TheDefaultWindowIsTheRangeOfTheVolume)
{
  const test::Volume volume = test::MakeScene({ 18, 16, 14 }, 0.1);
  const auto         filter = MakeFilter(MakeImage<float>(volume).GetPointer(), 10);
  filter->Update();
  test::ParticleRun run(volume, test::MakeSettings(volume, 3000, 0.1));
  run.diffusion.Run(10);
  EXPECT_EQ(VoxelsOf(filter->GetOutput()), run.visits);
  EXPECT_EQ(filter->GetWindowLower(), *std::min_element(volume.values.begin(), volume.values.end()));
  EXPECT_EQ(filter->GetWindowUpper(), *std::max_element(volume.values.begin(), volume.values.end()));
}

TEST(ParticleDiffusionImageFilter, AllPixelTypesGiveTheSameVisits)
{
  const test::Volume volume = MakeWholeNumbers();
  const auto         visits = VisitsWithPixels<float>(volume);
  EXPECT_EQ(VisitsWithPixels<short>(volume), visits);
  EXPECT_EQ(VisitsWithPixels<unsigned char>(volume), visits);
  EXPECT_EQ(VisitsWithPixels<double>(volume), visits);
}

TEST(ParticleDiffusionImageFilter, KeepsAnObliqueAnisotropicGeometry)
{
  const auto image = MakeImage<float>(test::MakeScene({ 9, 8, 7 }, 0.1));
  image->SetDirection(basetest::Rotation(2, 0.4));
  image->SetSpacing(std::array<double, 3>{ { 0.7, 0.8, 2.5 } }.data());
  image->SetOrigin(std::array<double, 3>{ { -12.5, 30.0, 101.0 } }.data());
  image->SetRegions(itk::ImageRegion<3>({ { -4, 7, 100 } }, { { 9, 8, 7 } }));
  const auto filter = MakeFilter(image.GetPointer(), 5);
  filter->GetOutput()->UpdateOutputInformation();
  filter->GetOutput()->SetRequestedRegion(itk::ImageRegion<3>({ { -4, 7, 100 } }, { { 2, 2, 2 } }));
  filter->GetOutput()->Update();
  const auto * const output = filter->GetOutput();
  EXPECT_EQ(output->GetDirection(), image->GetDirection());
  EXPECT_EQ(output->GetSpacing(), image->GetSpacing());
  EXPECT_EQ(output->GetOrigin(), image->GetOrigin());
  EXPECT_EQ(output->GetBufferedRegion(), image->GetBufferedRegion());
  const auto visits = VoxelsOf(output);
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0U), 3000U * 5U);
}

TEST(ParticleDiffusionImageFilter, TheVisitsGrowFromEventToEvent)
{
  // This also holds for steps with more shapetons than are moved between two events.
  const auto image = MakeImage<float>(test::MakeScene({ 20, 20, 20 }, 0.1));
  for (const std::uint32_t shapetons : { 5000, 70000 })
  {
    const auto filter = MakeFilter(image.GetPointer(), 60);
    filter->SetShapetons(shapetons);
    filter->SetPathRule(PathRule::Traversal);
    std::vector<std::uint32_t> last(8000, 0);
    std::uint64_t              lastStep = 0;
    std::size_t                events = 0;
    filter->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
      const auto visits = VoxelsOf(filter->GetOutput());
      const auto step = filter->GetMeasures().step;
      ++events;
      EXPECT_GE(step, lastStep);
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), std::uint64_t{ 0 }), step * shapetons);
      EXPECT_TRUE(std::equal(visits.begin(), visits.end(), last.begin(), std::greater_equal<>()));
      last = visits;
      lastStep = step;
    });
    filter->Update();
    EXPECT_GE(events, 3U);
    EXPECT_EQ(lastStep, 60U);
    EXPECT_EQ(VoxelsOf(filter->GetOutput()), last);
  }
}

TEST(ParticleDiffusionImageFilter, AnAbortedRunCanBeRunAgain)
{
  const auto image = MakeImage<float>(test::MakeScene({ 20, 20, 20 }, 0.1));
  const auto filter = MakeFilter(image.GetPointer(), 3000);
  const auto undisturbed = MakeFilter(image.GetPointer(), 3000);
  bool       abort = true;
  const auto tag = filter->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
    if (abort)
    {
      filter->AbortGenerateDataOn();
    }
  });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
  EXPECT_LT(filter->GetMeasures().step, 3000U);
  abort = false;
  filter->Update();
  undisturbed->Update();
  EXPECT_EQ(VoxelsOf(filter->GetOutput()), VoxelsOf(undisturbed->GetOutput()));
  filter->RemoveObserver(tag);
}

TEST(ParticleDiffusionImageFilter, AStepOfManyShapetonsCanBeAborted)
{
  const auto filter = MakeFilter(MakeImage<float>(test::MakeScene({ 20, 20, 20 }, 0.1)).GetPointer(), 10);
  filter->SetShapetons(300000);
  filter->SetPathRule(PathRule::Traversal);
  bool stepped = false;
  filter->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) { stepped = true; });
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) {
    if (stepped)
    {
      filter->AbortGenerateDataOn(); // in the middle of the second step
    }
  });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
  EXPECT_EQ(filter->GetMeasures().step, 1U);
}

TEST(ParticleDiffusionImageFilter, AStateSavedDuringAnEventGoesOn)
{
  const auto image = MakeImage<float>(test::MakeScene({ 20, 20, 20 }, 0.1));
  for (const std::uint32_t shapetons : { 3000, 70000 })
  {
    const auto filter = MakeFilter(image.GetPointer(), 60);
    filter->SetShapetons(shapetons);
    filter->SetPathRule(PathRule::Traversal);
    std::vector<ParticleState> states;
    filter->AddObserver(itk::IterationEvent(), [&](const itk::EventObject &) {
      if (states.size() < 2)
      {
        states.push_back(filter->GetState());
      }
    });
    filter->Update();
    ASSERT_EQ(states.size(), 2U);
    const auto resumed = MakeFilter(image.GetPointer(), 60);
    resumed->SetShapetons(shapetons);
    resumed->SetPathRule(PathRule::Traversal);
    resumed->WantStateOn();
    for (const ParticleState & state : states)
    {
      EXPECT_GT(state.step, 0U);
      EXPECT_LT(state.step, 60U);
      resumed->SetInitialState(state);
      resumed->Update();
      EXPECT_EQ(VoxelsOf(resumed->GetOutput()), VoxelsOf(filter->GetOutput()));
      EXPECT_EQ(test::Tied(resumed->GetMeasures()), test::Tied(filter->GetMeasures()));
      EXPECT_EQ(resumed->GetState().step, 60U);
      EXPECT_EQ(resumed->GetState().visits, VoxelsOf(filter->GetOutput()));
    }
  }
}

TEST(ParticleDiffusionImageFilter, TheStateIsKeptOnRequest)
{
  const auto filter = MakeFilter(MakeImage<float>(test::MakeScene({ 9, 8, 7 }, 0.1)).GetPointer(), 5);
  filter->Update();
  EXPECT_TRUE(filter->GetState().visits.empty());
  filter->WantStateOn();
  filter->Update();
  EXPECT_EQ(filter->GetState().step, 5U);
}

TEST(ParticleDiffusionImageFilter, RunsUntilTheDensityIsSteady)
{
  const auto image = MakeImage<float>(test::MakeScene({ 8, 8, 8 }, 0.1));
  const auto filter = MakeFilter(image.GetPointer(), 100000);
  filter->UntilSteadyOn();
  filter->SetEpsilon(0.02);
  filter->SetHistogramSteps({ 1, 10, 40, 90000 });
  filter->Update();
  EXPECT_TRUE(filter->GetMeasures().steady);
  EXPECT_GE(filter->GetMeasures().step, 50U);
  EXPECT_LT(filter->GetMeasures().step, 90000U);
  EXPECT_LE(filter->GetMeasures().change, 0.02);
  EXPECT_EQ(filter->GetHistogram().GetTimeSteps(), (std::vector<std::uint64_t>{ 1, 10, 40 }));
}

TEST(ParticleDiffusionImageFilter, TheRowsOfTheHistogramCountAllVoxels)
{
  const test::Volume volume = test::MakeScene({ 15, 14, 13 }, 0.1);
  const auto         image = MakeImage<float>(volume);
  const auto         filter = MakeFilter(image.GetPointer(), 40);
  filter->SetHistogramSteps({ 1, 7, 40 });
  filter->Update();
  const HeatHistogram & histogram = filter->GetHistogram();
  ASSERT_EQ(histogram.GetTimeSteps(), (std::vector<std::uint64_t>{ 1, 7, 40 }));
  HeatHistogram last({ 40 });
  AddVisitsToRow(filter->GetOutput(), 0, last);
  for (std::size_t row = 0; row < 3; ++row)
  {
    const std::uint32_t * const counts = histogram.GetRow(row);
    EXPECT_EQ(std::accumulate(counts, counts + HeatHistogram::NumberOfBins, 0U), volume.values.size());
  }
  EXPECT_TRUE(std::equal(last.GetRow(0), last.GetRow(0) + HeatHistogram::NumberOfBins, histogram.GetRow(2)));
}

TEST(ParticleDiffusionImageFilter, AMaskOfAnotherGridIsRefused)
{
  const test::Volume volume = test::MakeScene({ 9, 8, 7 }, 0.1);
  const auto         filter = MakeFilter(MakeImage<float>(volume).GetPointer(), 5);
  const auto         mask = MakeMask(volume);
  filter->SetMaskImage(mask);
  EXPECT_NO_THROW(filter->Update());
  mask->SetOrigin(std::array<double, 3>{ { 0.0, 0.5, 0.0 } }.data());
  EXPECT_NE(Refusal(filter.GetPointer()), "");
  filter->SetMaskImage(basetest::WithoutPixels<itk::Image<unsigned char, 3>>(filter->GetInput()));
  EXPECT_NE(Refusal(filter.GetPointer()).find("the mask has no pixels"), std::string::npos);
  const auto elsewhere = MakeMask(volume); // with other indices
  elsewhere->SetRegions(itk::ImageRegion<3>({ { 2, 0, 0 } }, { { 9, 8, 7 } }));
  filter->SetMaskImage(elsewhere);
  EXPECT_NE(Refusal(filter.GetPointer()).find("another grid than the volume"), std::string::npos);
  filter->SetMaskImage(MakeMask(test::Volume({ 9, 8, 6 })));
  EXPECT_NE(Refusal(filter.GetPointer()).find("another grid than the volume"), std::string::npos);
}

TEST(ParticleDiffusionImageFilter, SettingsOutOfRangeAreNamed)
{
  const auto image = MakeImage<float>(test::MakeScene({ 8, 8, 8 }, 0.1));
  const auto expectRefused = [&](const std::string & part, const auto & spoil) {
    const auto filter = MakeFilter(image.GetPointer(), 10);
    spoil(filter);
    const std::string text = Refusal(filter.GetPointer());
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  expectRefused("\"timeSteps\": 0 is less than the minimum 1", [](auto & filter) { filter->SetTimeSteps(0); });
  expectRefused("shapeton", [](auto & filter) { filter->SetShapetons(0); });
  expectRefused("distance", [](auto & filter) { filter->SetDistance(0.0); });
  expectRefused("distance", [](auto & filter) { filter->SetDistance(1.5); });
  expectRefused("\"p\": -1 is less than the minimum 0", [](auto & filter) { filter->SetP(-1.0); });
  expectRefused("intensityWindow", [](auto & filter) { filter->SetIntensityWindow(1.0, 1.0); });
  expectRefused("\"epsilon\": -0.1 is less than the minimum 0", [](auto & filter) { filter->SetEpsilon(-0.1); });
  expectRefused("histogram steps", [](auto & filter) { filter->SetHistogramSteps({ 11 }); });
  expectRefused("histogram steps", [](auto & filter) { filter->SetHistogramSteps({ 0 }); });
  expectRefused("histogram steps", [](auto & filter) { filter->SetHistogramSteps({ 3, 3 }); });
  expectRefused("initial state", [](auto & filter) {
    ParticleState state;
    state.step = 11;
    filter->SetInitialState(state);
  });
  expectRefused("saved state", [](auto & filter) { filter->SetInitialState(ParticleState()); });
  const auto empty = MakeImage<unsigned char>(test::Volume({ 8, 8, 8 }));
  expectRefused("mask is empty", [&](auto & filter) { filter->SetMaskImage(empty); });
  image->GetBufferPointer()[100] = std::numeric_limits<float>::quiet_NaN();
  expectRefused("not finite", [](auto &) {});
}

TEST(ParticleDiffusionImageFilter, PrintsItsSettings)
{
  const auto filter = MakeFilter(MakeImage<float>(test::MakeScene({ 8, 8, 8 }, 0.1)).GetPointer(), 10);
  filter->SetPathRule(PathRule::Traversal);
  filter->SetSeed(4711);
  std::ostringstream text;
  filter->Print(text);
  for (const char * const line : { "Shapetons: 3000", "PathRule: traversal", "Seed: 4711", "TimeSteps: 10" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}

TEST(ParticleParameters, EnoughShapetonsForTheVoxelsOrForTheFeatures)
{
  // 20 visits for each of 200^3 voxels in 1000 steps require 160000 shapetons; 3 per 10 mm cube are 24000.
  const auto forVoxels = ChooseShapetons({ 200, 200, 200 }, { 1.0, 1.0, 1.0 }, 10.0, 1000);
  EXPECT_EQ(forVoxels.shapetons, 160000U);
  EXPECT_DOUBLE_EQ(forVoxels.distance, 5.0 / 200.0);
  EXPECT_NE(forVoxels.shapetonsReason.find("visits"), std::string::npos);
  EXPECT_NE(forVoxels.distanceReason.find("feature"), std::string::npos);
  // Smaller features and more steps: 3 x 200^3 / 5^3 against 16000.
  const auto forFeatures = ChooseShapetons({ 200, 200, 200 }, { 1.0, 1.0, 1.0 }, 5.0, 10000);
  EXPECT_EQ(forFeatures.shapetons, 192000U);
  EXPECT_NE(forFeatures.shapetonsReason.find("volume of a feature"), std::string::npos);
  // The longest side in mm is used.
  EXPECT_DOUBLE_EQ(ChooseShapetons({ 100, 50, 40 }, { 0.5, 0.5, 2.5 }, 8.0, 1000).distance, 4.0 / 100.0);
}

TEST(ParticleParameters, TheNumberOfShapetonsHasBounds)
{
  EXPECT_EQ(ChooseShapetons({ 20, 20, 20 }, { 1.0, 1.0, 1.0 }, 20.0, 100000).shapetons, 1000U);
  EXPECT_EQ(ChooseShapetons({ 600, 600, 600 }, { 1.0, 1.0, 1.0 }, 1.0, 100).shapetons, 10000000U);
}

TEST(ParticleParameters, AFeatureThatCannotBeSeenIsRefused)
{
  const auto choose = [](double feature) { ChooseShapetons({ 100, 50, 40 }, { 0.5, 0.5, 2.5 }, feature, 1000); };
  EXPECT_NO_THROW(choose(0.5));
  EXPECT_NO_THROW(choose(100.0));
  for (const double feature : { 0.49, 100.1, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(choose(feature), InputError);
  }
}

TEST(VisitDensity, IsRelativeToTheGreatestNumberOfVisits)
{
  auto       image = basetest::NewImage<itk::Image<std::uint32_t, 3>>({ { 5, 4, 3 } }, { { 0.7, 0.8, 2.5 } });
  const auto nothing = NormalizeVisits(image);
  EXPECT_TRUE(std::all_of(
    nothing->GetBufferPointer(), nothing->GetBufferPointer() + 60, [](float density) { return density == 0.0F; }));
  for (std::uint32_t i = 0; i < 60; ++i)
  {
    image->GetBufferPointer()[i] = i * 71000001U; // up to 4.19e9, beyond 31 bits
  }
  const auto density = NormalizeVisits(image);
  EXPECT_EQ(density->GetBufferPointer()[59], 1.0F);
  EXPECT_EQ(density->GetSpacing(), image->GetSpacing());
  for (std::uint32_t i = 0; i < 60; ++i)
  {
    EXPECT_NEAR(density->GetBufferPointer()[i], i / 59.0, 2e-7);
  }
}
