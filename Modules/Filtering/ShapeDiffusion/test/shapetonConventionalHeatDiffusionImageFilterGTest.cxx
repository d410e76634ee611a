#include "shapetonConventionalHeatDiffusionImageFilter.h"
#include "shapetonShapeDiffusionTestVolumes.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace shapeton;
using namespace shapeton::test;

namespace
{
std::vector<float>
Diffuse(const Volume & volume, std::uint64_t steps, double sourceHeat = 1.0)
{
  const VolumeGradientOperator volumeGradient(volume.values.data(), volume.size, volume.Parameters(5.0));
  std::vector<float>           heat(volume.values.size());
  DiffuseConventionalHeat(volumeGradient, 1.0 / 12.0, steps, sourceHeat, heat.data());
  return heat;
}
} // namespace

TEST(ConventionalHeatDiffusion, MatchesOneRunForEachSource)
{
  const Volume volume = MakeScene({ 7, 6, 5 }, 0.2);
  for (const std::uint64_t steps : { 1, 2, 9, 40 })
  {
    const auto          heat = Diffuse(volume, steps, 0.8);
    std::vector<double> expected;
    BruteForce          brute(volume, volume.Parameters(5.0), 1.0 / 12.0);
    for (std::size_t source = 0; source < volume.values.size(); ++source)
    {
      std::fill(brute.heat.begin(), brute.heat.end(), 0.0);
      brute.heat[source] = 0.8;
      for (std::uint64_t step = 0; step < steps; ++step)
      {
        brute.Step();
      }
      expected.push_back(brute.heat[source]);
    }
    EXPECT_LT(LargestDifference(heat, expected), 1e-6) << steps;
  }
}

TEST(ConventionalHeatDiffusion, AClosedObjectEndsAtItsShareAndNotAtItsMeanInitialHeat)
{
  Volume volume({ 7, 7, 7 });
  volume.Fill([](std::size_t x, std::size_t y, std::size_t z) {
    return x >= 2 && x < 5 && y >= 2 && y < 5 && z >= 2 && z < 5 ? 1.0 : 0.0;
  });
  const auto heat = Diffuse(volume, 2000);
  EXPECT_NEAR(heat[(3 * 7 + 3) * 7 + 3], 1.0 / 27.0, 1e-6); // CHD ends at 1/3
}

TEST(ConventionalHeatDiffusion, FilterEqualsTheFunctionAndKeepsTheGeometry)
{
  const Volume volume = MakeScene({ 6, 5, 7 }, 0.2);
  auto         image = itk::Image<float, 3>::New();
  image->SetRegions(itk::Image<float, 3>::SizeType{ { 6, 5, 7 } });
  image->Allocate();
  std::copy(volume.values.begin(), volume.values.end(), image->GetBufferPointer());
  image->SetOrigin(std::array<double, 3>{ { 1.0, -2.0, 3.0 } }.data());
  auto filter = ConventionalHeatDiffusionImageFilter<itk::Image<float, 3>>::New();
  filter->SetInput(image);
  filter->SetP(5.0);
  filter->SetTimeSteps(12);
  filter->Update();
  const float * const heat = filter->GetOutput()->GetBufferPointer();
  EXPECT_EQ(std::vector<float>(heat, heat + volume.values.size()), Diffuse(volume, 12));
  EXPECT_EQ(filter->GetOutput()->GetOrigin(), image->GetOrigin());
  filter->SetSourceHeat(1.5);
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
