#include "itkColonCentreline.h"

#include "itkCentrelineAssembly.h"
#include "itkLumenChoice.h"
#include "itkPieceLine.h"
#include "itkPieceOrder.h"
#include "itkPlaceInWords.h"

#include "itkToolError.h"

#include <algorithm>
#include <map>
#include <memory>

namespace itk
{
namespace
{
void
RequireOptions(const ColonCentrelineOptions & options)
{
  RequireUsage(options.exponent >= 1 && options.exponent <= 8, "the exponent of the centreline must be from 1 to 8");
  RequireUsage(options.step >= 0.2 && options.step <= 10.0, "the step of the centreline must be from 0.2 to 10 mm");
  RequireUsage(options.smoothing >= 0.0 && options.smoothing <= 20.0,
               "the smoothing of the centreline must be from 0 to 20 mm");
  RequireUsage(options.minimumVolume >= 0.0 && options.minimumExtent >= 0.0 && options.gapRadius >= 0.0,
               "volumes, extents and radii of the centreline must not be negative");
}

Eigen::Vector3d
ToVector(const Point<double, 3> & point)
{
  return { point[0], point[1], point[2] };
}

/** A node of each piece, the widest; a piece is what hangs together by open passages. Crumbs that the grid tears off a
 * component, smaller than the smallest piece, are left out. */
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
    const int centre = network.cells.centres[cell];
    if (node < 0 || network.grid.Distance(centre) > network.grid.Distance(node))
    {
      node = centre;
    }
    volumes[groups[cell]] += network.cells.volumes[cell];
    double & most = largest[network.grid.Component(centre)];
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

/** The lines of all pieces; the one of the rectum's given start comes first. */
std::vector<PieceLine>
TracePieces(const LumenNetwork & network, const ColonCentrelineOptions & options)
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
    }
    if (options.progress)
    {
      options.progress(0.2 + 0.6 * (i + 1) / widest.size());
    }
  }
  return lines;
}

/** The direction out of the last node, taken over 25 mm of the path. */
Eigen::Vector3d
OutOf(const CurvePoints & points)
{
  std::size_t i = points.size() - 1;
  while (i > 0 && (points[i] - points.back()).norm() < 25.0)
  {
    --i;
  }
  const Eigen::Vector3d out = points.back() - points[i];
  return out.norm() > 0.0 ? Eigen::Vector3d(out.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
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

JoinPiece
MakeJoinPiece(const LumenGrid & grid, const PieceLine & line, bool prolongs)
{
  CurvePoints points = PhysicalPoints(grid, line.Nodes(prolongs, prolongs));
  JoinPiece   piece;
  piece.length = CurveLength(points);
  piece.ends[1] = { points.back(), OutOf(points) };
  std::reverse(points.begin(), points.end());
  piece.ends[0] = { points.back(), OutOf(points) };
  return piece;
}

PlacedPiece
ChooseRectum(const LumenNetwork & network, const std::vector<PieceLine> & lines, const ColonCentrelineOptions & options)
{
  if (options.start)
  {
    return { 0, false };
  }
  Eigen::Vector3d        lowest = Eigen::Vector3d::Constant(1e30);
  Eigen::Vector3d        highest = -lowest;
  std::vector<JoinPiece> pieces;
  for (const PieceLine & line : lines)
  {
    for (const Eigen::Vector3d & point : PhysicalPoints(network.grid, line.core))
    {
      lowest = lowest.cwiseMin(point);
      highest = highest.cwiseMax(point);
    }
    pieces.push_back(MakeJoinPiece(network.grid, line, false));
  }
  return FindRectum(pieces, lowest, highest);
}

std::vector<PlacedPiece>
ChooseOrder(const LumenNetwork &           network,
            const std::vector<PieceLine> & lines,
            const LumenChoice &            choice,
            const ColonCentrelineOptions & options)
{
  std::vector<JoinPiece> pieces;
  for (const PieceLine & line : lines)
  {
    pieces.push_back(MakeJoinPiece(network.grid, line, true));
    pieces.back().isWanted = choice.isWanted[line.component] != 0;
  }
  return OrderPieces(pieces, ChooseRectum(network, lines, options));
}
/** The lines of a lumen in their order. The grid comes first, since the network refers to it. */
struct Traced
{
  std::unique_ptr<LumenGrid>    grid;
  std::unique_ptr<LumenNetwork> network;
  std::vector<PieceLine>        lines;
  std::vector<PlacedPiece>      order;
};

Traced
TraceOn(const std::array<int, 3> &     blocks,
        const LumenDistanceImage *     distance,
        const LumenComponents &        components,
        const LumenChoice &            choice,
        const ColonCentrelineOptions & options)
{
  Traced traced;
  traced.grid = std::make_unique<LumenGrid>(distance, components.labels.GetPointer(), choice.isUsed, blocks);
  traced.network = std::make_unique<LumenNetwork>(*traced.grid);
  traced.lines = TracePieces(*traced.network, options);
  traced.order = ChooseOrder(*traced.network, traced.lines, choice, options);
  for (const PlacedPiece & placed : traced.order)
  {
    if (placed.isReversed)
    {
      traced.lines[placed.piece].Reverse();
    }
  }
  return traced;
}

/** Blocks of voxels can tear a narrow lumen that the voxels themselves hold together: it shows as a short gap between
 * two lines of one component. */
bool
IsTorn(const Traced & traced)
{
  constexpr double shortGap = 12.0;
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
Trace(const LumenDistanceImage *     distance,
      const LumenComponents &        components,
      const LumenChoice &            choice,
      const ColonCentrelineOptions & options)
{
  constexpr std::array<int, 3> single = { 1, 1, 1 };
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
} // namespace

ColonCentreline
TraceColonCentreline(const LumenMask * lumen, const ColonCentrelineOptions & options)
{
  RequireOptions(options);
  const auto report = [&options](double share) {
    if (options.progress)
    {
      options.progress(share);
    }
  };
  const ImageRegion<3>  region = LumenRegion(lumen);
  const LumenComponents components = FindLumenComponents(lumen, region);
  const LumenChoice     choice = ChooseLumen(lumen, components, options);
  const auto            distance = LumenDistance(lumen, region);
  report(0.2);
  const Traced traced = Trace(distance, components, choice, options);
  report(0.8);
  ColonCentreline result =
    AssembleCentreline(*traced.network, DistanceField(distance), traced.lines, traced.order, options);
  AddUnusedLines(*traced.network, traced.lines, traced.order, result);
  AddUnusedComponents(lumen, components, choice, result);
  AddMerges(*traced.network, result);
  report(1.0);
  return result;
}
} // namespace itk
