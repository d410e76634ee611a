#include "shapetonLumenDistance.h"

#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <numeric>

namespace shapeton
{
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
