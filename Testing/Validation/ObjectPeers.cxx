#include "ObjectPeers.h"
#include "BestNodes.h"

#include "SeedTrial.h"

#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonSmoothVoxels.h"

#include "itkGradientMagnitudeImageFilter.h"
#include "itkMorphologicalWatershedImageFilter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using namespace shapeton;

namespace
{
using Image = itk::Image<float, 3>;

Image::Pointer
Smooth(const Image * image)
{
  constexpr double sigma = 0.8; // voxels
  const auto       smooth = MapVoxels<float>(image, [](float value) { return value; });
  SmoothVoxels(GridOf(image), { { sigma, sigma, sigma } }, smooth->GetBufferPointer());
  return smooth;
}

std::vector<double>
BestWatersheds(const Image * smooth, const ReferenceParts & parts)
{
  using Regions = itk::Image<unsigned int, 3>;
  const auto gradient = itk::GradientMagnitudeImageFilter<Image, Image>::New();
  gradient->SetInput(smooth);
  const auto          voxels = parts.GetGrid().NumberOfVoxels();
  const auto          extremes = std::minmax_element(smooth->GetBufferPointer(), smooth->GetBufferPointer() + voxels);
  const double        range = (*extremes.second - *extremes.first) / smooth->GetSpacing()[0];
  std::vector<double> best(parts.GetLabels().size(), 0.0);
  for (const double level : { 0.02, 0.1 }) // of the range per voxel
  {
    const auto watershed = itk::MorphologicalWatershedImageFilter<Image, Regions>::New();
    watershed->SetInput(gradient->GetOutput());
    watershed->SetLevel(level * range);
    watershed->MarkWatershedLineOff();
    watershed->Update();
    std::map<unsigned int, ReferenceParts::Counts> regions;
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
    {
      auto & counts = regions[watershed->GetOutput()->GetBufferPointer()[voxel]];
      counts.resize(parts.GetTotals().size(), 0.0);
      counts[parts.LabelOf(voxel)] += 1.0;
    }
    for (const auto & region : regions)
    {
      const auto & counts = region.second;
      const double size = std::accumulate(counts.begin(), counts.end(), 0.0);
      for (std::size_t i = 0; i < best.size(); ++i)
      {
        best[i] = std::max(best[i], parts.Dice(parts.GetLabels()[i], counts.data(), size));
      }
    }
  }
  return best;
}

/** One seed in a part, of label 2, and the border of the volume. */
SeedImage::Pointer
SeedsOf(int part, const Image * image, const ReferenceParts & parts)
{
  const auto        seeds = NewImageOn<SeedImage>(image, true);
  const VoxelGrid & grid = parts.GetGrid();
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    int neighbors = 0;
    ForEachNeighbor(grid, voxel, [&](std::size_t) { ++neighbors; });
    seeds->GetBufferPointer()[voxel] = neighbors < 6 && parts.LabelOf(voxel) != part ? 1 : 0;
  }
  const auto depths = parts.DepthsOf(part);
  const auto deepest = std::max_element(depths.squares.begin(), depths.squares.end()) - depths.squares.begin();
  seeds->GetBufferPointer()[depths.voxels[deepest]] = 2;
  return seeds;
}
} // namespace

std::vector<ObjectPeer>
MeasurePeers(const Image * image, const Image * heat, const ReferenceParts & parts)
{
  constexpr float least = 1e-6F; // heat, as HeatObjectTree
  const auto      smooth = Smooth(image);
  const auto      logarithm = MapVoxels<float>(heat, [=](float value) { return std::log(std::max(value, least)); });
  std::vector<ObjectPeer> peers;
  for (const bool isHeat : { false, true })
  {
    const std::string   of = isHeat ? " of heat" : " of intensity";
    const float * const values = isHeat ? logarithm->GetBufferPointer() : smooth->GetBufferPointer();
    peers.push_back({ "max-tree" + of, BestNodes(values, EdgeWeight::NegativeMinimum, parts) });
    peers.push_back({ "min-tree" + of, BestNodes(values, EdgeWeight::Maximum, parts) });
    peers.push_back({ "flat zones" + of, BestNodes(values, EdgeWeight::Difference, parts) });
  }
  peers.push_back({ "watershed", BestWatersheds(smooth, parts) });
  return peers;
}

std::vector<double>
DiceOfRandomWalker(const Image * image, const ReferenceParts & parts)
{
  const auto          voxels = parts.GetGrid().NumberOfVoxels();
  const auto          extremes = std::minmax_element(image->GetBufferPointer(), image->GetBufferPointer() + voxels);
  const float         least = *extremes.first;
  const float         range = *extremes.second - least;
  const LabeledVolume volume{ "", MapVoxels<float>(image, [=](float v) { return (v - least) / range; }), nullptr, {} };
  std::vector<SeedImage::Pointer> seeds;
  for (const int part : parts.GetLabels())
  {
    seeds.push_back(SeedsOf(part, image, parts));
  }
  std::vector<double> dice;
  const auto          segmentations = SegmentByRandomWalker(volume, seeds);
  for (std::size_t i = 0; segmentations && i < seeds.size(); ++i)
  {
    ReferenceParts::Counts counts(parts.GetTotals().size(), 0.0);
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
    {
      counts[parts.LabelOf(voxel)] += (*segmentations)[i].labels->GetBufferPointer()[voxel] == 2 ? 1.0 : 0.0;
    }
    const double size = std::accumulate(counts.begin(), counts.end(), 0.0);
    dice.push_back(parts.Dice(parts.GetLabels()[i], counts.data(), size));
  }
  return dice;
}
