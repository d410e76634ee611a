#ifndef shapetonVoxelRuns_h
#define shapetonVoxelRuns_h

#include "shapetonParallelFor.h"
#include "shapetonVoxelGrid.h"
#include "ShapetonCommonExport.h"

#include <algorithm>
#include <vector>

namespace shapeton
{
/** Voxels [begin, end) of one row. \ingroup ShapetonCommon */
struct VoxelRun
{
  int begin, end;
};

/** \class VoxelRuns
 * \brief A set of voxels as run-length-encoded rows along the first axis.
 *
 * \ingroup ShapetonCommon */
struct ShapetonCommon_EXPORT VoxelRuns
{
  std::array<int, 3>       size{ { 0, 0, 0 } };
  std::vector<VoxelRun>    runs;
  std::vector<std::size_t> firstOfRow; ///< size[1] * size[2] + 1 entries

  std::size_t
  Row(int j, int k) const
  {
    return j + static_cast<std::size_t>(k) * size[1];
  }
  /** Index of the run that contains a voxel; -1 if not found. */
  std::ptrdiff_t
  Find(int i, int j, int k) const;
};

/** Label of each run, from 1 in the order of the first runs; 0 for an excluded run. \ingroup ShapetonCommon */
struct RunLabels
{
  std::vector<int> ofRun;
  int              number{ 0 };
};

/** Voxel connectivity: by faces, by faces within a slice, or by faces and edges.
 * \ingroup ShapetonCommon */
enum class VoxelContact
{
  Face,
  FaceInSlice,
  FaceOrEdge
};

/** Connected components. If `use` is not empty, only runs with a true entry are labeled. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT RunLabels
LabelRuns(const VoxelRuns & set, VoxelContact contact = VoxelContact::Face, const std::vector<char> & use = {});

/** Calls `body(r, s, overlap)` for each pair of runs of two rows that share `overlap` columns. With `reach` 1, also
 * includes runs that touch at a corner, with an overlap of 0. \ingroup ShapetonCommon */
template <typename TBody>
void
ForEachOverlap(const VoxelRuns & set, std::size_t rowA, std::size_t rowB, const TBody & body, int reach = 0)
{
  std::size_t a = set.firstOfRow[rowA];
  std::size_t b = set.firstOfRow[rowB];
  while (a < set.firstOfRow[rowA + 1] && b < set.firstOfRow[rowB + 1])
  {
    const int overlap = std::min(set.runs[a].end, set.runs[b].end) - std::max(set.runs[a].begin, set.runs[b].begin);
    if (overlap > -reach)
    {
      body(a, b, overlap);
    }
    (set.runs[a].end < set.runs[b].end ? a : b)++;
  }
}

/** Calls `body(run, j, k)` for all runs in order. \ingroup ShapetonCommon */
template <typename TBody>
void
ForEachRun(const VoxelRuns & set, const TBody & body)
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

/** Collects the voxels for which the predicate over i returned by `row(j, k)` holds; each slice is processed by one
 * thread.
 * \ingroup ShapetonCommon */
template <typename TRow>
VoxelRuns
CollectRunsOfRows(const std::array<int, 3> & size, const TRow & row)
{
  VoxelRuns set;
  set.size = size;
  std::vector<std::vector<VoxelRun>>    runsOfSlice(size[2]);
  std::vector<std::vector<std::size_t>> endsOfSlice(size[2]);
  ParallelFor(size[2], [&](std::size_t k) {
    auto & runs = runsOfSlice[k];
    for (int j = 0; j < size[1]; ++j)
    {
      const auto isIn = row(j, static_cast<int>(k));
      for (int i = 0; i < size[0]; ++i)
      {
        if (isIn(i))
        {
          const int begin = i;
          while (i < size[0] && isIn(i))
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
  for (int k = 0; k < size[2]; ++k)
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

/** Collects the voxels whose index satisfies `isIn`. \ingroup ShapetonCommon */
template <typename TPredicate>
VoxelRuns
CollectRuns(const VoxelGrid & grid, const TPredicate & isIn)
{
  return CollectRunsOfRows(
    grid.size, [&](int j, int k) { return [&isIn, row = grid.Index(0, j, k)](int i) { return isIn(row + i); }; });
}
} // namespace shapeton

#endif
