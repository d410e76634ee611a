#include "itkLoopCuts.h"

#include "itkPieceOrder.h"

#include <algorithm>

namespace itk
{
namespace
{
constexpr int mostCuts = 6;
/** mm that a cut must save. */
constexpr double leastSaving = 40.0;
/** Side branches of this length (mm) and more are no haustra. */
constexpr double shortestBranch = 40.0;
/** mm^3; what is smaller does not matter to the layout. */
constexpr double smallestPiece = 5e3;
/** mm^3 of a stretch of colon. */
constexpr double smallestStretch = 20e3;

Eigen::Vector3d
EndDirection(const LumenGrid & grid, const LumenCells & cells, const std::vector<int> & way)
{
  const std::size_t     back = std::min<std::size_t>(way.size() - 1, 2);
  const Eigen::Vector3d out =
    grid.ToPhysical(cells.positions[way.back()]) - grid.ToPhysical(cells.positions[way[way.size() - 1 - back]]);
  return out.norm() > 0.0 ? Eigen::Vector3d(out.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

/** The end of a way, moved from the centre of its last ball to the wall. */
JoinEnd
EndOf(const LumenGrid & grid, const LumenCells & cells, const std::vector<int> & way)
{
  const Eigen::Vector3d out = EndDirection(grid, cells, way);
  return { grid.ToPhysical(cells.positions[way.back()]) + cells.radii[way.back()] * out, out };
}

struct Layout
{
  std::vector<JoinPiece> pieces;
  double                 sideBranches{ 0.0 };
};

Layout
LayOut(const LumenGrid & grid, const LumenCells & cells, const CellTree & tree)
{
  const std::vector<int> groups = tree.Groups();
  std::vector<double>    volumes(groups.size(), 0.0);
  for (std::size_t cell = 0; cell < groups.size(); ++cell)
  {
    volumes[groups[cell]] += cells.volumes[cell];
  }
  Layout layout;
  for (int first = 0; first < cells.NumberOfCells(); ++first)
  {
    if (volumes[first] < smallestPiece)
    {
      continue;
    }
    const auto       ends = tree.Ends(first);
    std::vector<int> way = tree.Way(ends[0], ends[1]);
    JoinPiece        piece;
    piece.ends[1] = EndOf(grid, cells, way);
    for (std::size_t i = 1; i < way.size(); ++i)
    {
      piece.length += (cells.positions[way[i]] - cells.positions[way[i - 1]]).norm();
    }
    layout.sideBranches += tree.SideBranches(way, shortestBranch);
    std::reverse(way.begin(), way.end());
    piece.ends[0] = EndOf(grid, cells, way);
    layout.pieces.push_back(piece);
  }
  return layout;
}

/** mm of joins, of what is left out and of side branches. */
double
LayoutCost(const LumenGrid & grid, const LumenCells & cells, const CellTree & tree)
{
  const Layout layout = LayOut(grid, cells, tree);
  if (layout.pieces.size() > static_cast<std::size_t>(mostJoinPieces))
  {
    return 1e9;
  }
  Eigen::Vector3d lowest = grid.ToPhysical(cells.positions[0]);
  Eigen::Vector3d highest = lowest;
  for (const Eigen::Vector3d & position : cells.positions)
  {
    lowest = lowest.cwiseMin(grid.ToPhysical(position));
    highest = highest.cwiseMax(grid.ToPhysical(position));
  }
  double joins = 0.0;
  if (layout.pieces.empty())
  {
    return joins;
  }
  OrderPieces(layout.pieces, FindRectum(layout.pieces, lowest, highest), &joins);
  return joins + layout.sideBranches;
}
} // namespace

std::vector<int>
CutLoops(const LumenGrid & grid, const LumenCells & cells, CellTree & tree)
{
  std::vector<int> cuts;
  double           cost = LayoutCost(grid, cells, tree);
  while (static_cast<int>(cuts.size()) < mostCuts)
  {
    double least = cost - leastSaving;
    int    best = -1;
    for (const CellTree::Neck & neck : tree.Necks())
    {
      if (neck.volume < smallestStretch)
      {
        continue;
      }
      tree.Cut(neck.passage);
      const double without = LayoutCost(grid, cells, tree);
      tree.Mend(neck.passage);
      if (without < least)
      {
        least = without;
        best = neck.passage;
      }
    }
    if (best < 0)
    {
      break;
    }
    tree.Cut(best);
    cuts.push_back(best);
    cost = least;
  }
  return cuts;
}
} // namespace itk
