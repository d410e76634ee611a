#include "shapetonLumenDistance.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"
#include "shapetonSquaredDistances.h"
#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
bool
HasLumen(const unsigned char * row, std::size_t size, std::size_t & first, std::size_t & last)
{
  first = 0;
  while (first < size && row[first] == 0)
  {
    ++first;
  }
  if (first == size)
  {
    return false;
  }
  last = size - 1;
  while (row[last] == 0)
  {
    --last;
  }
  return true;
}

template <typename TImage>
typename TImage::Pointer
ImageOfRegion(const LumenMask * lumen, const itk::ImageRegion<3> & region)
{
  const auto image = TImage::New();
  image->SetRegions(region);
  image->SetSpacing(lumen->GetSpacing());
  image->SetOrigin(lumen->GetOrigin());
  image->SetDirection(lumen->GetDirection());
  image->Allocate();
  return image;
}
} // namespace

itk::ImageRegion<3>
LumenRegion(const LumenMask * lumen, unsigned int margin)
{
  const itk::ImageRegion<3>               whole = lumen->GetBufferedRegion();
  const auto                              size = whole.GetSize();
  std::vector<std::array<std::size_t, 4>> extents(size[2], { size[0], 0, size[1], 0 });
  ParallelFor(size[2], [&](std::size_t z) {
    const unsigned char * const slice = lumen->GetBufferPointer() + z * size[0] * size[1];
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      std::size_t first = 0;
      std::size_t last = 0;
      if (HasLumen(slice + y * size[0], size[0], first, last))
      {
        auto & e = extents[z];
        e = { std::min(e[0], first), std::max(e[1], last), std::min(e[2], y), std::max(e[3], y) };
      }
    }
  });
  std::array<std::size_t, 6> box = { size[0], 0, size[1], 0, size[2], 0 };
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    const auto & e = extents[z];
    if (e[0] < size[0])
    {
      box = { std::min(box[0], e[0]), std::max(box[1], e[1]), std::min(box[2], e[2]),
              std::max(box[3], e[3]), std::min(box[4], z),    std::max(box[5], z) };
    }
  }
  if (box[0] == size[0])
  {
    throw InputError("the lumen mask is empty: all voxels are 0. Give a mask whose lumen is nonzero.");
  }
  itk::ImageRegion<3> region = whole;
  for (unsigned int a = 0; a < 3; ++a)
  {
    region.SetIndex(a, whole.GetIndex(a) + static_cast<itk::IndexValueType>(box[2 * a]));
    region.SetSize(a, box[2 * a + 1] - box[2 * a] + 1);
  }
  region.PadByRadius(margin);
  region.Crop(whole);
  return region;
}

LumenDistanceImage::Pointer
LumenDistance(const LumenMask * lumen, const itk::ImageRegion<3> & region)
{
  const auto        image = ImageOfRegion<LumenDistanceImage>(lumen, region);
  const auto        size = region.GetSize();
  const auto        spacing = lumen->GetSpacing();
  const std::size_t slice = size[0] * size[1];
  float * const     values = image->GetBufferPointer();
  const auto        whole = lumen->GetBufferedRegion().GetSize();
  SquaredDistances(
    { lumen->GetBufferPointer() + lumen->ComputeOffset(region.GetIndex()), whole[0], whole[0] * whole[1] },
    VoxelGrid(static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2])),
    { spacing[0], spacing[1], spacing[2] },
    values);
  const double      toWall = 0.25 * std::min({ spacing[0], spacing[1], spacing[2] });
  std::vector<char> isUnknown(size[2], 0);
  ParallelFor(size[2], [&](std::size_t z) {
    for (float * value = values + z * slice; value != values + (z + 1) * slice; ++value)
    {
      isUnknown[z] = isUnknown[z] || *value >= UnknownSquaredDistance;
      *value = *value > 0.0F ? static_cast<float>(std::sqrt(static_cast<double>(*value)) - toWall) : 0.0F;
    }
  });
  if (std::find(isUnknown.begin(), isUnknown.end(), 1) != isUnknown.end())
  {
    throw InputError("the lumen mask fills its whole box and has no wall. Give a mask whose background is 0.");
  }
  return image;
}

namespace
{
void
Extend(LumenComponent & component, const VoxelRun & run, int j, int k, const itk::Index<3> & origin)
{
  const itk::Index<3> first = { { origin[0] + run.begin, origin[1] + j, origin[2] + k } };
  const itk::Index<3> last = { { origin[0] + run.end - 1, first[1], first[2] } };
  for (unsigned int a = 0; a < 3; ++a)
  {
    component.first[a] = component.voxels == 0 ? first[a] : std::min(component.first[a], first[a]);
    component.last[a] = component.voxels == 0 ? last[a] : std::max(component.last[a], last[a]);
  }
  component.voxels += run.end - run.begin;
}
} // namespace

LumenComponents
FindLumenComponents(const LumenMask * lumen, const itk::ImageRegion<3> & region)
{
  const auto size = region.GetSize();
  const auto rowOfLumen = [&](int j, int k) {
    const unsigned char * row =
      lumen->GetBufferPointer() +
      lumen->ComputeOffset(itk::Index<3>{ { region.GetIndex(0), region.GetIndex(1) + j, region.GetIndex(2) + k } });
    return [row](int i) { return row[i] != 0; };
  };
  const VoxelGrid             grid(static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]));
  const VoxelRuns             runs = CollectRunsOfRows(grid.size, rowOfLumen);
  const RunLabels             labels = LabelRuns(runs);
  std::vector<LumenComponent> found(labels.number);
  ForEachRun(runs, [&](std::size_t r, int j, int k) {
    Extend(found[labels.ofRun[r] - 1], runs.runs[r], j, k, region.GetIndex());
  });
  std::vector<std::size_t> order(found.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return found[a].voxels > found[b].voxels; });

  LumenComponents           result;
  std::vector<std::int32_t> labelOf(found.size());
  const auto                spacing = lumen->GetSpacing();
  for (const std::size_t component : order)
  {
    labelOf[component] = static_cast<std::int32_t>(result.components.size()) + 1;
    result.components.push_back(found[component]);
    result.components.back().volume = 1e-3 * spacing[0] * spacing[1] * spacing[2] * found[component].voxels;
  }
  result.labels = LumenLabelImage::New();
  result.labels->SetRegions(region);
  result.labels->SetSpacing(spacing);
  result.labels->SetOrigin(lumen->GetOrigin());
  result.labels->SetDirection(lumen->GetDirection());
  result.labels->Allocate(true);
  ForEachRun(runs, [&](std::size_t r, int j, int k) {
    std::int32_t * const row = result.labels->GetBufferPointer() + grid.Index(0, j, k);
    std::fill(row + runs.runs[r].begin, row + runs.runs[r].end, labelOf[labels.ofRun[r] - 1]);
  });
  return result;
}
} // namespace shapeton
