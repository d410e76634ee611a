#include "shapetonLoopCuts.h"

#include "shapetonInterruption.h"
#include "shapetonPieceOrder.h"

#include <algorithm>
#include <functional>

namespace shapeton
{
namespace
{
/** Maximum number of cuts; chosen to limit the run time. */
constexpr int mostCuts = 6;
/** Penalty (mm) for a path through a hole in a septum; less than CellTree::LeastGain. */
constexpr double holeCost = 35.0;
/** Colons have up to about 20 candidates; the bound limits the time for input that is not a lumen. */
constexpr std::size_t mostTrials = 100;
/** Number of the best single cuts that are tried in pairs. */
constexpr std::size_t pairedCuts = 10;
/** Cost (mm) of a layout with too many pieces to order; higher than that of any other layout. */
constexpr double costOfTooManyPieces = 1e9;
/** Minimum volume (mm^3) of a piece that affects the layout. */
constexpr double smallestPiece = 5e3;
/** Minimum volume of a stretch of colon, mm^3. */
constexpr double smallestStretch = 20e3;

Eigen::Vector3d
EndDirection(const LumenGrid & grid, const LumenCells & cells, const std::vector<int> & way)
{
  const std::size_t     back = std::min<std::size_t>(way.size() - 1, 2);
  const Eigen::Vector3d out =
    grid.ToPhysical(cells.positions[way.back()]) - grid.ToPhysical(cells.positions[way[way.size() - 1 - back]]);
  return out.norm() > 0.0 ? Eigen::Vector3d(out.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

/** The end of a path, moved from the center of its last ball to the wall. */
JoinEnd
EndOf(const LumenGrid & grid, const LumenCells & cells, const std::vector<int> & way)
{
  const Eigen::Vector3d out = EndDirection(grid, cells, way);
  JoinEnd               end;
  end.position = grid.ToPhysical(cells.positions[way.back()]) + cells.radii[way.back()] * out;
  end.out = out;
  std::vector<Eigen::Vector3d> points;
  std::vector<double>          radii;
  for (const int cell : way)
  {
    points.push_back(cells.positions[cell]);
    radii.push_back(cells.radii[cell]);
  }
  end.radius = RadiusNearEnd(points, radii);
  return end;
}

struct Layout
{
  std::vector<JoinPiece> pieces;
  /** Penalties for side branches and holes, mm. */
  double faults{ 0.0 };
};

Layout
LayOut(const LumenGrid & grid, const LumenCells & cells, const CellTree & tree, double area)
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
    layout.faults += tree.SideBranches(way, area) + holeCost * tree.Holes(way);
    std::reverse(way.begin(), way.end());
    piece.ends[0] = EndOf(grid, cells, way);
    layout.pieces.push_back(piece);
  }
  return layout;
}

/** Evaluates cuts. The cost (mm) of the resulting colon is the sum of the costs of joins, omitted pieces, side branches
 * and holes, plus the excess distance of its start from the anus. */
class CutSearch
{
public:
  CutSearch(const LumenGrid & grid, const LumenCells & cells, CellTree & tree)
    : m_Grid(grid), m_Cells(cells), m_Tree(tree), m_UsualRadius(cells.UsualRadius())
  {
    for (const Eigen::Vector3d & position : cells.positions)
    {
      m_Extent.Include(grid.ToPhysical(position));
    }
    for (const Eigen::Vector3d & position : cells.positions)
    {
      m_NearestToAnus = std::min(m_NearestToAnus, m_Extent.DistanceFromAnus(grid.ToPhysical(position)));
    }
  }

  double
  Cost() const
  {
    // Approximate cross-section of the lumen including its haustra.
    const double area = 4.0 * m_UsualRadius * m_UsualRadius;
    const Layout layout = LayOut(m_Grid, m_Cells, m_Tree, area);
    if (layout.pieces.size() > static_cast<std::size_t>(mostJoinPieces))
    {
      return costOfTooManyPieces;
    }
    if (layout.pieces.empty())
    {
      return 0.0;
    }
    std::vector<JoinPiece> pieces = layout.pieces;
    PreferCecum(m_Extent, m_UsualRadius, pieces);
    const PlacedPiece     rectum = FindRectum(pieces, m_Extent);
    const Eigen::Vector3d begin = pieces[rectum.piece].ends[rectum.isReversed ? 1 : 0].position;
    double                joins = 0.0;
    OrderPieces(pieces, rectum, &joins);
    return joins + layout.faults + std::max(0.0, m_Extent.DistanceFromAnus(begin) - m_NearestToAnus);
  }

  /** One or two cuts, and the resulting cost including the minimum gain for each cut. */
  struct Trial
  {
    double           cost;
    std::vector<int> passages;
  };

  /** The best cut, or the best pair if no single cut reduces the cost enough; empty if no pair is sufficient either. */
  Trial
  Best()
  {
    const double       before = this->Cost();
    std::vector<Trial> singles;
    for (const int passage : this->Passages())
    {
      Interruption::Check();
      singles.push_back(this->Try({ passage }));
    }
    std::stable_sort(singles.begin(), singles.end(), [](const Trial & a, const Trial & b) { return a.cost < b.cost; });
    Trial best{ before, {} };
    best = !singles.empty() && singles[0].cost < before ? singles[0] : best;
    singles.resize(std::min(singles.size(), pairedCuts));
    for (std::size_t i = 0; best.passages.empty() && i < singles.size(); ++i)
    {
      for (std::size_t k = i + 1; k < singles.size(); ++k)
      {
        Trial pair = this->Try({ singles[i].passages[0], singles[k].passages[0] });
        best = pair.cost < best.cost ? pair : best;
      }
    }
    return best;
  }

private:
  /** Passages that separate two stretches of colon; if there are too many, only the narrowest. */
  std::vector<int>
  Passages() const
  {
    std::vector<int> passages;
    for (const CellTree::Neck & neck : m_Tree.Necks())
    {
      if (neck.volume >= smallestStretch)
      {
        passages.push_back(neck.passage);
      }
    }
    if (passages.size() > mostTrials)
    {
      // A lower index means a wider passage.
      std::sort(passages.begin(), passages.end(), std::greater<>());
      passages.resize(mostTrials);
    }
    return passages;
  }

  Trial
  Try(const std::vector<int> & passages)
  {
    double least = 0.0;
    for (const int passage : passages)
    {
      least += m_Tree.LeastGain(passage);
      m_Tree.Cut(passage);
    }
    const double cost = this->Cost() + least;
    for (const int passage : passages)
    {
      m_Tree.Mend(passage);
    }
    return { cost, passages };
  }

  const LumenGrid &  m_Grid;
  const LumenCells & m_Cells;
  CellTree &         m_Tree;
  double             m_UsualRadius;
  ColonExtent        m_Extent;
  /** Minimum over the whole lumen. */
  double m_NearestToAnus{ 1e30 };
};
} // namespace

std::vector<int>
CutLoops(const LumenGrid & grid, const LumenCells & cells, CellTree & tree)
{
  std::vector<int> cuts;
  CutSearch        search(grid, cells, tree);
  while (static_cast<int>(cuts.size()) < mostCuts)
  {
    Interruption::Check();
    const auto best = search.Best();
    if (best.passages.empty())
    {
      break;
    }
    for (const int passage : best.passages)
    {
      tree.Cut(passage);
      cuts.push_back(passage);
    }
  }
  return cuts;
}
} // namespace shapeton
