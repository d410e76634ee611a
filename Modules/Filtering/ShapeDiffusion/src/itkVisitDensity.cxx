#include "itkVisitDensity.h"

#include "itkParallelRows.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace itk
{
namespace
{
/** Calls `body(first voxel, number of voxels)` for each slice. */
template <typename TBody>
void
ForSlices(const Image<std::uint32_t, 3> * visits, const TBody & body)
{
  const auto        size = visits->GetBufferedRegion().GetSize();
  const std::size_t length = size[0] * size[1];
  ParallelFor(size[2], [&](std::size_t z) { body(z * length, length); });
}

float
ScaleOf(const Image<std::uint32_t, 3> * visits)
{
  std::uint32_t greatest = 0;
  std::mutex    mutex;
  ForSlices(visits, [&](std::size_t first, std::size_t number) {
    const std::uint32_t * const       begin = visits->GetBufferPointer() + first;
    const std::uint32_t               ours = *std::max_element(begin, begin + number);
    const std::lock_guard<std::mutex> lock(mutex);
    greatest = std::max(greatest, ours);
  });
  return greatest == 0 ? 0.0F : 1.0F / static_cast<float>(greatest);
}

void
Scale(const std::uint32_t * visits, std::size_t number, float scale, float * density)
{
  std::transform(visits, visits + number, density, [scale](std::uint32_t count) {
    return std::min(1.0F, static_cast<float>(count) * scale);
  });
}
} // namespace

Image<float, 3>::Pointer
NormalizeVisits(const Image<std::uint32_t, 3> * visits)
{
  auto density = Image<float, 3>::New();
  density->CopyInformation(visits);
  density->SetRegions(visits->GetBufferedRegion());
  density->Allocate();
  const float scale = ScaleOf(visits);
  ForSlices(visits, [&](std::size_t first, std::size_t number) {
    Scale(visits->GetBufferPointer() + first, number, scale, density->GetBufferPointer() + first);
  });
  return density;
}

void
AddVisitsToRow(const Image<std::uint32_t, 3> * visits, std::size_t row, HeatHistogram & histogram)
{
  const float scale = ScaleOf(visits);
  std::mutex  mutex;
  ForSlices(visits, [&](std::size_t first, std::size_t number) {
    std::vector<float>         density(number);
    std::vector<std::uint32_t> counts(HeatHistogram::NumberOfBins, 0);
    Scale(visits->GetBufferPointer() + first, number, scale, density.data());
    HeatHistogram::CountHeats(density.data(), number, counts.data());
    const std::lock_guard<std::mutex> lock(mutex);
    histogram.AddToRow(row, counts.data());
  });
}
} // namespace itk
