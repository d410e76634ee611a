#ifndef shapetonRuns_h
#define shapetonRuns_h

#include "shapetonColonVolume.h"
#include "shapetonParallelFor.h"

namespace shapeton
{
/** Voxels [begin, end) of one row. */
struct Run
{
  int begin, end;
};

/** A set of voxels as runs along the first axis, row by row. */
struct RunSet
{
  std::array<int, 3>       size{ { 0, 0, 0 } };
  std::vector<Run>         runs;
  std::vector<std::size_t> firstOfRow; ///< size[1] * size[2] + 1 entries

  std::size_t
  Row(int j, int k) const
  {
    return j + static_cast<std::size_t>(k) * size[1];
  }
  /** The run that holds a voxel; -1 where there is none. */
  std::ptrdiff_t
  Find(int i, int j, int k) const;
};

/** A number from 1 on for each run, in the order of the first runs; 0 for a run that takes no part. */
struct RunLabels
{
  std::vector<int> ofRun;
  int              number{ 0 };
};

/** Connected components: voxels that share a face. Only runs with a true entry in `use` take part, where it is not
 * empty. Without `acrossSlices` each slice is on its own. */
RunLabels
LabelRuns(const RunSet & set, bool acrossSlices, const std::vector<char> & use = {});

/** Calls `body(r, s, overlap)` for each pair of runs of two rows that share columns, `overlap` of them. */
template <typename TBody>
void
ForEachOverlap(const RunSet & set, std::size_t rowA, std::size_t rowB, const TBody & body)
{
  std::size_t a = set.firstOfRow[rowA];
  std::size_t b = set.firstOfRow[rowB];
  while (a < set.firstOfRow[rowA + 1] && b < set.firstOfRow[rowB + 1])
  {
    const int overlap = std::min(set.runs[a].end, set.runs[b].end) - std::max(set.runs[a].begin, set.runs[b].begin);
    if (overlap > 0)
    {
      body(a, b, overlap);
    }
    (set.runs[a].end < set.runs[b].end ? a : b)++;
  }
}

/** Calls `body(run, j, k)` for all runs in order. */
template <typename TBody>
void
ForEachRun(const RunSet & set, const TBody & body)
{
  for (int k = 0; k < set.size[2]; ++k)
  {
    for (int j = 0; j < set.size[1]; ++j)
    {
      const auto row = set.Row(j, k);
      for (auto r = set.firstOfRow[row]; r < set.firstOfRow[row + 1]; ++r)
      {
        body(r, j, k);
      }
    }
  }
}

/** The voxels for whose index `isIn` holds. */
template <typename TPredicate>
RunSet
CollectRuns(const ColonGrid & grid, const TPredicate & isIn)
{
  RunSet set;
  set.size = grid.size;
  std::vector<std::vector<Run>>         runsOfSlice(grid.size[2]);
  std::vector<std::vector<std::size_t>> endsOfSlice(grid.size[2]);
  ParallelFor(grid.size[2], [&](std::size_t k) {
    auto & runs = runsOfSlice[k];
    for (int j = 0; j < grid.size[1]; ++j)
    {
      const std::size_t row = grid.Index(0, j, static_cast<int>(k));
      for (int i = 0; i < grid.size[0]; ++i)
      {
        if (isIn(row + i))
        {
          const int begin = i;
          while (i < grid.size[0] && isIn(row + i))
          {
            ++i;
          }
          runs.push_back({ begin, i });
        }
      }
      endsOfSlice[k].push_back(runs.size());
    }
  });
  set.firstOfRow.assign(1, 0);
  for (int k = 0; k < grid.size[2]; ++k)
  {
    const auto before = set.runs.size();
    set.runs.insert(set.runs.end(), runsOfSlice[k].begin(), runsOfSlice[k].end());
    for (const auto end : endsOfSlice[k])
    {
      set.firstOfRow.push_back(before + end);
    }
  }
  return set;
}
} // namespace shapeton

#endif
