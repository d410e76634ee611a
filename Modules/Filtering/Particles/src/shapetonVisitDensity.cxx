#include "shapetonVisitDensity.h"

#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <vector>

namespace shapeton
{
namespace
{
/** Calls `body(first voxel, number of voxels)` for each slice. */
template <typename TBody>
void
ForSlices(const itk::Image<std::uint32_t, 3> * visits, const TBody & body)
{
  const auto        size = visits->GetBufferedRegion().GetSize();
  const std::size_t length = size[0] * size[1];
  ParallelFor(size[2], [&](std::size_t z) { body(z * length, length); });
}

/** The number of voxels for each number of visits. */
std::map<std::uint32_t, std::uint64_t>
VoxelsByVisits(const itk::Image<std::uint32_t, 3> * visits)
{
  constexpr std::uint32_t                few = 1U << 16; // most voxels have fewer visits: no search
  std::vector<std::uint64_t>             small(few, 0);
  std::map<std::uint32_t, std::uint64_t> voxels;
  const std::uint32_t * const            begin = visits->GetBufferPointer();
  std::for_each(begin, begin + visits->GetBufferedRegion().GetNumberOfPixels(), [&](std::uint32_t count) {
    ++(count < few ? small[count] : voxels[count]);
  });
  for (std::uint32_t count = 0; count < few; ++count)
  {
    if (small[count] > 0)
    {
      voxels[count] = small[count];
    }
  }
  return voxels;
}

/** Distributes `voxels` evenly over the densities from `lower` to `upper`, as integers per bin. */
void
Spread(double lower, double upper, std::uint64_t voxels, std::vector<std::uint32_t> & counts)
{
  std::uint64_t placed = 0;
  for (unsigned int bin = HeatHistogram::BinOf(static_cast<float>(lower)); placed < voxels; ++bin)
  {
    const double share =
      bin + 1 >= HeatHistogram::NumberOfBins ? 1.0 : (HeatHistogram::LowerEdge(bin + 1) - lower) / (upper - lower);
    const auto below =
      share >= 1.0 ? voxels : static_cast<std::uint64_t>(std::floor(share * static_cast<double>(voxels)));
    counts[bin] += static_cast<std::uint32_t>(below - std::min(below, placed));
    placed = std::max(placed, below);
  }
}
} // namespace

std::uint32_t
GreatestVisits(const itk::Image<std::uint32_t, 3> * visits)
{
  std::uint32_t greatest = 0;
  std::mutex    mutex;
  ForSlices(visits, [&](std::size_t first, std::size_t number) {
    const std::uint32_t * const       begin = visits->GetBufferPointer() + first;
    const std::uint32_t               ours = *std::max_element(begin, begin + number);
    const std::lock_guard<std::mutex> lock(mutex);
    greatest = std::max(greatest, ours);
  });
  return greatest;
}

itk::Image<float, 3>::Pointer
NormalizeVisits(const itk::Image<std::uint32_t, 3> * visits)
{
  RequirePixels(visits, "the image of visits");
  auto                density = NewImageOn<itk::Image<float, 3>>(visits);
  const std::uint32_t greatest = GreatestVisits(visits);
  const float         scale = greatest == 0 ? 0.0F : 1.0F / static_cast<float>(greatest);
  ForSlices(visits, [&](std::size_t first, std::size_t number) {
    const std::uint32_t * const begin = visits->GetBufferPointer() + first;
    std::transform(begin, begin + number, density->GetBufferPointer() + first, [scale](std::uint32_t count) {
      return std::min(1.0F, static_cast<float>(count) * scale);
    });
  });
  return density;
}

void
AddVisitsToRow(const itk::Image<std::uint32_t, 3> * visits, std::size_t row, HeatHistogram & histogram)
{
  const auto                 voxels = VoxelsByVisits(visits);
  const double               greatest = voxels.empty() ? 0.0 : voxels.rbegin()->first;
  std::vector<std::uint32_t> counts(HeatHistogram::NumberOfBins, 0);
  for (const auto & [count, number] : voxels)
  {
    if (count == 0)
    {
      counts[0] += static_cast<std::uint32_t>(number);
    }
    else
    {
      Spread((count - 0.5) / greatest, (count + 0.5) / greatest, number, counts);
    }
  }
  histogram.AddToRow(row, counts.data());
}

std::vector<HeatClass>
FindVisitClasses(const HeatHistogram & histogram, std::size_t row, std::uint32_t greatest)
{
  HeatClassificationRule rule;
  rule.backgroundHeat = 0.5 / std::max(1U, greatest);
  return FindHeatClasses(histogram, row, rule);
}

HeatClassification
ClassifyVisits(const itk::Image<std::uint32_t, 3> * visits, const itk::Image<float, 3> * density)
{
  HeatHistogram histogram({ 0 });
  AddVisitsToRow(visits, 0, histogram);
  HeatClassification classification;
  classification.classes = FindVisitClasses(histogram, 0, GreatestVisits(visits));
  classification.labels = LabelHeat(density, classification.classes);
  return classification;
}
} // namespace shapeton
