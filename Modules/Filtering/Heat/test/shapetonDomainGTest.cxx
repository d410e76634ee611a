#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonDiffusionTestImages.h"
#include "shapetonHeatParameterChoice.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonTestImages.h"
#include "shapetonTestThreads.h"
#include "shapetonVoxelGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace shapeton;

namespace
{
using Image = itk::Image<float, 3>;
using Mask = itk::Image<unsigned char, 3>;
using Seeds = itk::Image<unsigned short, 3>;
using Heat = CumulativeHeatDiffusionImageFilter<Image>;

constexpr int   side = 24;
const VoxelGrid grid(side, side, side);

/** A ball in noise. */
Image::Pointer
MakeVolume()
{
  const auto                      image = basetest::NewImage<Image>(Image::SizeType::Filled(side));
  std::mt19937                    random(5);
  std::normal_distribution<float> noise(0.0F, 2.0F);
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    const auto place = grid.Voxel(voxel);
    const bool isIn = std::hypot(place[0] - 11.5, place[1] - 11.5, place[2] - 11.5) < 7.0;
    image->GetBufferPointer()[voxel] = (isIn ? 100.0F : 20.0F) + noise(random);
  }
  image->SetSpacing(itk::Vector<double, 3>(std::array<double, 3>{ { 1.0, 1.2, 2.0 } }.data()));
  return image;
}

template <typename TIsIn>
Mask::Pointer
MakeDomain(const Image * volume, const TIsIn & isIn)
{
  const auto mask = basetest::NewImage<Mask>(Image::SizeType::Filled(side));
  mask->CopyInformation(volume);
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    mask->GetBufferPointer()[voxel] = isIn(grid.Voxel(voxel)) ? 1 : 0;
  }
  return mask;
}

bool
IsInBox(const std::array<int, 3> & place)
{
  return std::all_of(place.begin(), place.end(), [](int i) { return i >= 3 && i < side - 4; });
}

Heat::Pointer
Diffuse(const Image * volume, const Mask * domain, double smoothing = 0.0)
{
  const auto filter = Heat::New();
  filter->SetInput(volume);
  filter->SetDomain(domain);
  filter->SetP(3.0);
  filter->SetIntensityWindow(0.0, 120.0);
  filter->SetSmoothing(smoothing);
  filter->SetTimeSteps(200);
  filter->SetWantInitialHeat(true);
  filter->Update();
  return filter;
}

/** Changes the intensities outside. */
Image::Pointer
WithOther(const Image * volume, const Mask * domain, float value)
{
  const auto other = basetest::NewImage<Image>(Image::SizeType::Filled(side));
  other->CopyInformation(volume);
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    other->GetBufferPointer()[voxel] =
      domain->GetBufferPointer()[voxel] != 0 ? volume->GetBufferPointer()[voxel] : value;
  }
  return other;
}

double
SumOf(const Image * image)
{
  return std::accumulate(image->GetBufferPointer(), image->GetBufferPointer() + grid.NumberOfVoxels(), 0.0);
}
} // namespace

TEST(Domain, TheWholeVolumeGivesTheSameBytes)
{
  const auto volume = MakeVolume();
  const auto all = MakeDomain(volume, [](const auto &) { return true; });
  EXPECT_EQ(basetest::BytesOf(Diffuse(volume, all)->GetOutput()),
            basetest::BytesOf(Diffuse(volume, nullptr)->GetOutput()));
}

TEST(Domain, HeatInsideIsConserved)
{
  const auto   volume = MakeVolume();
  const auto   filter = Diffuse(volume, MakeDomain(volume, IsInBox)); // does not touch the border, where heat leaves
  const double before = SumOf(filter->GetInitialHeatOutput());
  ASSERT_GT(before, 1.0);
  EXPECT_NEAR(SumOf(filter->GetOutput()) / before, 1.0, 1e-5);
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    ASSERT_TRUE(IsInBox(grid.Voxel(voxel)) || filter->GetOutput()->GetBufferPointer()[voxel] == 0.0F);
  }
}

TEST(Domain, IntensitiesOutsideHaveNoEffect)
{
  const auto  volume = MakeVolume();
  const auto  domain = MakeDomain(volume, IsInBox);
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  for (const double smoothing : { 0.0, 1.5 })
  {
    const auto heat = basetest::BytesOf(Diffuse(volume, domain, smoothing)->GetOutput());
    EXPECT_EQ(basetest::BytesOf(Diffuse(WithOther(volume, domain, 7000.0F), domain, smoothing)->GetOutput()), heat);
    EXPECT_EQ(basetest::BytesOf(Diffuse(WithOther(volume, domain, nothing), domain, smoothing)->GetOutput()), heat);
  }
}

TEST(Domain, ParametersAreChosenInside)
{
  const auto volume = MakeVolume();
  const auto domain = MakeDomain(volume, IsInBox);
  const auto choose = [&](const Image * image) {
    const auto filter = Heat::New();
    filter->SetInput(image);
    filter->SetDomain(domain);
    return ChooseHeatParameters(filter->GetVolume(), filter->GetOptions());
  };
  const auto choice = choose(volume);
  const auto other = choose(WithOther(volume, domain, 7000.0F));
  EXPECT_EQ(choice.intensityWindow, other.intensityWindow);
  EXPECT_EQ(choice.p, other.p);
  EXPECT_EQ(choice.smoothing, other.smoothing);
  EXPECT_EQ(choice.timeSteps, other.timeSteps);
  EXPECT_LT(choice.intensityWindow[1], 200.0);
}

TEST(Domain, ItsBorderIsNotAnEdge)
{
  const auto volume = basetest::NewImage<Image>(Image::SizeType::Filled(side));
  volume->FillBuffer(20.0F);
  const auto domain = MakeDomain(volume, IsInBox);
  EXPECT_EQ(SumOf(Diffuse(WithOther(volume, domain, 100.0F), domain)->GetInitialHeatOutput()), 0.0);
}

TEST(Domain, ABarrierSeparatesHeat)
{
  const auto volume = MakeVolume();
  const auto walls = MakeDomain(volume, [](const auto & place) { return place[0] != 12; });
  const auto other = MakeVolume();
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    other->GetBufferPointer()[voxel] += grid.Voxel(voxel)[0] > 12 ? 8.0F : 0.0F; // adds an edge only at the wall
  }
  const auto greatestChange = [&](const Mask * domain) {
    const auto before = Diffuse(volume, domain);
    const auto after = Diffuse(other, domain);
    double     greatest = 0.0;
    for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
    {
      const double change =
        before->GetOutput()->GetBufferPointer()[voxel] - after->GetOutput()->GetBufferPointer()[voxel];
      greatest = std::max(greatest, std::abs(change));
    }
    return greatest;
  };
  EXPECT_LT(greatestChange(walls), 1e-6);
  EXPECT_GT(greatestChange(nullptr), 1e-3);
}

TEST(Domain, SeedsLabelABoxLikeTheCroppedVolume)
{
  const auto          volume = MakeVolume();
  const auto          domain = MakeDomain(volume, IsInBox);
  const int           inner = side - 7;
  const VoxelGrid     box(inner, inner, inner);
  const auto          cropped = basetest::NewImage<Image>(Image::SizeType::Filled(inner));
  const auto          seedsOfBox = basetest::NewImage<Seeds>(Image::SizeType::Filled(inner));
  const auto          seeds = basetest::NewImage<Seeds>(Image::SizeType::Filled(side));
  const itk::Index<3> a{ { 11, 11, 11 } }, b{ { 4, 4, 4 } }, outside{ { 0, 0, 0 } };
  seeds->CopyInformation(volume);
  seeds->FillBuffer(0);
  seedsOfBox->FillBuffer(0);
  cropped->SetSpacing(volume->GetSpacing());
  seedsOfBox->SetSpacing(volume->GetSpacing());
  const auto inVolume = [&](std::size_t voxel) {
    const auto place = box.Voxel(voxel);
    return grid.Index(place[0] + 3, place[1] + 3, place[2] + 3);
  };
  for (const auto & [place, label] : { std::pair(a, 1), std::pair(b, 2), std::pair(outside, 3) })
  {
    seeds->SetPixel(place, static_cast<unsigned short>(label));
  }
  for (std::size_t voxel = 0; voxel < box.NumberOfVoxels(); ++voxel)
  {
    cropped->GetBufferPointer()[voxel] = volume->GetBufferPointer()[inVolume(voxel)];
    seedsOfBox->GetBufferPointer()[voxel] = seeds->GetBufferPointer()[inVolume(voxel)];
  }
  const auto solve = [](const Image * image, const Seeds * of, const Mask * in) {
    const auto filter = SeededHeatSegmentationImageFilter<Image>::New();
    filter->SetInput(image);
    filter->SetSeeds(of);
    filter->SetDomain(in);
    filter->SetIntensityWindow(0.0, 120.0);
    filter->SetTolerance(1e-6);
    filter->SetKeepProbabilities(true);
    filter->Update();
    return filter;
  };
  const auto whole = solve(volume, seeds, domain);
  const auto part = solve(cropped, seedsOfBox, nullptr);
  ASSERT_EQ(whole->GetLabelValues(), part->GetLabelValues()); // the seed outside has no effect
  for (const unsigned short label : { 1, 2 })
  {
    const auto ofWhole = whole->GetProbabilities(label);
    const auto ofPart = part->GetProbabilities(label);
    for (std::size_t voxel = 0; voxel < box.NumberOfVoxels(); ++voxel)
    {
      ASSERT_NEAR(ofWhole->GetBufferPointer()[inVolume(voxel)], ofPart->GetBufferPointer()[voxel], 1e-4);
    }
    EXPECT_EQ(ofWhole->GetPixel(outside), 0.0F);
  }
  EXPECT_EQ(whole->GetOutput()->GetPixel(outside), 0);
}

TEST(Domain, PartsWithoutASeedHaveNoLabel)
{
  const auto volume = MakeVolume();
  const auto walls = MakeDomain(volume, [](const auto & place) { return place[0] != 12; });
  const auto seeds = basetest::NewImage<Seeds>(Image::SizeType::Filled(side));
  seeds->CopyInformation(volume);
  seeds->FillBuffer(0);
  seeds->SetPixel({ { 8, 11, 11 } }, 1);
  seeds->SetPixel({ { 1, 1, 1 } }, 2);
  const auto filter = SeededHeatSegmentationImageFilter<Image>::New();
  filter->SetInput(volume);
  filter->SetSeeds(seeds);
  filter->SetDomain(walls);
  filter->Update();
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    ASSERT_EQ(filter->GetOutput()->GetBufferPointer()[voxel] != 0, grid.Voxel(voxel)[0] < 12);
    ASSERT_TRUE(grid.Voxel(voxel)[0] < 12 || filter->GetUncertaintyOutput()->GetBufferPointer()[voxel] == 1.0F);
  }
}

TEST(Domain, WrongDomainsAreRefused)
{
  const auto volume = MakeVolume();
  const auto nothing = MakeDomain(volume, [](const auto &) { return false; });
  EXPECT_THROW(Diffuse(volume, nothing), InputError);
  const auto small = basetest::NewImage<Mask>(Image::SizeType::Filled(side - 1));
  small->CopyInformation(volume);
  small->FillBuffer(1);
  EXPECT_THROW(Diffuse(volume, small), InputError);
  const auto filter = Heat::New();
  EXPECT_THROW(filter->GetVolume(), InputError); // no input
  filter->SetInput(volume);
  filter->SetDomain(basetest::WithoutPixels<Mask>(volume));
  EXPECT_THROW(filter->GetVolume(), InputError);
  filter->SetInput("Domain", volume); // of floats
  EXPECT_THROW(filter->Update(), InputError);
}

TEST(Domain, AnotherFirstIndexIsTheSameGrid)
{
  const auto                volume = MakeVolume();
  const auto                box = MakeDomain(volume, IsInBox);
  const itk::ImageRegion<3> elsewhere({ { 3, -2, 7 } }, Image::SizeType::Filled(side));
  const auto                same = MakeDomain(volume, IsInBox);
  same->SetRegions(elsewhere);
  Mask::PointType origin;
  same->TransformIndexToPhysicalPoint({ { -3, 2, -7 } }, origin);
  EXPECT_THROW(Diffuse(volume, same), InputError); // its voxels are elsewhere
  same->SetOrigin(origin);
  EXPECT_EQ(test::VoxelsOf(Diffuse(volume, same)->GetOutput()), test::VoxelsOf(Diffuse(volume, box)->GetOutput()));
}
