#include "shapetonVoxelRuns.h"

#include "shapetonDisjointSets.h"
#include "shapetonInterruption.h"

namespace shapeton
{
std::ptrdiff_t
VoxelRuns::Find(int i, int j, int k) const
{
  const auto row = this->Row(j, k);
  const auto begin = runs.begin() + firstOfRow[row];
  const auto end = runs.begin() + firstOfRow[row + 1];
  const auto after = std::upper_bound(begin, end, i, [](int value, const VoxelRun & run) { return value < run.begin; });
  return after != begin && i < (after - 1)->end ? after - 1 - runs.begin() : -1;
}

RunLabels
LabelRuns(const VoxelRuns & set, VoxelContact contact, const std::vector<char> & use)
{
  DisjointSets sets(set.runs.size());
  const auto   joinRows = [&](int j, int k, int otherJ, int otherK, int reach) {
    if (otherJ < 0 || otherK < 0 || otherJ >= set.size[1])
    {
      return;
    }
    const auto join = [&](std::size_t r, std::size_t s, int) {
      if (use.empty() || (use[r] && use[s]))
      {
        sets.Join(static_cast<int>(r), static_cast<int>(s));
      }
    };
    ForEachOverlap(set, set.Row(otherJ, otherK), set.Row(j, k), join, reach);
  };
  const bool throughEdges = contact == VoxelContact::FaceOrEdge;
  for (int k = 0; k < set.size[2]; ++k)
  {
    Interruption::Check();
    for (int j = 0; j < set.size[1]; ++j)
    {
      joinRows(j, k, j - 1, k, throughEdges ? 1 : 0);
      if (contact != VoxelContact::FaceInSlice)
      {
        joinRows(j, k, j, k - 1, throughEdges ? 1 : 0);
      }
      if (throughEdges)
      {
        joinRows(j, k, j - 1, k - 1, 0);
        joinRows(j, k, j + 1, k - 1, 0);
      }
    }
  }
  RunLabels labels;
  labels.ofRun.assign(set.runs.size(), 0);
  for (std::size_t r = 0; r < set.runs.size(); ++r)
  {
    if (use.empty() || use[r])
    {
      const auto first = static_cast<std::size_t>(sets.Find(static_cast<int>(r)));
      labels.ofRun[r] = first == r ? ++labels.number : labels.ofRun[first];
    }
  }
  return labels;
}
} // namespace shapeton
