#include "SeedTrial.h"
#include "Times.h"

#include "shapetonPhiloxStream.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonTestImages.h"

#include "itkConfidenceConnectedImageFilter.h"
#include "itkGradientMagnitudeImageFilter.h"
#include "itkMorphologicalWatershedFromMarkersImageFilter.h"

#include <cmath>

using namespace shapeton;

namespace
{
using ImageType = LabeledVolume::ImageType;
using Voxels = std::vector<std::size_t>;

std::size_t
NumberOfVoxels(const itk::ImageBase<3> * image)
{
  return image->GetLargestPossibleRegion().GetNumberOfPixels();
}

/** Voxels of each label, starting at 1. */
std::vector<Voxels>
VoxelsOfLabels(const SeedImage * labels, std::size_t number)
{
  std::vector<Voxels> voxels(number);
  for (std::size_t i = 0; i < NumberOfVoxels(labels); ++i)
  {
    if (const unsigned short label = labels->GetBufferPointer()[i])
    {
      voxels[label - 1].push_back(i);
    }
  }
  return voxels;
}
} // namespace

DrawnSeeds
DrawSeeds(const LabeledVolume & volume, int number, unsigned int draw)
{
  const std::size_t labels = volume.names.size();
  const auto        own = VoxelsOfLabels(volume.truth, labels);
  auto              inner = VoxelsOfLabels(SeedsOfClasses(volume.truth, {}), labels);
  DrawnSeeds        seeds{ NewImageOn<SeedImage>(volume.truth, true) };
  for (std::size_t label = 0; label < labels; ++label)
  {
    Voxels & voxels = inner[label];
    if (voxels.size() < static_cast<std::size_t>(number))
    {
      voxels = own[label];
      ++seeds.thinLabels;
    }
    PhiloxStream stream(draw, static_cast<std::uint32_t>(label), static_cast<std::uint32_t>(number));
    for (int i = 0; i < std::min(number, static_cast<int>(voxels.size())); ++i)
    {
      std::swap(voxels[i], voxels[i + stream.Below(static_cast<int>(voxels.size()) - i)]);
      seeds.image->GetBufferPointer()[voxels[i]] = static_cast<unsigned short>(label + 1);
    }
  }
  return seeds;
}

Segmentation
SegmentByHeat(const LabeledVolume & volume, const SeedImage * seeds)
{
  const Stopwatch clock;
  const auto      filter = SeededHeatSegmentationImageFilter<ImageType>::New();
  filter->SetInput(volume.image);
  filter->SetSeeds(seeds);
  filter->SetIntensityWindow(0.0, 1.0);
  filter->KeepProbabilitiesOff();
  filter->Update();
  return { filter->GetOutput(), clock.ProcessorSeconds() };
}

Segmentation
SegmentByWatershed(const LabeledVolume & volume, const SeedImage * seeds)
{
  const Stopwatch clock;
  const auto      gradient = itk::GradientMagnitudeImageFilter<ImageType, ImageType>::New();
  gradient->SetInput(volume.image);
  const auto watershed = itk::MorphologicalWatershedFromMarkersImageFilter<ImageType, SeedImage>::New();
  watershed->SetInput1(gradient->GetOutput());
  watershed->SetInput2(seeds);
  watershed->MarkWatershedLineOff();
  watershed->Update();
  return { watershed->GetOutput(), clock.ProcessorSeconds() };
}

Segmentation
SegmentByConfidence(const LabeledVolume & volume, const SeedImage * seeds)
{
  const Stopwatch    clock;
  const std::size_t  number = NumberOfVoxels(seeds);
  const auto         labels = NewImageOn<SeedImage>(seeds, true);
  std::vector<float> distance(number, HUGE_VALF);
  unsigned short     label = 0;
  for (const Voxels & voxels : VoxelsOfLabels(seeds, volume.names.size()))
  {
    ++label;
    const auto region = itk::ConfidenceConnectedImageFilter<ImageType, itk::Image<unsigned char, 3>>::New();
    region->SetInput(volume.image);
    for (const std::size_t voxel : voxels)
    {
      region->AddSeed(seeds->ComputeIndex(static_cast<itk::OffsetValueType>(voxel)));
    }
    region->Update();
    const auto mean = static_cast<float>(region->GetMean());
    for (std::size_t i = 0; i < number; ++i)
    {
      const float difference = std::abs(volume.image->GetBufferPointer()[i] - mean);
      if (region->GetOutput()->GetBufferPointer()[i] != 0 && difference < distance[i])
      {
        distance[i] = difference;
        labels->GetBufferPointer()[i] = label;
      }
    }
  }
  for (std::size_t i = 0; i < number; ++i)
  {
    unsigned short &     found = labels->GetBufferPointer()[i];
    const unsigned short seed = seeds->GetBufferPointer()[i];
    found = seed != 0 ? seed : std::max<unsigned short>(found, 1);
  }
  return { labels, clock.ProcessorSeconds() };
}

std::vector<double>
DiceOfLabels(const LabeledVolume & volume, const SeedImage * labels)
{
  const std::size_t   number = volume.names.size();
  std::vector<double> shared(number, 0.0), all(number, 0.0);
  for (std::size_t i = 0; i < NumberOfVoxels(labels); ++i)
  {
    const unsigned short truth = volume.truth->GetBufferPointer()[i];
    const unsigned short found = labels->GetBufferPointer()[i];
    ++all[truth - 1];
    ++all.at(found - 1);
    shared[truth - 1] += truth == found ? 1.0 : 0.0;
  }
  for (std::size_t label = 0; label < number; ++label)
  {
    shared[label] *= 2.0 / all[label];
  }
  return shared;
}
