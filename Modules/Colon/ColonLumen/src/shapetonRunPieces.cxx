#include "shapetonRunPieces.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
std::vector<RunPiece>
PiecesOfRuns(const VoxelRuns & set, const RunLabels & labels)
{
  std::vector<RunPiece> pieces(labels.number + 1);
  ForEachRun(set, [&](std::size_t r, int j, int k) {
    auto &         piece = pieces[labels.ofRun[r]];
    const VoxelRun run = set.runs[r];
    const auto     low = std::array<int, 3>{ { run.begin, j, k } };
    const auto     high = std::array<int, 3>{ { run.end, j + 1, k + 1 } };
    for (int a = 0; a < 3; ++a)
    {
      piece.box.low[a] = piece.voxels == 0 ? low[a] : std::min(piece.box.low[a], low[a]);
      piece.box.high[a] = piece.voxels == 0 ? high[a] : std::max(piece.box.high[a], high[a]);
    }
    piece.voxels += run.end - run.begin;
  });
  return pieces;
}

std::vector<unsigned char>
MaskOfRuns(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, int label, const VoxelBox & box)
{
  const ColonGrid            part = grid.Part(box);
  std::vector<unsigned char> mask(part.NumberOfVoxels(), 0);
  ParallelFor(part.size[2], [&](std::size_t layer) {
    const int k = static_cast<int>(layer) + box.low[2];
    for (int j = box.low[1]; j < box.high[1]; ++j)
    {
      const auto row = set.Row(j, k);
      for (auto r = set.firstOfRow[row]; r < set.firstOfRow[row + 1]; ++r)
      {
        if (labels.ofRun[r] == label)
        {
          auto * first = &mask[part.Index(0, j - box.low[1], static_cast<int>(layer))];
          std::fill(first + set.runs[r].begin - box.low[0], first + set.runs[r].end - box.low[0], 1);
        }
      }
    }
  });
  return mask;
}

DeepestVoxel
FindDeepestVoxel(const ColonGrid & grid,
                 const VoxelRuns & set,
                 const RunLabels & labels,
                 int               label,
                 const RunPiece &  piece)
{
  const VoxelBox  box = grid.Widened(piece.box, 1e-6);
  const ColonGrid part = grid.Part(box);
  const auto      distance = SquaredDistanceToBackground(part, MaskOfRuns(grid, set, labels, label, box));
  const auto      place = std::max_element(distance.begin(), distance.end());
  DeepestVoxel    deepest;
  // A piece that fills its whole box has no background at all.
  deepest.radius = std::sqrt(std::min(*place, 1e6F));
  deepest.voxel = part.Voxel(static_cast<std::size_t>(place - distance.begin()));
  for (int a = 0; a < 3; ++a)
  {
    deepest.voxel[a] += box.low[a];
  }
  return deepest;
}
} // namespace shapeton
