#include "itkColonCentreline.h"

#include "itkCentrelineAssembly.h"
#include "itkLumenChoice.h"
#include "itkPieceLine.h"
#include "itkPieceOrder.h"
#include "itkPlaceInWords.h"

#include "itkToolError.h"

#include <algorithm>
#include <cmath>
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

/** A grid with its cells. The grid comes first, since the cells refer to it. */
struct Lumen
{
  std::unique_ptr<LumenGrid>    grid;
  std::unique_ptr<LumenNetwork> network;
};

/** Blocks of voxels can tear a narrow lumen that the voxels themselves hold together; then every voxel counts. */
Lumen
MakeNetwork(const LumenDistanceImage * distance, const LumenComponents & components, const std::vector<char> & isUsed)
{
  Lumen lumen;
  auto  blocks = LumenGrid::Blocks(distance->GetSpacing().GetDataPointer());
  while (true)
  {
    lumen.grid = std::make_unique<LumenGrid>(distance, components.labels.GetPointer(), isUsed, blocks);
    lumen.network = std::make_unique<LumenNetwork>(*lumen.grid);
    if (blocks == std::array<int, 3>{ 1, 1, 1 } || IsWhole(*lumen.network, isUsed))
    {
      return lumen;
    }
    lumen.network.reset();
    blocks = { 1, 1, 1 };
  }
}

/** A node of each piece, the widest; a piece is what hangs together by open passages. */
std::vector<int>
WidestNodes(const LumenNetwork & network)
{
  const std::vector<int> groups = network.tree.Groups();
  std::vector<int>       widest(groups.size(), -1);
  for (std::size_t cell = 0; cell < groups.size(); ++cell)
  {
    int &     node = widest[groups[cell]];
    const int centre = network.cells.centres[cell];
    if (node < 0 || network.grid.Distance(centre) > network.grid.Distance(node))
    {
      node = centre;
    }
  }
  widest.erase(std::remove(widest.begin(), widest.end(), -1), widest.end());
  return widest;
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
  const std::vector<int> widest = WidestNodes(network);
  for (std::size_t i = 0; i < widest.size(); ++i)
  {
    if (groups[network.cells.cellOf[widest[i]]] != begun)
    {
      lines.push_back(TracePiece(network, widest[i], options.exponent));
    }
    if (options.progress)
    {
      options.progress(0.4 + 0.4 * (i + 1) / widest.size());
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
  const Lumen made = MakeNetwork(distance, components, choice.isUsed);
  report(0.4);
  std::vector<PieceLine>         lines = TracePieces(*made.network, options);
  const std::vector<PlacedPiece> order = ChooseOrder(*made.network, lines, choice, options);
  for (const PlacedPiece & placed : order)
  {
    if (placed.isReversed)
    {
      lines[placed.piece].Reverse();
    }
  }
  if (!options.start)
  {
    PieceLine & rectum = lines[order.front().piece];
    rectum = BeginAtAnus(*made.network, rectum, options.exponent);
  }
  report(0.8);
  ColonCentreline result = AssembleCentreline(*made.network, DistanceField(distance), lines, order, options);
  AddUnusedLines(*made.network, lines, order, result);
  AddUnusedComponents(lumen, components, choice, result);
  AddMerges(*made.network, result);
  report(1.0);
  return result;
}
} // namespace itk
