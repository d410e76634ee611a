#include "shapetonLumenTopology.h"

#include "shapetonCenterlineGeometry.h"
#include "shapetonPaddedVoxels.h"
#include "shapetonExceptions.h"
#include "shapetonMappedImage.h"
#include "shapetonSquaredDistances.h"

#include <cmath>
#include <numeric>

namespace shapeton
{
namespace
{
constexpr float         WallLevel = 0.5F;               // occupancy at the wall
constexpr unsigned char Lumen = 1;                      // flag of a voxel
constexpr double        RanksPerMillimeter = 100.0;     // chosen: 0.01 mm, up to 655 mm in 16 bits
constexpr std::uint16_t CenterlineRank = 65535;         // the greatest rank, so the line grows first
constexpr double        GreatestDistanceRank = 65534.0; // below CenterlineRank

void
CopyFlagsToMask(const PaddedVoxels & voxels, LumenMaskImage * mask)
{
  unsigned char * values = mask->GetBufferPointer();
  voxels.ForEachVoxel([&](std::int64_t padded, std::int64_t inner) { values[inner] = voxels.flags[padded] & Lumen; });
}

/** Sets the flags of all components except one; returns the number of changed voxels. */
std::int64_t
SetFlagsOfOthers(PaddedVoxels & voxels, const VoxelComponents & components, int kept, unsigned char flags)
{
  std::int64_t changed = 0;
  ForEachRun(components.runs, [&](std::size_t r, int j, int k) {
    if (components.labels.ofRun[r] != kept)
    {
      const VoxelRun run = components.runs.runs[r];
      const auto     row = voxels.flags.begin() + static_cast<std::ptrdiff_t>(voxels.grid.Index(0, j, k));
      std::fill(row + run.begin, row + run.end, flags);
      changed += run.end - run.begin;
    }
  });
  return changed;
}

/** Keeps the largest piece and fills its cavities. */
void
KeepSolidPiece(LumenMaskImage * mask, double voxelVolume, LumenTopologyReport & report)
{
  PaddedVoxels voxels(mask->GetBufferedRegion());
  voxels.SetFlag(mask, Lumen);
  const VoxelComponents pieces = FindComponents(voxels, Lumen, true, VoxelContact::Face);
  if (pieces.labels.number == 0)
  {
    throw InputError("the lumen is empty: no voxel has an occupancy of at least 0.5");
  }
  const int largest =
    static_cast<int>(std::max_element(pieces.sizes.begin(), pieces.sizes.end()) - pieces.sizes.begin());
  const std::int64_t dropped = SetFlagsOfOthers(voxels, pieces, largest, 0);
  CopyFlagsToMask(voxels, mask);
  report.handlesBefore = TopologyOfMask(mask).handles;
  const VoxelComponents background = FindComponents(voxels, Lumen, false, VoxelContact::FaceOrEdge);
  const std::int64_t    filled = SetFlagsOfOthers(voxels, background, 1, Lumen);
  CopyFlagsToMask(voxels, mask);
  report.droppedPieces = pieces.labels.number - 1;
  report.cavities = background.labels.number - 1;
  report.droppedVolume = static_cast<double>(dropped) * voxelVolume;
  report.cavityVolume = static_cast<double>(filled) * voxelVolume;
  report.lumenVolume = static_cast<double>(pieces.sizes[largest]) * voxelVolume;
}

/** Erosion along one axis: keeps voxels whose two neighbors are set. Voxels outside the grid count as set. */
std::vector<unsigned char>
Eroded(const VoxelGrid & grid, const std::vector<unsigned char> & mask, int axis)
{
  std::vector<unsigned char> eroded(mask.size());
  const std::size_t          stride = grid.stride[axis];
  const int                  last = grid.size[axis] - 1;
  ParallelFor(grid.size[2], [&](std::size_t k) {
    std::size_t p = k * grid.stride[2];
    for (std::array<int, 3> v{ { 0, 0, static_cast<int>(k) } }; v[1] < grid.size[1]; ++v[1])
    {
      for (v[0] = 0; v[0] < grid.size[0]; ++v[0], ++p)
      {
        const int before = v[axis] == 0 ? 1 : mask[p - stride];
        const int after = v[axis] == last ? 1 : mask[p + stride];
        eroded[p] = static_cast<unsigned char>(mask[p] & before & after);
      }
    }
  });
  return eroded;
}

/** Squared distances (mm^2) to the nearest lumen voxel that is 26-adjacent to the background. */
VoxelValues
SquaredDistancesToRim(const LumenMaskImage * lumen)
{
  const auto                 size = lumen->GetBufferedRegion().GetSize();
  const auto                 spacing = lumen->GetSpacing();
  const VoxelGrid            grid(static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]));
  std::vector<unsigned char> inside(lumen->GetBufferPointer(), lumen->GetBufferPointer() + grid.NumberOfVoxels());
  for (int axis = 0; axis < 3; ++axis)
  {
    inside = Eroded(grid, inside, axis);
  }
  return SquaredDistances(grid, { spacing[0], spacing[1], spacing[2] }, inside);
}

/** Ranks by distance to the wall. Ties next to the wall are broken by occupancy, so that a membrane follows the
 * septum. */
GrowthRankImage::Pointer
RanksOfLumen(const LumenMaskImage * lumen, const OccupancyImage * occupancy)
{
  const VoxelValues squares = SquaredDistancesToRim(lumen);

  auto                  ranks = NewImageOn<GrowthRankImage>(lumen);
  const auto            spacing = lumen->GetSpacing();
  const double          finest = std::min({ spacing[0], spacing[1], spacing[2] });
  const float * const   occupancyOf = occupancy->GetBufferPointer();
  std::uint16_t * const rankOf = ranks->GetBufferPointer();
  ParallelForBlocks(lumen->GetBufferedRegion().GetNumberOfPixels(), [&](std::size_t i) {
    const double depth = std::sqrt(squares[i]) + finest * (occupancyOf[i] - static_cast<double>(WallLevel));
    rankOf[i] =
      static_cast<std::uint16_t>(std::clamp(RanksPerMillimeter * (depth + finest), 0.0, GreatestDistanceRank));
  });
  return ranks;
}

/** Ranks the voxels along the centerline above all others. */
void
RaiseCenterline(GrowthRankImage * ranks, const CurveSet & centerline)
{
  const GridGeometry grid(ranks);
  const auto         size = ranks->GetBufferedRegion().GetSize();
  for (const auto & curve : centerline.curves)
  {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i)
    {
      ForVoxelsOfSegment(
        grid, size, centerline.V.row(curve[i]), centerline.V.row(curve[i + 1]), [&](std::array<long, 3> voxel) {
          const std::size_t k = (voxel[2] * size[1] + voxel[1]) * size[0] + voxel[0];
          ranks->GetBufferPointer()[k] = CenterlineRank;
        });
    }
  }
}

/** Sets a lumen voxel of maximum rank as the seed. */
void
PlantSeed(LumenMaskImage * grown, const LumenMaskImage * limit, const GrowthRankImage * ranks)
{
  const unsigned char * const isIn = limit->GetBufferPointer();
  const std::uint16_t * const rankOf = ranks->GetBufferPointer();
  const std::size_t           size = limit->GetBufferedRegion().GetNumberOfPixels();
  std::size_t                 best = 0;
  int                         bestRank = -1;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (isIn[i] != 0 && rankOf[i] > bestRank)
    {
      best = i;
      bestRank = rankOf[i];
    }
  }
  grown->GetBufferPointer()[best] = 1;
}
} // namespace

LumenTopology
RepairLumenTopology(const OccupancyImage * occupancy, const CurveSet & centerline)
{
  const auto    spacing = occupancy->GetSpacing();
  const double  voxelVolume = spacing[0] * spacing[1] * spacing[2] / 1000.0;
  LumenTopology result;
  const auto    limit = NewImageOn<LumenMaskImage>(occupancy, true);
  const auto    size = occupancy->GetBufferedRegion().GetNumberOfPixels();
  ParallelForBlocks(size, [isIn = limit->GetBufferPointer(), share = occupancy->GetBufferPointer()](std::size_t i) {
    isIn[i] = share[i] >= WallLevel ? 1 : 0;
  });
  KeepSolidPiece(limit, voxelVolume, result.report);
  const auto ranks = RanksOfLumen(limit, occupancy);
  RaiseCenterline(ranks, centerline);
  result.mask = NewImageOn<LumenMaskImage>(occupancy, true);
  PlantSeed(result.mask, limit, ranks);
  GrowByTopologyPreservingPoints(result.mask, limit, ranks);
  const auto cut =
    std::accumulate(limit->GetBufferPointer(), limit->GetBufferPointer() + size, std::int64_t{ 0 }) -
    std::accumulate(result.mask->GetBufferPointer(), result.mask->GetBufferPointer() + size, std::int64_t{ 0 });
  result.report.cutVolume = static_cast<double>(cut) * voxelVolume;
  result.report.handlesAfter = TopologyOfMask(result.mask).handles;
  return result;
}
} // namespace shapeton
