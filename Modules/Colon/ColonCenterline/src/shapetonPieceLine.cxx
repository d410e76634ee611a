#include "shapetonPieceLine.h"

#include "shapetonLoopCuts.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Maximum radius (mm) of side branches, the terminal ileum and tapers; the ends of a piece are wider. */
constexpr double widestCore = 8.0;
/** Minimum core radius of narrower pieces, relative to the largest radius. */
constexpr double coreShare = 0.75;
/** Length of rectum and anal canal, mm. */
constexpr double rectumLength = 120.0;
/** Tapers are followed down to this radius, mm. */
constexpr double narrowestTaper = 1.0;
/** Maximum distance from the wall (mm) and maximum number of candidate tips. */
constexpr double      atWall = 3.5;
constexpr std::size_t mostTips = 60;
/** Candidate tips are at most tipCalibers calibers nearer than the farthest one. The caliber is the largest distance
 * from the wall (mm) of the last endNodes nodes of the core, but at least leastCaliber. */
constexpr double      tipCalibers = 1.2;
constexpr std::size_t endNodes = 30;
constexpr double      leastCaliber = 10.0;

/** The node with the longest path among those at least leastDistance from the wall; the start if there are none. */
int
FarthestNode(const LumenGrid & grid, const PathTree & paths, double leastDistance)
{
  int farthest = paths.order.front();
  for (const int node : paths.order)
  {
    if (grid.Distance(node) >= leastDistance && paths.lengths[node] > paths.lengths[farthest])
    {
      farthest = node;
    }
  }
  return farthest;
}

/** For each node, the index (in the core) of the last core node on its path; -1 if there is none. */
std::vector<int>
BranchIndices(const LumenGrid & grid, const PathTree & paths, const std::vector<int> & core)
{
  std::vector<int> branch(grid.NumberOfNodes(), -1);
  for (int i = 0; i < static_cast<int>(core.size()); ++i)
  {
    branch[core[i]] = i;
  }
  for (const int node : paths.order)
  {
    if (branch[node] < 0 && paths.parents[node] >= 0)
    {
      branch[node] = branch[paths.parents[node]];
    }
  }
  return branch;
}

/** The path from the core to a node. */
PieceEnd
EndAt(const PathTree & paths, const std::vector<int> & core, const std::vector<int> & branch, int tip)
{
  PieceEnd end;
  end.branch = branch[tip];
  for (int node = tip; branch[node] < 0 || core[branch[node]] != node; node = paths.parents[node])
  {
    end.nodes.push_back(node);
  }
  std::reverse(end.nodes.begin(), end.nodes.end());
  return end;
}

/** Nodes at the wall whose path is shorter than the longest path by at most tipCalibers calibers. */
std::vector<int>
NodesAtEnd(const LumenGrid &        grid,
           const PathTree &         paths,
           const std::vector<int> & core,
           const std::vector<int> & branch,
           double                   earliest,
           int                      farthest)
{
  double caliber = leastCaliber;
  for (std::size_t i = core.size() - std::min(core.size(), endNodes); i < core.size(); ++i)
  {
    caliber = std::max<double>(caliber, grid.Distance(core[i]));
  }
  std::vector<int> nodes;
  for (const int node : paths.order)
  {
    if (branch[node] >= 0 && grid.Distance(node) >= narrowestTaper && grid.Distance(node) <= atWall &&
        paths.lengths[node] >= paths.lengths[farthest] - tipCalibers * caliber &&
        paths.lengths[core[branch[node]]] >= earliest)
    {
      nodes.push_back(node);
    }
  }
  return nodes;
}

/** Returns candidate tips beyond the last node of the core: the farthest node of a taper first, then nodes near the
 * wall of a blunt end. `paths` starts at the other end of the piece. */
std::vector<PieceEnd>
Prolong(const LumenGrid & grid, const PathTree & paths, const std::vector<int> & core)
{
  const std::vector<int> branch = BranchIndices(grid, paths, core);
  const int              last = static_cast<int>(core.size()) - 1;
  const double           reach = 30.0; // mm; chosen: tips branch off the last part of the core
  const double           earliest = paths.lengths[core[last]] - reach;
  int                    best = core[last];
  for (const int node : paths.order)
  {
    if (branch[node] >= 0 && grid.Distance(node) >= narrowestTaper && paths.lengths[node] > paths.lengths[best] &&
        paths.lengths[core[branch[node]]] >= earliest)
    {
      best = node;
    }
  }
  std::vector<PieceEnd>  tips = { EndAt(paths, core, branch, best) };
  const std::vector<int> nodes = NodesAtEnd(grid, paths, core, branch, earliest, best);
  const std::size_t      stride = nodes.size() / mostTips + 1;
  for (std::size_t i = 0; i < nodes.size(); i += stride)
  {
    tips.push_back(EndAt(paths, core, branch, nodes[i]));
    tips.back().shortfall = paths.lengths[best] - paths.lengths[nodes[i]];
  }
  return tips;
}

/** Core radius of the piece reached by the paths, mm. */
double
CoreRadiusOf(const LumenNetwork & network, const PathTree & piece)
{
  double greatest = 0.0;
  for (const int node : piece.order)
  {
    greatest = std::max<double>(greatest, network.grid.Distance(node));
  }
  return std::min(network.coreRadius, coreShare * greatest);
}

PathTree
Grow(const LumenNetwork & network, int start, int exponent)
{
  return GrowPathTree(network.grid, network.cells, network.tree, start, exponent);
}

PieceLine
TraceBetween(const LumenNetwork & network, int first, bool isFixed, int exponent)
{
  const LumenGrid & grid = network.grid;
  PieceLine         line;
  line.component = grid.Component(first);
  const PathTree   forth = Grow(network, first, exponent);
  const double     coreRadius = CoreRadiusOf(network, forth);
  const int        last = FarthestNode(grid, forth, coreRadius);
  const auto       paths = std::make_shared<const PathTree>(Grow(network, last, exponent));
  const PathTree & back = *paths;
  const int        begin = isFixed ? first : FarthestNode(grid, back, coreRadius);
  line.core = back.PathTo(begin);
  line.tips[1] = isFixed ? std::vector<PieceEnd>{ { static_cast<int>(line.core.size()) - 1, {}, 0.0 } }
                         : Prolong(grid, back, line.core);
  line.ends[1] = line.tips[1].front();
  line.Reverse();
  line.tips[1] = Prolong(grid, forth, line.core);
  line.ends[1] = line.tips[1].front();
  line.volume = grid.NodeVolume() * static_cast<double>(back.order.size());
  line.paths = paths;
  return line;
}

/** The tip of the rectum: a caudal node in the middle of the lumen, with a long path that joins the core near the last
 * core node. */
int
FindTip(const LumenGrid & grid, const PathTree & paths, const std::vector<int> & core)
{
  const std::vector<int> branch = BranchIndices(grid, paths, core);
  const double           earliest = paths.lengths[core.back()] - rectumLength;
  // LPS: z increases toward the head.
  const auto tipness = [&](int node) { return paths.lengths[node] - grid.ToPhysical(grid.Position(node))[2]; };
  const auto isRectum = [&](int node) {
    return branch[node] >= 0 && paths.lengths[core[branch[node]]] >= earliest && grid.Distance(node) >= narrowestTaper;
  };
  double most = tipness(core.back());
  for (const int node : paths.order)
  {
    most = isRectum(node) ? std::max(most, tipness(node)) : most;
  }
  // A rectum truncated by the image border is wide there; use its center.
  constexpr double slab = 5.0;
  int              tip = core.back();
  double           widest = -1.0;
  for (const int node : paths.order)
  {
    if (isRectum(node) && grid.Distance(node) > widest && tipness(node) >= most - slab)
    {
      widest = grid.Distance(node);
      tip = node;
    }
  }
  return tip;
}
} // namespace

LumenNetwork::LumenNetwork(const LumenGrid & lumenGrid)
  : grid(lumenGrid)
  , cells(lumenGrid)
  , coreRadius(std::min(widestCore, 0.5 * cells.UsualRadius()))
  , tree(cells, coreRadius)
  , cuts(CutLoops(grid, cells, tree))
{
  tree.SortOut();
}

std::vector<int>
PieceLine::Nodes(bool prolongs0, bool prolongs1) const
{
  std::vector<int> nodes;
  const int        last = static_cast<int>(core.size()) - 1;
  if (prolongs0)
  {
    nodes.assign(ends[0].nodes.rbegin(), ends[0].nodes.rend());
  }
  const int from = prolongs0 ? ends[0].branch : 0;
  const int to = prolongs1 ? ends[1].branch : last;
  for (int i = from; i <= to; ++i)
  {
    nodes.push_back(core[i]);
  }
  if (prolongs1)
  {
    nodes.insert(nodes.end(), ends[1].nodes.begin(), ends[1].nodes.end());
  }
  return nodes;
}

void
PieceLine::Reverse()
{
  const int last = static_cast<int>(core.size()) - 1;
  std::reverse(core.begin(), core.end());
  std::swap(ends[0], ends[1]);
  std::swap(tips[0], tips[1]);
  for (int e = 0; e < 2; ++e)
  {
    ends[e].branch = last - ends[e].branch;
    for (PieceEnd & tip : tips[e])
    {
      tip.branch = last - tip.branch;
    }
  }
}

PieceLine
TracePiece(const LumenNetwork & network, int node, int exponent)
{
  const auto ends = network.tree.Ends(network.cells.cellOf[node]);
  return TraceBetween(network, network.cells.centers[ends[0]], false, exponent);
}

PieceLine
BeginAtAnus(const LumenNetwork & network, const PieceLine & line, int exponent)
{
  const int        end = line.core.back();
  const bool       isKnown = line.paths && line.paths->order.front() == end;
  const auto       known = isKnown ? line.paths : std::make_shared<const PathTree>(Grow(network, end, exponent));
  const PathTree & paths = *known;
  const int        wide = line.core.front();
  PieceLine        moved = line;
  moved.core = paths.PathTo(FindTip(network.grid, paths, paths.PathTo(wide)));
  std::reverse(moved.core.begin(), moved.core.end());
  moved.ends[0] = {};
  moved.tips = {};
  moved.paths = nullptr;
  // The extension branches off at the same distance from the other end of the core.
  moved.ends[1].branch += static_cast<int>(moved.core.size()) - static_cast<int>(line.core.size());
  return moved;
}

std::vector<int>
OtherPath(const LumenNetwork & network, const PieceLine & line, int exponent)
{
  const int last = line.core.back();
  return GrowPathTree(network.grid, network.cells, network.tree, line.core.front(), exponent, last).PathTo(last);
}

PieceLine
TracePieceFrom(const LumenNetwork & network, int node, int exponent)
{
  return TraceBetween(network, node, true, exponent);
}
} // namespace shapeton
