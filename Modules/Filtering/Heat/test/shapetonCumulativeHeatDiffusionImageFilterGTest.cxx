#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonAutomaticParameters.h"
#include "shapetonDiffusionTestImages.h"
#include "shapetonMappedImage.h"

#include <gtest/gtest.h>

using namespace shapeton;
using test::MakeImage;
using test::VoxelsOf;

namespace
{
template <typename TImage>
typename CumulativeHeatDiffusionImageFilter<TImage>::Pointer
MakeFilter(TImage * image, std::uint64_t timeSteps)
{
  auto filter = CumulativeHeatDiffusionImageFilter<TImage>::New();
  filter->SetInput(image);
  filter->SetTimeSteps(timeSteps);
  return filter;
}

std::vector<float>
HeatOf(const test::Volume & volume, std::uint64_t timeSteps)
{
  const auto filter = MakeFilter(MakeImage<float>(volume).GetPointer(), timeSteps);
  filter->Update();
  return VoxelsOf(filter->GetOutput());
}

test::Volume
Sphere(std::size_t side, double radius)
{
  test::Volume volume({ side, side, side });
  const double center = (side - 1) / 2.0;
  volume.Fill(
    [&](double x, double y, double z) { return std::hypot(x - center, y - center, z - center) <= radius ? 1.0 : 0.0; });
  return volume;
}
} // namespace

TEST(CumulativeHeatDiffusionImageFilter, ASphereConvergesToThreeQuartersOverItsRadius)
{
  for (const double radius : { 4.0, 8.0, 16.0 })
  {
    auto filter = MakeFilter(MakeImage<float>(Sphere(40, radius)).GetPointer(), 1000000);
    filter->WantComponentsOn();
    filter->Update();
    const float center = filter->GetOutput()->GetPixel({ { 20, 20, 20 } });
    // A voxel sphere has 6 pi r^2 cut faces (its projections) and the volume 4/3 pi r^3, both up to discretization.
    EXPECT_NEAR(center * radius, 0.75, 0.75 / radius * 0.5);
    const auto & components = filter->GetResult().components;
    ASSERT_EQ(components.size(), 2U);
    EXPECT_FALSE(components[0].closed);
    EXPECT_TRUE(components[1].closed);
    EXPECT_NEAR(components[1].convergedHeat, center, 1e-5);
  }
}

TEST(CumulativeHeatDiffusionImageFilter, ACubeConvergesToOneOverItsSide)
{
  for (const std::size_t side : { 5, 10, 20 })
  {
    test::Volume volume({ 26, 26, 26 });
    volume.Fill([&](std::size_t x, std::size_t y, std::size_t z) {
      return std::max({ x, y, z }) < side + 3 && std::min({ x, y, z }) >= 3 ? 1.0 : 0.0;
    });
    const auto heat = HeatOf(volume, 1000000);
    EXPECT_NEAR(volume.At(5, 5, 5), 1.0F, 0.0F);
    EXPECT_NEAR(heat[(5 * 26 + 5) * 26 + 5], 1.0 / side, 1e-5);
  }
}

TEST(CumulativeHeatDiffusionImageFilter, TranslationMovesTheHeatOfAClosedObject)
{
  // The object is insulated, so its heat does not depend on its position, up to rounding.
  const auto shape = [](std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) {
    return x >= 0 && x < 6 && y >= 0 && y < 4 && z >= 0 && z < 8 && !(x > 2 && z > 3) ? 1.0 : 0.0;
  };
  test::Volume a({ 24, 22, 26 });
  test::Volume b({ 24, 22, 26 });
  a.Fill([&](std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) { return shape(x - 4, y - 5, z - 6); });
  b.Fill([&](std::ptrdiff_t x, std::ptrdiff_t y, std::ptrdiff_t z) { return shape(x - 12, y - 9, z - 11); });
  const auto heatA = HeatOf(a, 300);
  const auto heatB = HeatOf(b, 300);
  test::ForVoxels({ 6, 4, 8 }, [&](std::size_t, std::size_t x, std::size_t y, std::size_t z) {
    if (shape(x, y, z) > 0.0)
    {
      const auto inA = heatA[((z + 6) * 22 + y + 5) * 24 + x + 4];
      const auto inB = heatB[((z + 11) * 22 + y + 9) * 24 + x + 12];
      EXPECT_NEAR(inA, inB, 2e-6);
    }
  });
}

TEST(CumulativeHeatDiffusionImageFilter, AxisPermutationPermutesTheHeat)
{
  const test::Volume volume = test::MakeScene({ 17, 13, 21 }, 0.1);
  test::Volume       permuted({ 21, 17, 13 }); // (x, y, z) -> (z, x, y)
  permuted.Fill([&](std::size_t a, std::size_t b, std::size_t c) { return volume.values[(a * 13 + c) * 17 + b]; });
  const auto heat = HeatOf(volume, 500);
  const auto permutedHeat = HeatOf(permuted, 500);
  test::ForVoxels(permuted.size, [&](std::size_t i, std::size_t a, std::size_t b, std::size_t c) {
    EXPECT_NEAR(permutedHeat[i], heat[(a * 13 + c) * 17 + b], 5e-6);
  });
}

TEST(CumulativeHeatDiffusionImageFilter, IntegerPixelsGiveTheHeatOfEqualFloats)
{
  const test::Volume volume = test::MakeScene({ 16, 18, 14 }, 0.1);
  const auto         shorts = MakeImage<short>(volume, 1000.0);
  const auto floats = MapVoxels<float>(shorts.GetPointer(), [](short value) { return static_cast<float>(value); });
  const auto a = MakeFilter(shorts.GetPointer(), 200);
  const auto b = MakeFilter(floats.GetPointer(), 200);
  a->Update();
  b->Update();
  EXPECT_EQ(VoxelsOf(a->GetOutput()), VoxelsOf(b->GetOutput()));
}

TEST(CumulativeHeatDiffusionImageFilter, KeepsAnObliqueAnisotropicGeometry)
{
  const auto image = MakeImage<float>(test::MakeScene({ 9, 8, 7 }, 0.1));
  image->SetDirection(basetest::Rotation(2, 0.4));
  image->SetSpacing(std::array<double, 3>{ { 0.7, 0.8, 2.5 } }.data());
  image->SetOrigin(std::array<double, 3>{ { -12.5, 30.0, 101.0 } }.data());
  auto filter = MakeFilter(image.GetPointer(), 50);
  filter->WantInitialHeatOn();
  filter->Update();
  for (const auto * output :
       { static_cast<itk::Image<float, 3> *>(filter->GetOutput()), filter->GetInitialHeatOutput() })
  {
    EXPECT_EQ(output->GetDirection(), image->GetDirection());
    EXPECT_EQ(output->GetSpacing(), image->GetSpacing());
    EXPECT_EQ(output->GetOrigin(), image->GetOrigin());
    EXPECT_EQ(output->GetBufferedRegion(), image->GetBufferedRegion());
  }
}

TEST(CumulativeHeatDiffusionImageFilter, WithoutInitialHeatNothingOfAnEarlierRunStays)
{
  const auto filter = MakeFilter(MakeImage<float>(test::MakeScene({ 9, 8, 7 }, 0.1)).GetPointer(), 20);
  filter->WantInitialHeatOn();
  filter->Update();
  EXPECT_EQ(filter->GetInitialHeatOutput()->GetBufferedRegion().GetNumberOfPixels(), 9U * 8U * 7U);
  filter->WantInitialHeatOff();
  filter->Update();
  EXPECT_EQ(filter->GetInitialHeatOutput()->GetBufferedRegion().GetNumberOfPixels(), 0U);
}

TEST(CumulativeHeatDiffusionImageFilter, TheSameWindowAsksForNoNewRun)
{
  const auto filter = MakeFilter(MakeImage<float>(test::MakeScene({ 9, 8, 7 }, 0.1)).GetPointer(), 20);
  filter->SetIntensityWindow(0.1, 0.9);
  filter->Update();
  const auto made = filter->GetOutput()->GetUpdateMTime();
  filter->SetIntensityWindow(0.1, 0.9);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetUpdateMTime(), made);
  filter->SetIntensityWindow(0.2, 0.9);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetUpdateMTime(), made);
}

TEST(CumulativeHeatDiffusionImageFilter, ARegionThatStartsElsewhereAndAPartialRequestGiveTheSameHeat)
{
  const test::Volume               volume = test::MakeScene({ 11, 12, 13 }, 0.1);
  const auto                       image = MakeImage<float>(volume);
  itk::Image<float, 3>::IndexType  start{ { -4, 7, 100 } };
  itk::Image<float, 3>::RegionType region(start, image->GetLargestPossibleRegion().GetSize());
  image->SetRegions(region);
  const auto filter = MakeFilter(image.GetPointer(), 100);
  filter->GetOutput()->UpdateOutputInformation();
  filter->GetOutput()->SetRequestedRegion(itk::Image<float, 3>::RegionType(start, { { 2, 2, 2 } }));
  filter->GetOutput()->Update();
  EXPECT_EQ(filter->GetOutput()->GetBufferedRegion(), region);
  EXPECT_EQ(VoxelsOf(filter->GetOutput()), HeatOf(volume, 100));
}

TEST(CumulativeHeatDiffusionImageFilter, ConductancesAsPublishedMatchBruteForce)
{
  const test::Volume volume = test::MakeScene({ 12, 11, 10 }, 0.1, { { 1.0, 1.5, 3.0 } });
  const auto         image = MakeImage<float>(volume);
  image->SetSpacing(volume.spacing.data());
  test::BruteForce brute(volume, 7.0, 1.0 / 12.0, false);
  for (int step = 0; step < 300; ++step)
  {
    brute.Step();
  }
  const auto filter = MakeFilter(image.GetPointer(), 300);
  filter->SetConductance(VolumeGradientOperator::Conductance::Published);
  filter->Update();
  EXPECT_LT(test::LargestDifference(VoxelsOf(filter->GetOutput()), brute.heat), 1e-5);
}

TEST(CumulativeHeatDiffusionImageFilter, TheSpacingMattersUnlessItIsIgnored)
{
  const test::Volume volume = test::MakeScene({ 12, 12, 12 }, 0.1);
  const auto         image = MakeImage<float>(volume);
  image->SetSpacing(std::array<double, 3>{ { 1.0, 1.0, 3.0 } }.data());
  const auto run = [&](bool ignore) {
    const auto filter = MakeFilter(image.GetPointer(), 100);
    filter->SetIgnoreSpacing(ignore);
    filter->Update();
    return VoxelsOf(filter->GetOutput());
  };
  EXPECT_EQ(run(true), HeatOf(volume, 100));
  EXPECT_GT(test::LargestDifference(run(false), run(true)), 0.01);
}

TEST(CumulativeHeatDiffusionImageFilter, AConstantVolumeStaysCold)
{
  for (const float heat : HeatOf(test::Volume({ 6, 5, 4 }, 42.0F), 1000))
  {
    EXPECT_EQ(heat, 0.0F);
  }
}

TEST(CumulativeHeatDiffusionImageFilter, AVolumeOfOneSliceOrOneVoxelIsNoSpecialCase)
{
  for (const test::Size & size : { test::Size{ 1, 1, 1 }, test::Size{ 9, 8, 1 }, test::Size{ 1, 1, 30 } })
  {
    const test::Volume volume = test::MakeScene(size, 0.5);
    test::BruteForce   brute(volume, 7.0, 1.0 / 12.0);
    for (int step = 0; step < 40; ++step)
    {
      brute.Step();
    }
    const auto heat = HeatOf(volume, 40);
    const bool isConstant = heat.size() == 1;
    for (std::size_t i = 0; i < heat.size(); ++i)
    {
      EXPECT_NEAR(heat[i], isConstant ? 0.0 : brute.heat[i], 1e-5);
    }
  }
}

TEST(CumulativeHeatDiffusionImageFilter, HistogramAndSnapshotsAgree)
{
  const auto                 image = MakeImage<float>(test::MakeScene({ 30, 20, 25 }, 0.05));
  const auto                 steps = MakeSnapshotSteps(2000, 30, SnapshotSpacing::Logarithmic);
  auto                       filter = MakeFilter(image.GetPointer(), 2000);
  HeatHistogram              histogram(steps);
  std::vector<std::uint64_t> taken;
  std::vector<float>         last;
  filter->SetHistogramSteps(steps);
  filter->SetSnapshotSteps(steps, [&](std::uint64_t step, const itk::Image<float, 3> * heat) {
    last = VoxelsOf(heat);
    histogram.AddToRow(taken.size(), last.data(), last.size());
    taken.push_back(step);
  });
  filter->Update();
  ASSERT_EQ(taken, steps);
  EXPECT_TRUE(histogram == filter->GetResult().histogram);
  EXPECT_EQ(last, VoxelsOf(filter->GetOutput()));
}

TEST(CumulativeHeatDiffusionImageFilter, HistogramsOfLargeVolumesCountSlicesForTheirNeighbors)
{
  const std::array<std::size_t, 3> size{ 165, 160, 171 }; // more than 2^22 voxels: every second slice, and a last one
  const std::uint64_t              voxels = size[0] * size[1] * size[2];
  const auto                       image = MakeImage<float>(test::MakeScene(size, 0.05));
  const auto                       steps = MakeSnapshotSteps(1200, 13, SnapshotSpacing::Linear);
  auto                             counted = MakeFilter(image.GetPointer(), 1200);
  counted->SetHistogramSteps(steps);
  counted->Update();
  auto          shown = MakeFilter(image.GetPointer(), 1200);
  HeatHistogram exact(steps);
  std::size_t   number = 0;
  shown->SetSnapshotSteps(steps, [&](std::uint64_t, const itk::Image<float, 3> * heat) {
    exact.AddToRow(number++, heat->GetBufferPointer(), voxels);
  });
  shown->Update();
  const HeatHistogram & histogram = counted->GetResult().histogram;
  bool                  sampled = false;
  for (std::size_t row = 0; row < steps.size(); ++row)
  {
    std::int64_t difference = 0; // of the number of voxels up to a bin
    for (unsigned int bin = 0; bin < HeatHistogram::NumberOfBins; ++bin)
    {
      difference += static_cast<std::int64_t>(histogram.GetCount(row, bin)) - exact.GetCount(row, bin);
      sampled = sampled || difference != 0;
      EXPECT_LT(std::abs(difference), static_cast<std::int64_t>(voxels / 100)) << "row " << row << ", bin " << bin;
    }
    EXPECT_EQ(difference, 0) << "row " << row; // all voxels are counted
  }
  EXPECT_TRUE(sampled);
  EXPECT_TRUE(std::equal(histogram.GetRow(12),
                         histogram.GetRow(12) + HeatHistogram::NumberOfBins,
                         exact.GetRow(12))); // the last row is exact
}

TEST(CumulativeHeatDiffusionImageFilter, RowsAfterTheSteadyStateAreLeftOut)
{
  const auto steps = MakeSnapshotSteps(1000000, 100, SnapshotSpacing::Logarithmic);
  auto       filter = MakeFilter(MakeImage<float>(Sphere(20, 6)).GetPointer(), 1000000);
  filter->SetHistogramSteps(steps);
  filter->UntilSteadyOn();
  filter->Update();
  const auto & result = filter->GetResult();
  EXPECT_TRUE(result.steady);
  EXPECT_LT(result.timeStep, 1000000U);
  EXPECT_LE(result.histogram.GetTimeSteps().back(), result.timeStep);
  EXPECT_GT(result.histogram.GetNumberOfRows(), 10U);
}

TEST(CumulativeHeatDiffusionImageFilter, RefusesBadParameters)
{
  const auto image = MakeImage<float>(test::MakeScene({ 8, 8, 8 }, 0.1));
  const auto expectRefused = [&](const auto & spoil) {
    auto filter = MakeFilter(image.GetPointer(), 10);
    spoil(filter);
    EXPECT_THROW(filter->Update(), ParameterError);
  };
  expectRefused([](auto & filter) { filter->SetP(-0.1); });
  expectRefused([](auto & filter) { filter->SetTimeSteps(0); });
  expectRefused([](auto & filter) { filter->SetIntensityWindow(5.0, 5.0); });
  expectRefused([](auto & filter) { filter->SetIntensityWindow(5.0, 1.0); });
  expectRefused([](auto & filter) { filter->SetTimeStepLength(0.2); });
  expectRefused([](auto & filter) { filter->SetTolerance(0.0); });
  expectRefused([](auto & filter) { filter->SetHistogramSteps({ 11 }); });
  expectRefused([](auto & filter) { filter->SetHistogramSteps({ 9, 3 }); });
  expectRefused([](auto & filter) { filter->SetHistogramSteps({ 3, 3 }); });
  expectRefused([](auto & filter) { filter->SetSnapshotSteps({ 3 }, {}); });
  image->GetBufferPointer()[100] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(MakeFilter(image.GetPointer(), 10)->Update(), InputError);
  EXPECT_THROW(MakeFilter(itk::Image<float, 3>::New().GetPointer(), 10)->Update(), InputError);
}

TEST(CumulativeHeatDiffusionImageFilter, AbortEndsTheRun)
{
  auto filter = MakeFilter(MakeImage<float>(test::MakeScene({ 32, 32, 32 }, 0.1)).GetPointer(), 100000);
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { filter->AbortGenerateDataOn(); });
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
  EXPECT_LT(filter->GetProgress(), 0.5F);
}
