#include "shapetonColonVolume.h"

#include "shapetonParallelFor.h"
#include "shapetonSquaredDistances.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** The image axes in the order of the working grid; the axis closest to the long axis of the patient is last. */
std::array<int, 3>
WorkingOrder(const itk::ImageBase<3> * image)
{
  constexpr double rounding = 1e-9; // of direction cosines; equal axes keep their order
  int              axial = 2;
  for (int a = 0; a < 3; ++a)
  {
    if (std::abs(image->GetDirection()(2, a)) > std::abs(image->GetDirection()(2, axial)) + rounding)
    {
      axial = a;
    }
  }
  return { { axial == 0 ? 1 : 0, axial == 2 ? 1 : 2, axial } };
}
} // namespace

ColonGrid
ColonGrid::Part(const VoxelBox & box) const
{
  ColonGrid part = *this;
  part.SetSize({ { box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2] } });
  for (int a = 0; a < 3; ++a)
  {
    part.corner[a] += box.low[a];
  }
  part.origin = this->Position(Eigen::Vector3d(box.low[0], box.low[1], box.low[2]));
  return part;
}

VoxelBox
ColonGrid::Widened(const VoxelBox & box, double margin) const
{
  VoxelBox wide = box;
  for (int a = 0; a < 3; ++a)
  {
    const int voxels = static_cast<int>(std::ceil(margin / spacing[a]));
    wide.low[a] = std::max(0, box.low[a] - voxels);
    wide.high[a] = std::min(size[a], box.high[a] + voxels);
  }
  return wide;
}

ColonGrid
GridOfImage(const itk::ImageBase<3> * image)
{
  ColonGrid             grid;
  const auto            region = image->GetBufferedRegion();
  itk::Point<double, 3> origin;
  std::array<int, 3>    size;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  grid.imageAxis = WorkingOrder(image);
  for (int a = 0; a < 3; ++a)
  {
    const int axis = grid.imageAxis[a];
    size[a] = static_cast<int>(region.GetSize(axis));
    grid.spacing[a] = image->GetSpacing()[axis];
    grid.origin[a] = origin[a];
    for (int r = 0; r < 3; ++r)
    {
      grid.axes(r, a) = image->GetDirection()(r, axis);
    }
  }
  grid.SetSize(size);
  return grid;
}

/** Range of voxel values, HU: from the value outside the reconstruction circle to the greatest 16-bit value. */
constexpr float LeastHU = -1100.0F;
constexpr float GreatestHU = 32767.0F;

VoxelValues
LoadVoxels(const ColonImage * image, const ColonGrid & grid)
{
  VoxelValues   voxels(grid.NumberOfVoxels());
  const float * values = image->GetBufferPointer();
  ForEachVoxel(image, grid, [&](std::size_t from, std::size_t to) {
    const float v = values[from];
    voxels[to] = v > LeastHU ? std::min(v, GreatestHU) : LeastHU;
  });
  return voxels;
}

VoxelValues
CropVoxels(const VoxelValues & voxels, const ColonGrid & grid, const VoxelBox & box)
{
  const ColonGrid part = grid.Part(box);
  VoxelValues     crop(part.NumberOfVoxels());
  ParallelFor(part.size[2], [&](std::size_t k) {
    for (int j = 0; j < part.size[1]; ++j)
    {
      const auto * from = &voxels[grid.Index(box.low[0], j + box.low[1], static_cast<int>(k) + box.low[2])];
      std::copy(from, from + part.size[0], &crop[part.Index(0, j, static_cast<int>(k))]);
    }
  });
  return crop;
}

VoxelValues
SquaredDistanceToBackground(const ColonGrid & grid, const std::vector<unsigned char> & mask, double farthest)
{
  return SquaredDistances(grid, { { grid.spacing[0], grid.spacing[1], grid.spacing[2] } }, mask, farthest);
}

namespace
{
/** Mean and standard deviation of a block of voxels. */
std::array<double, 2>
MomentsOfBlock(const ColonGrid & grid, const VoxelValues & hu, const VoxelBox & box)
{
  double sum = 0.0;
  double squares = 0.0;
  int    count = 0;
  for (int k = box.low[2]; k < box.high[2]; ++k)
  {
    for (int j = box.low[1]; j < box.high[1]; ++j)
    {
      for (int i = box.low[0]; i < box.high[0]; ++i, ++count)
      {
        const double v = hu[grid.Index(i, j, k)];
        sum += v;
        squares += v * v;
      }
    }
  }
  const double mean = sum / count;
  return { { mean, std::sqrt(std::max(0.0, squares / count - mean * mean) * count / (count - 1.0)) } };
}
} // namespace

double
ModeOfTissue(const VoxelValues & hu)
{
  constexpr int       low = -60;              // HU; one bin per HU
  constexpr int       bins = 220;             // to 160 HU; chosen: holds plain and enhanced soft tissue
  constexpr int       halfWidth = 20;         // HU, of the triangular window that smooths the histogram
  constexpr int       margin = 2 * halfWidth; // HU; a mode at the border is the flank of another peak
  constexpr double    usual = 40.0;           // HU, for a window without a mode
  std::vector<double> count(bins, 0.0);
  for (std::size_t p = 0; p < hu.size(); p += 3)
  {
    const int bin = static_cast<int>(std::floor(hu[p])) - low;
    if (bin >= 0 && bin < bins)
    {
      count[bin] += 1.0;
    }
  }
  int    best = -1;
  double most = 0.0;
  for (int b = margin; b < bins - margin; ++b)
  {
    double sum = 0.0;
    for (int d = -halfWidth; d <= halfWidth; ++d)
    {
      sum += (halfWidth + 1 - std::abs(d)) * count[b + d];
    }
    best = sum > most ? b : best;
    most = std::max(most, sum);
  }
  return best > margin && best < bins - margin - 1 ? best + low + 0.5 : usual;
}

VoxelBlocks
MeasureBlocks(const ColonGrid & grid, const VoxelValues & hu)
{
  constexpr double   size = 5.0; // mm; chosen: many voxels, small against organs
  VoxelBlocks        blocks;
  std::array<int, 3> number;
  for (int a = 0; a < 3; ++a)
  {
    blocks.edge[a] = std::min(grid.size[a], std::max(2, static_cast<int>(std::lround(size / grid.spacing[a]))));
    number[a] = grid.size[a] / blocks.edge[a];
  }
  blocks.grid.SetSize(number);
  blocks.mean.resize(blocks.grid.NumberOfVoxels());
  blocks.deviation.resize(blocks.mean.size());
  const auto & edge = blocks.edge;
  ParallelFor(number[2], [&](std::size_t layer) {
    const int k = static_cast<int>(layer) * edge[2];
    for (int j = 0; j < number[1] * edge[1]; j += edge[1])
    {
      for (int i = 0; i < number[0] * edge[0]; i += edge[0])
      {
        const auto m = MomentsOfBlock(grid, hu, { { { i, j, k } }, { { i + edge[0], j + edge[1], k + edge[2] } } });
        const auto b = blocks.grid.Index(i / edge[0], j / edge[1], static_cast<int>(layer));
        blocks.mean[b] = m[0];
        blocks.deviation[b] = m[1];
      }
    }
  });
  return blocks;
}

double
NoiseInTissue(const ColonGrid & grid, const VoxelValues & hu, double tissue)
{
  constexpr double      nearTissue = 60.0; // HU; chosen: holds fluid and muscle, excludes fat
  constexpr std::size_t leastBlocks = 20;  // chosen: fewer give no reliable quartile
  const VoxelBlocks     blocks = MeasureBlocks(grid, hu);
  std::vector<double>   deviations;
  for (std::size_t b = 0; b < blocks.mean.size(); ++b)
  {
    if (std::abs(blocks.mean[b] - tissue) < nearTissue)
    {
      deviations.push_back(blocks.deviation[b]);
    }
  }
  if (deviations.size() < leastBlocks)
  {
    return 0.0;
  }
  const auto quartile = deviations.begin() + deviations.size() / 4;
  std::nth_element(deviations.begin(), quartile, deviations.end());
  return *quartile;
}

double
ShareInWall(const ColonGrid & grid, double smoothing)
{
  constexpr double halfWall = 1.0; // mm; half of a wall of 2 mm
  const double     variance = UsualBlur * UsualBlur + UniformVariance(grid.spacing.maxCoeff()) + smoothing * smoothing;
  return std::erfc(halfWall / std::sqrt(2.0 * variance));
}

namespace
{
bool
Contains(const VoxelSet & voxels, std::size_t voxel)
{
  return std::binary_search(voxels.begin(), voxels.end(), voxel);
}

/** Voxels at which a ball of the given radius fits. */
VoxelSet
WideVoxels(const ColonGrid &                        grid,
           const VoxelSet &                         voxels,
           double                                   radius,
           const std::function<bool(std::size_t)> & isOpen)
{
  VoxelSet wide;
  for (const auto p : voxels)
  {
    if (ForAllWithin(grid, p, radius, [&](std::size_t q, double squaredDistance) {
          return squaredDistance > radius * radius || isOpen(q) || Contains(voxels, q);
        }))
    {
      wide.push_back(p);
    }
  }
  return wide;
}
} // namespace

std::vector<std::vector<std::size_t>>
ConnectedPieces(const ColonGrid & grid, const VoxelSet & voxels, const VoxelParts & parts)
{
  const auto part = [&](std::size_t p) {
    const auto found = parts.find(p);
    return found == parts.end() ? 0 : found->second;
  };
  std::unordered_map<std::size_t, char> isLeft;
  for (const auto p : voxels)
  {
    isLeft[p] = 1;
  }
  std::vector<std::vector<std::size_t>> pieces;
  for (const auto first : voxels)
  {
    if (!isLeft[first])
    {
      continue;
    }
    pieces.push_back({ first });
    auto & piece = pieces.back();
    isLeft[first] = 0;
    for (std::size_t n = 0; n < piece.size(); ++n)
    {
      ForEachNeighbor(grid, piece[n], [&](std::size_t q) {
        const auto found = isLeft.find(q);
        if (found != isLeft.end() && found->second && part(q) == part(first))
        {
          found->second = 0;
          piece.push_back(q);
        }
      });
    }
  }
  return pieces;
}

VoxelParts
PartsAtNecks(const ColonGrid &                        grid,
             const VoxelSet &                         voxels,
             double                                   radius,
             const std::function<bool(std::size_t)> & isOpen)
{
  VoxelParts               parts;
  std::vector<std::size_t> queue;
  int                      number = 0;
  for (const auto & piece : ConnectedPieces(grid, WideVoxels(grid, voxels, radius, isOpen)))
  {
    ++number;
    for (const auto p : piece)
    {
      parts[p] = number;
      queue.push_back(p);
    }
  }
  for (std::size_t n = 0; n < queue.size(); ++n)
  {
    const int own = parts[queue[n]];
    ForEachNeighbor(grid, queue[n], [&](std::size_t q) {
      if (Contains(voxels, q) && parts.emplace(q, own).second)
      {
        queue.push_back(q);
      }
    });
  }
  return parts;
}

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
  const VoxelBox  box = grid.Widened(piece.box, OneVoxel);
  const ColonGrid part = grid.Part(box);
  const auto      distance = SquaredDistanceToBackground(part, MaskOfRuns(grid, set, labels, label, box));
  const auto      place = std::max_element(distance.begin(), distance.end());
  DeepestVoxel    deepest;
  // There is no background if a piece fills its bounding box.
  deepest.radius = std::sqrt(std::min(*place, GreatestSquaredDistance));
  deepest.voxel = part.Voxel(static_cast<std::size_t>(place - distance.begin()));
  for (int a = 0; a < 3; ++a)
  {
    deepest.voxel[a] += box.low[a];
  }
  return deepest;
}
} // namespace shapeton
