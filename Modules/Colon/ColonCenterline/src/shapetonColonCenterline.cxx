#include "shapetonColonCenterline.h"

#include "shapetonCenterlineAssembly.h"
#include "shapetonLumenChoice.h"
#include "shapetonPieceLine.h"
#include "shapetonPieceOrder.h"
#include "shapetonPlaceInWords.h"

#include <algorithm>
#include <map>
#include <memory>

namespace shapeton
{
namespace
{
Eigen::Vector3d
ToVector(const itk::Point<double, 3> & point)
{
  return { point[0], point[1], point[2] };
}

/** The widest node of each piece, a set of cells connected by open passages. Ignores fragments below the minimum volume
 * that the coarser grid separated from a component. */
std::vector<int>
WidestNodes(const LumenNetwork & network, double minimumVolume)
{
  const std::vector<int> groups = network.tree.Groups();
  std::vector<int>       widest(groups.size(), -1);
  std::vector<double>    volumes(groups.size(), 0.0);
  std::map<int, double>  largest;
  for (std::size_t cell = 0; cell < groups.size(); ++cell)
  {
    int &     node = widest[groups[cell]];
    const int center = network.cells.centers[cell];
    if (node < 0 || network.grid.Distance(center) > network.grid.Distance(node))
    {
      node = center;
    }
    volumes[groups[cell]] += network.cells.volumes[cell];
    double & most = largest[network.grid.Component(center)];
    most = std::max(most, volumes[groups[cell]]);
  }
  std::vector<int> nodes;
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    if (widest[group] >= 0 &&
        (volumes[group] >= 1e3 * minimumVolume || volumes[group] == largest[network.grid.Component(widest[group])]))
    {
      nodes.push_back(widest[group]);
    }
  }
  return nodes;
}

/** Path trees are as large as the whole lumen, so they are stored only for the largest piece, which usually contains
 * the rectum. */
void
KeepPathsOfLargest(std::vector<PieceLine> & lines)
{
  const auto isSmaller = [](const PieceLine & a, const PieceLine & b) { return a.volume < b.volume; };
  const auto largest = std::max_element(lines.begin(), lines.end(), isSmaller);
  for (auto line = lines.begin(); line != lines.end(); ++line)
  {
    line->paths = line == largest ? line->paths : nullptr;
  }
}

/** The lines of all pieces; the line with the given start in the rectum is first. */
std::vector<PieceLine>
TracePieces(const LumenNetwork & network, const ColonCenterlineSettings & options)
{
  const std::vector<int> groups = network.tree.Groups();
  std::vector<PieceLine> lines;
  int                    begun = -1;
  if (options.start)
  {
    const int node = network.grid.NearestNode(network.grid.FromPhysical(ToVector(*options.start)));
    lines.push_back(TracePieceFrom(network, node, options.exponent));
    begun = groups[network.cells.cellOf[node]];
  }
  const std::vector<int> widest = WidestNodes(network, options.minimumVolume);
  for (std::size_t i = 0; i < widest.size(); ++i)
  {
    if (groups[network.cells.cellOf[widest[i]]] != begun)
    {
      lines.push_back(TracePiece(network, widest[i], options.exponent));
      KeepPathsOfLargest(lines);
    }
    options.progress(0.2 + 0.6 * (i + 1) / widest.size());
  }
  return lines;
}

CurvePoints
PhysicalPoints(const LumenGrid & grid, const std::vector<int> & nodes)
{
  CurvePoints points;
  for (const int node : nodes)
  {
    points.push_back(grid.ToPhysical(grid.Position(node)));
  }
  return points;
}

std::vector<double>
RadiiOf(const LumenGrid & grid, const std::vector<int> & nodes)
{
  std::vector<double> radii(nodes.size());
  std::transform(nodes.begin(), nodes.end(), radii.begin(), [&grid](int node) { return grid.Distance(node); });
  return radii;
}

/** End 1 of a line, or end 0 of a reversed line. The direction points from the last 40 mm of the core to the center of
 * the tips, since paths bend toward the wall at a blunt end. */
JoinEnd
MakeJoinEnd(const LumenGrid & grid, const PieceLine & line, bool isReversed, bool prolongs)
{
  std::vector<int> nodes = line.core;
  if (isReversed)
  {
    std::reverse(nodes.begin(), nodes.end());
  }
  const CurvePoints         core = PhysicalPoints(grid, nodes);
  const std::vector<double> radii = RadiiOf(grid, nodes);
  JoinEnd                   end;
  end.radius = RadiusNearEnd(core, radii);
  end.position = core.back();
  Eigen::Vector3d middle = core.back();
  if (prolongs)
  {
    middle.setZero();
    for (const PieceEnd & tip : line.tips[isReversed ? 0 : 1])
    {
      end.tips.push_back(tip.nodes.empty() ? core.back() : grid.ToPhysical(grid.Position(tip.nodes.back())));
      end.shortfalls.push_back(tip.shortfall);
      middle += end.tips.back() / static_cast<double>(line.tips[isReversed ? 0 : 1].size());
    }
    end.position = end.tips.front();
  }
  constexpr double reach = 40.0; // mm over which the direction is measured
  std::size_t      i = core.size() - 1;
  while (i > 0 && (core[i] - core.back()).norm() < reach)
  {
    --i;
  }
  const Eigen::Vector3d out = middle - core[i];
  end.out = out.norm() > 0.0 ? Eigen::Vector3d(out.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  return end;
}

JoinPiece
MakeJoinPiece(const LumenGrid & grid, const PieceLine & line, bool prolongs)
{
  JoinPiece piece;
  piece.length = CurveLength(PhysicalPoints(grid, line.Nodes(prolongs, prolongs)));
  piece.ends[0] = MakeJoinEnd(grid, line, true, prolongs);
  piece.ends[1] = MakeJoinEnd(grid, line, false, prolongs);
  return piece;
}

/** The pieces in order from the rectum; sets the ends of `lines` to the joined ends. */
std::vector<PlacedPiece>
ChooseOrder(const LumenNetwork &           network,
            const LumenChoice &            choice,
            const ColonCenterlineOptions & options,
            std::vector<PieceLine> &       lines)
{
  const LumenGrid &      grid = network.grid;
  ColonExtent            extent;
  std::vector<JoinPiece> cores;
  std::vector<JoinPiece> pieces;
  for (const PieceLine & line : lines)
  {
    for (const Eigen::Vector3d & point : PhysicalPoints(grid, line.core))
    {
      extent.Include(point);
    }
    cores.push_back(MakeJoinPiece(grid, line, false));
    pieces.push_back(MakeJoinPiece(grid, line, true));
    pieces.back().isWanted = choice.isWanted[line.component] != 0;
    pieces.back().weight = WeightOf(RadiiOf(grid, line.core), network.cells.UsualRadius());
  }
  PreferCecum(extent, network.cells.UsualRadius(), pieces);
  const auto order = OrderPieces(pieces, options.start ? PlacedPiece{ 0, false } : FindRectum(cores, extent));
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const int         ends[2] = { order[i - 1].isReversed ? 0 : 1, order[i].isReversed ? 1 : 0 };
    const PlacedPiece joined[2] = { order[i - 1], order[i] };
    const auto closest = ClosestTips(pieces[joined[0].piece].ends[ends[0]], pieces[joined[1].piece].ends[ends[1]]);
    for (int side = 0; side < 2; ++side)
    {
      PieceLine & line = lines[joined[side].piece];
      line.ends[ends[side]] = line.tips[ends[side]][closest[side]];
    }
  }
  return order;
}

/** The ordered lines of a lumen. The grid is declared first, since the network refers to it. */
struct Traced
{
  std::unique_ptr<LumenGrid>    grid;
  std::unique_ptr<LumenNetwork> network;
  std::vector<PieceLine>        lines;
  std::vector<PlacedPiece>      order;
};

Traced
TraceOn(const std::array<int, 3> &      blocks,
        const LumenDistanceImage *      distance,
        const LumenComponents &         components,
        const LumenChoice &             choice,
        const ColonCenterlineSettings & options)
{
  Traced traced;
  traced.grid = std::make_unique<LumenGrid>(distance, components.labels.GetPointer(), choice.isUsed, blocks);
  traced.network = std::make_unique<LumenNetwork>(*traced.grid);
  traced.lines = TracePieces(*traced.network, options);
  traced.order = ChooseOrder(*traced.network, choice, options, traced.lines);
  for (const PlacedPiece & placed : traced.order)
  {
    if (placed.isReversed)
    {
      traced.lines[placed.piece].Reverse();
    }
  }
  return traced;
}

/** Detects narrow lumen that was disconnected when voxels were merged into blocks: a short gap between two lines of the
 * same component. */
bool
IsTorn(const Traced & traced)
{
  constexpr double shortGap = 12.0; // mm; chosen: a torn lumen has short gaps
  for (std::size_t i = 1; i < traced.order.size(); ++i)
  {
    const PieceLine &     before = traced.lines[traced.order[i - 1].piece];
    const PieceLine &     after = traced.lines[traced.order[i].piece];
    const Eigen::Vector3d gap =
      traced.grid->Position(before.Nodes(true, true).back()) - traced.grid->Position(after.Nodes(true, true).front());
    if (before.component == after.component && gap.norm() < shortGap)
    {
      return true;
    }
  }
  return false;
}

Traced
Trace(const LumenDistanceImage *      distance,
      const LumenComponents &         components,
      const LumenChoice &             choice,
      const ColonCenterlineSettings & options)
{
  constexpr std::array<int, 3> single = { 1, 1, 1 }; // voxels per block: no merging
  const auto                   blocks = LumenGrid::Blocks(distance->GetSpacing().GetDataPointer());
  Traced                       traced;
  if (blocks != single)
  {
    traced = TraceOn(blocks, distance, components, choice, options);
  }
  if (blocks == single || !IsComplete(*traced.grid, choice.isUsed) || IsTorn(traced))
  {
    traced = TraceOn(single, distance, components, choice, options);
  }
  if (!options.start)
  {
    PieceLine & rectum = traced.lines[traced.order.front().piece];
    rectum = BeginAtAnus(*traced.network, rectum, options.exponent);
  }
  return traced;
}

/** Reason why the mask cannot be a colon: far more gaps and holes, or far larger cross-sections, than in a colon; empty
 * otherwise. */
std::string
FailureOfLine(const ColonCenterline & line)
{
  // Colons have at most 8 gaps and holes, the lungs in three chest scans 56 to 121. The limit is the geometric mean of
  // 8 and 56.
  constexpr std::size_t mostFaults = 20;
  constexpr double      largestSection = 50.0; // mean, cm^2: a tube of 80 mm diameter
  const std::size_t     gaps = line.gaps.size();
  const std::size_t     merges = line.merges.size();
  if (gaps + merges > mostFaults)
  {
    return "the lumen is not a colon: its line has " + std::to_string(gaps) + " gaps and touches itself at " +
           std::to_string(merges) + " places, far more than in a colon; give the lumen, not lung or the wall";
  }
  double ml = 0.0;
  for (const CenterlinePiece & piece : line.pieces)
  {
    ml += piece.isUsed ? piece.volume : 0.0;
  }
  const double section = 10.0 * ml / line.length; // 1 ml per mm is 10 cm^2
  if (section > largestSection)
  {
    return "the lumen is not a colon: " + std::to_string(std::lround(ml)) + " ml along a line of " +
           std::to_string(std::lround(line.length)) + " mm are " + std::to_string(std::lround(section)) +
           " cm^2 on average, far more than in a colon; give the lumen, not lung or stomach";
  }
  return {};
}
} // namespace

ColonCenterline
TraceColonCenterline(const LumenMask * lumen, const ColonCenterlineSettings & options)
{
  CheckOptions(options);
  const itk::ImageRegion<3> region = LumenRegion(lumen);
  const LumenComponents     components = FindLumenComponents(lumen, region);
  const LumenChoice         choice = ChooseLumen(lumen, components, options);
  const auto                distance = LumenDistance(lumen, region);
  options.progress(0.2);
  const Traced traced = Trace(distance, components, choice, options);
  options.progress(0.8);
  ColonCenterline result =
    AssembleCenterline(*traced.network, DistanceField(distance), traced.lines, traced.order, options);
  AddUnusedLines(*traced.network, traced.lines, traced.order, result);
  AddUnusedComponents(lumen, components, choice, result);
  AddMerges(*traced.network, result);
  result.failure = FailureOfLine(result);
  options.progress(1.0);
  return result;
}
} // namespace shapeton
