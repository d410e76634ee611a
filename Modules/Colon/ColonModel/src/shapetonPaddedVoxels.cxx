#include "shapetonPaddedVoxels.h"

namespace shapeton
{
VoxelComponents
FindComponents(const PaddedVoxels & voxels, unsigned char flag, bool isSet, VoxelContact contact)
{
  VoxelComponents found;
  found.runs = CollectRuns(voxels.grid, [&](std::size_t p) { return ((voxels.flags[p] & flag) != 0) == isSet; });
  found.labels = LabelRuns(found.runs, contact);
  found.sizes.assign(found.labels.number + 1, 0);
  for (std::size_t r = 0; r < found.runs.runs.size(); ++r)
  {
    found.sizes[found.labels.ofRun[r]] += found.runs.runs[r].end - found.runs.runs[r].begin;
  }
  return found;
}
} // namespace shapeton
