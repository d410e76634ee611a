#include "shapetonLabelShapes.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonNumberText.h"

#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr int MostLabels = 65536; // of unsigned 16-bit label maps

/** The runs with this label. */
VoxelRuns
Part(const VoxelRuns & shape, const RunLabels & numbers, int number)
{
  VoxelRuns part;
  part.size = shape.size;
  part.firstOfRow.reserve(shape.firstOfRow.size());
  part.firstOfRow.push_back(0);
  for (std::size_t row = 0; row + 1 < shape.firstOfRow.size(); ++row)
  {
    for (std::size_t run = shape.firstOfRow[row]; run < shape.firstOfRow[row + 1]; ++run)
    {
      if (numbers.ofRun[run] == number)
      {
        part.runs.push_back(shape.runs[run]);
      }
    }
    part.firstOfRow.push_back(part.runs.size());
  }
  return part;
}
} // namespace

std::vector<int>
LabelsOf(const LabelMap * labels)
{
  const float *     values = labels->GetBufferPointer();
  const std::size_t voxels = labels->GetBufferedRegion().GetNumberOfPixels();
  std::vector<char> isThere(MostLabels, 0);
  for (std::size_t i = 0; i < voxels; ++i)
  {
    if (!(values[i] >= 0.0F && values[i] < MostLabels && values[i] == std::floor(values[i])))
    {
      throw InputError("a voxel has the value " + NumberText(values[i]) +
                       "; labels must be integers from 0 to 65535; use a label map");
    }
    isThere[static_cast<std::size_t>(values[i])] = 1;
  }
  std::vector<int> found;
  for (int label = 1; label < MostLabels; ++label)
  {
    if (isThere[label] != 0)
    {
      found.push_back(label);
    }
  }
  if (found.empty())
  {
    throw InputError("all voxels are 0: the label map has no label");
  }
  return found;
}

VoxelRuns
VoxelsOfLabel(const LabelMap * labels, int label)
{
  const float * values = labels->GetBufferPointer();
  const auto    wanted = static_cast<float>(label);
  return CollectRuns(GridOf(labels), [=](std::size_t index) { return values[index] == wanted; });
}

std::size_t
CountVoxels(const VoxelRuns & shape)
{
  return std::accumulate(
    shape.runs.begin(), shape.runs.end(), std::size_t{ 0 }, [](std::size_t sum, const VoxelRun & run) {
      return sum + static_cast<std::size_t>(run.end - run.begin);
    });
}

std::vector<VoxelRuns>
ComponentsOf(const VoxelRuns & shape, std::size_t leastVoxels)
{
  const RunLabels          numbers = LabelRuns(shape);
  std::vector<std::size_t> voxels(numbers.number + 1, 0);
  for (std::size_t run = 0; run < shape.runs.size(); ++run)
  {
    voxels[numbers.ofRun[run]] += shape.runs[run].end - shape.runs[run].begin;
  }
  std::vector<int> order(numbers.number);
  std::iota(order.begin(), order.end(), 1);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return voxels[a] > voxels[b]; });
  std::vector<VoxelRuns> components;
  for (const int number : order)
  {
    if (voxels[number] >= leastVoxels)
    {
      components.push_back(Part(shape, numbers, number));
    }
  }
  return components;
}
} // namespace shapeton
