#include "shapetonHeatSeeds.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"
#include "shapetonVoxelRuns.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace shapeton
{
namespace
{
/** Marks the voxels of a set, excluding its border unless it consists of border voxels only. */
void
MarkInside(const VoxelGrid &                grid,
           const std::vector<std::size_t> & voxels,
           const std::vector<int> &         part,
           int                              of,
           unsigned short                   label,
           unsigned short *                 seeds)
{
  std::vector<std::size_t> inside;
  std::copy_if(voxels.begin(), voxels.end(), std::back_inserter(inside), [&](std::size_t voxel) {
    bool isInside = true;
    ForEachNeighbor(grid, voxel, [&](std::size_t neighbor) { isInside &= part[neighbor] == of; });
    return isInside;
  });
  for (const std::size_t voxel : inside.empty() ? voxels : inside)
  {
    seeds[voxel] = label;
  }
}

/** The voxels of each label from 1 to `number`. */
std::vector<std::vector<std::size_t>>
VoxelsOf(const std::vector<int> & part, int number)
{
  std::vector<std::vector<std::size_t>> voxels(static_cast<std::size_t>(number));
  for (std::size_t i = 0; i < part.size(); ++i)
  {
    if (part[i] > 0)
    {
      voxels[static_cast<std::size_t>(part[i]) - 1].push_back(i);
    }
  }
  return voxels;
}

/** The number (1, 2, ...) of the part that contains each voxel of one class; the parts are the class itself or its
 * components. */
std::vector<int>
PartsOfClass(const VoxelGrid & grid, const unsigned short * classes, int value, bool byComponent, int & number)
{
  const auto       isIn = [&](std::size_t voxel) { return classes[voxel] == value; };
  std::vector<int> part(grid.NumberOfVoxels(), 0);
  const VoxelRuns  runs = CollectRuns(grid, isIn);
  const RunLabels  labels = byComponent ? LabelRuns(runs) : RunLabels{ std::vector<int>(runs.runs.size(), 1), 1 };
  for (int k = 0; k < grid.size[2]; ++k)
  {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      for (std::size_t r = runs.firstOfRow[runs.Row(j, k)]; r < runs.firstOfRow[runs.Row(j, k) + 1]; ++r)
      {
        std::fill(part.begin() + static_cast<std::ptrdiff_t>(grid.Index(runs.runs[r].begin, j, k)),
                  part.begin() + static_cast<std::ptrdiff_t>(grid.Index(runs.runs[r].end - 1, j, k)) + 1,
                  labels.ofRun[r]);
      }
    }
  }
  number = runs.runs.empty() ? 0 : labels.number;
  return part;
}

std::vector<int>
ChosenClasses(const SeedImage * classes, const ClassSeeds & choice)
{
  const unsigned short * const begin = classes->GetBufferPointer();
  const std::set<int>          present(begin, begin + classes->GetLargestPossibleRegion().GetNumberOfPixels());
  RequireParameter(std::set<int>(choice.classes.begin(), choice.classes.end()).size() == choice.classes.size(),
                   "the parameter \"classes\" has a class twice");
  for (const int value : choice.classes)
  {
    if (present.count(value) == 0)
    {
      throw InputError("class " + std::to_string(value) + " has no voxel; choose classes of the label map");
    }
  }
  std::vector<int> chosen = choice.classes;
  if (chosen.empty())
  {
    std::copy_if(present.begin(), present.end(), std::back_inserter(chosen), [](int value) { return value != 0; });
  }
  return chosen;
}
} // namespace

SeedImage::Pointer
SeedsOfClasses(const SeedImage * classes, const ClassSeeds & choice)
{
  RequireParameter(choice.components >= 0, "the parameter \"components\" must not be negative");
  const VoxelGrid grid = GridOf(classes);
  const auto      seeds = NewImageOn<SeedImage>(classes, true);
  unsigned short  label = 0;
  for (const int value : ChosenClasses(classes, choice))
  {
    int              number = 0;
    const auto       part = PartsOfClass(grid, classes->GetBufferPointer(), value, choice.components > 0, number);
    const auto       voxels = VoxelsOf(part, number);
    std::vector<int> order(voxels.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return voxels[a].size() > voxels[b].size(); });
    order.resize(std::min<std::size_t>(order.size(), static_cast<std::size_t>(std::max(1, choice.components))));
    for (const int i : order)
    {
      MarkInside(grid, voxels[i], part, i + 1, ++label, seeds->GetBufferPointer());
    }
  }
  return seeds;
}
} // namespace shapeton
