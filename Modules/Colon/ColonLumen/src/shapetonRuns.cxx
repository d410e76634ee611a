#include "shapetonRuns.h"

#include "shapetonDisjointSets.h"

namespace shapeton
{
std::ptrdiff_t
RunSet::Find(int i, int j, int k) const
{
  const auto row = this->Row(j, k);
  const auto begin = runs.begin() + firstOfRow[row];
  const auto end = runs.begin() + firstOfRow[row + 1];
  const auto after = std::upper_bound(begin, end, i, [](int value, const Run & run) { return value < run.begin; });
  return after != begin && i < (after - 1)->end ? after - 1 - runs.begin() : -1;
}

RunLabels
LabelRuns(const RunSet & set, bool acrossSlices, const std::vector<char> & use)
{
  DisjointSets sets(set.runs.size());
  const auto   unite = [&](std::size_t r, std::size_t s, int) {
    if (use.empty() || (use[r] && use[s]))
    {
      sets.Join(static_cast<int>(r), static_cast<int>(s));
    }
  };
  for (int k = 0; k < set.size[2]; ++k)
  {
    for (int j = 0; j < set.size[1]; ++j)
    {
      if (j > 0)
      {
        ForEachOverlap(set, set.Row(j - 1, k), set.Row(j, k), unite);
      }
      if (acrossSlices && k > 0)
      {
        ForEachOverlap(set, set.Row(j, k - 1), set.Row(j, k), unite);
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
