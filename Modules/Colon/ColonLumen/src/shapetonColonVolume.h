#ifndef shapetonColonVolume_h
#define shapetonColonVolume_h

#include "shapetonParallelFor.h"
#include "shapetonSmoothVoxels.h"
#include "shapetonVoxelGrid.h"
#include "shapetonVoxelValues.h"
#include "shapetonVoxelRuns.h"
#include "itkImage.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <functional>
#include <unordered_map>
#include <vector>

namespace shapeton
{
/** Standard deviation of the scanner blur, mm. Estimates on real data: 0.56 to 0.8, and 0.9 at levels. */
constexpr double UsualBlur = 0.8;

/** Upper bound on squared wall distances (mm^2), which are infinite if the grid has no background. */
constexpr float GreatestSquaredDistance = 1e6F;

/** Margin (mm) that ColonGrid::Widened() rounds up to one voxel. */
constexpr double OneVoxel = 1e-6;

/** Variance of a uniform distribution, such as that of a position within a voxel. */
inline double
UniformVariance(double width)
{
  constexpr double squaresPerVariance = 12.0; // the variance of a uniform distribution is width^2 / 12
  return width * width / squaresPerVariance;
}

/** Geometry of a working grid. The third axis is the image axis closest to the long axis of the patient, so slices are
 * axial; the order of the other two is unchanged. */
struct ColonGrid : VoxelGrid
{
  Eigen::Vector3d    spacing;
  Eigen::Matrix3d    axes;   ///< unit directions in LPS, one per column
  Eigen::Vector3d    origin; ///< center of the first voxel, LPS, mm
  std::array<int, 3> imageAxis{ { 0, 1, 2 } };
  std::array<int, 3> corner{ { 0, 0, 0 } }; ///< first voxel in the whole grid

  Eigen::Vector3d
  Position(const Eigen::Vector3d & voxel) const
  {
    return origin + axes * spacing.cwiseProduct(voxel);
  }
  Eigen::Vector3d
  Position(std::size_t index) const
  {
    const auto v = this->Voxel(index);
    return this->Position(Eigen::Vector3d(v[0], v[1], v[2]));
  }
  /** Continuous index of a point in LPS. */
  Eigen::Vector3d
  VoxelOf(const Eigen::Vector3d & position) const
  {
    return (axes.inverse() * (position - origin)).cwiseQuotient(spacing);
  }
  double
  VoxelVolume() const
  {
    return spacing.prod();
  }
  /** The subgrid in a box. */
  ColonGrid
  Part(const VoxelBox & box) const;
  /** The box with a margin in mm on all sides, clipped to the grid. */
  VoxelBox
  Widened(const VoxelBox & box, double margin) const;
};

using ColonImage = itk::Image<float, 3>;

ColonGrid
GridOfImage(const itk::ImageBase<3> * image);

/** The part of an image that is in a working grid. Values are clamped to [-1100, 32767]; padding and NaN become air. */
VoxelValues
LoadVoxels(const ColonImage * image, const ColonGrid & grid);

/** The part of a working volume that is in a box. */
VoxelValues
CropVoxels(const VoxelValues & voxels, const ColonGrid & grid, const VoxelBox & box);

/** SquaredDistances() of a mask on a working grid. */
VoxelValues
SquaredDistanceToBackground(const ColonGrid &                  grid,
                            const std::vector<unsigned char> & mask,
                            double                             farthest = std::numeric_limits<double>::infinity());

/** Calls `body(indexInImage, indexInGrid)` for all voxels of a part, in parallel over grid slices. */
template <typename TBody>
void
ForEachVoxel(const itk::ImageBase<3> * image, const ColonGrid & grid, const TBody & body)
{
  const auto *               offsets = image->GetOffsetTable();
  std::array<std::size_t, 3> step;
  std::size_t                first = 0;
  for (int a = 0; a < 3; ++a)
  {
    step[a] = static_cast<std::size_t>(offsets[grid.imageAxis[a]]);
    first += step[a] * grid.corner[a];
  }
  ParallelFor(grid.size[2], [&](std::size_t k) {
    for (int j = 0; j < grid.size[1]; ++j)
    {
      std::size_t from = first + j * step[1] + k * step[2];
      std::size_t to = grid.Index(0, j, static_cast<int>(k));
      for (int i = 0; i < grid.size[0]; ++i, from += step[0], ++to)
      {
        body(from, to);
      }
    }
  });
}

/** Mode of soft tissue between -20 and 120 HU; 40 if not found. */
double
ModeOfTissue(const VoxelValues & hu);

/** Moments of blocks of about 5 mm and at least 2 voxels along each axis; incomplete blocks at the upper ends are
 * ignored. */
struct VoxelBlocks
{
  std::array<int, 3>  edge{ { 1, 1, 1 } }; ///< voxels
  VoxelGrid           grid;                ///< of blocks
  std::vector<double> mean;                ///< HU
  std::vector<double> deviation;           ///< standard deviation, HU

  /** Whether the voxels of a row belong to blocks; those beyond the last whole block do not. */
  bool
  HoldRow(int j, int k) const
  {
    return j < edge[1] * grid.size[1] && k < edge[2] * grid.size[2];
  }
};

VoxelBlocks
MeasureBlocks(const ColonGrid & grid, const VoxelValues & hu);

/** Standard deviation of noise in soft tissue: the lower quartile over blocks of about 5 mm with a mean within 60 HU of
 * `tissue`; 0 for fewer than 20 blocks. */
double
NoiseInTissue(const ColonGrid & grid, const VoxelValues & hu, double tissue);

/** Cumulative normal distribution at x standard deviations. */
inline double
NormalDistribution(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

/** SmoothVoxels() with a standard deviation in mm. */
inline void
SmoothVoxels(const ColonGrid & grid, VoxelValues & hu, double sigma)
{
  SmoothVoxels(grid, { { sigma / grid.spacing[0], sigma / grid.spacing[1], sigma / grid.spacing[2] } }, hu.data());
}

/** Contrast (0 to 1) that remains in the middle of a 2 mm wall between two bowels after a prefilter with a sigma of
 * `smoothing` (mm). */
double
ShareInWall(const ColonGrid & grid, double smoothing);

/** Ascending voxel indices of a small subset of a large grid. */
using VoxelSet = std::vector<std::size_t>;

/** Whether `holds(index, squared distance in mm^2)` is true for all voxels in the box with a half width of `reach` mm
 * around a voxel; stops at the first failure. */
template <typename THolds>
bool
ForAllWithin(const ColonGrid & grid, std::size_t voxel, double reach, const THolds & holds)
{
  const auto v = grid.Voxel(voxel);
  const auto box = grid.Widened({ v, { { v[0] + 1, v[1] + 1, v[2] + 1 } } }, reach);
  for (int k = box.low[2]; k < box.high[2]; ++k)
  {
    for (int j = box.low[1]; j < box.high[1]; ++j)
    {
      for (int i = box.low[0]; i < box.high[0]; ++i)
      {
        const Eigen::Vector3d d = Eigen::Vector3d(i - v[0], j - v[1], k - v[2]).cwiseProduct(grid.spacing);
        if (!holds(grid.Index(i, j, k), d.squaredNorm()))
        {
          return false;
        }
      }
    }
  }
  return true;
}

/** Part labels of a set; voxels without an entry form an additional part. */
using VoxelParts = std::unordered_map<std::size_t, int>;

/** Face-connected pieces in the order of their first voxels, each in traversal order. Connections between different
 * parts are ignored. */
std::vector<std::vector<std::size_t>>
ConnectedPieces(const ColonGrid & grid, const VoxelSet & voxels, const VoxelParts & parts = {});

/** Partitions a set at necks, where no ball of this radius (mm) fits into the union of the set and the voxels for which
 * `isOpen` is true. Returns for each voxel the number (from 1) of the nearest wide part, measured within the set; empty
 * if there is no wide part. */
VoxelParts
PartsAtNecks(const ColonGrid &                        grid,
             const VoxelSet &                         voxels,
             double                                   radius,
             const std::function<bool(std::size_t)> & isOpen);

/** A labeled part of a VoxelRuns. */
struct RunPiece
{
  std::size_t voxels{ 0 };
  VoxelBox    box;
};

/** The pieces 1, 2, ... of labeled runs; entry 0 is unused. */
std::vector<RunPiece>
PiecesOfRuns(const VoxelRuns & set, const RunLabels & labels);

/** The voxels of one label in a box of the grid. */
std::vector<unsigned char>
MaskOfRuns(const ColonGrid & grid, const VoxelRuns & set, const RunLabels & labels, int label, const VoxelBox & box);

/** Center and radius of the largest ball in a piece. */
struct DeepestVoxel
{
  std::array<int, 3> voxel{ { 0, 0, 0 } };
  double             radius{ 0.0 }; ///< mm
};

DeepestVoxel
FindDeepestVoxel(const ColonGrid & grid,
                 const VoxelRuns & set,
                 const RunLabels & labels,
                 int               label,
                 const RunPiece &  piece);
} // namespace shapeton

#endif
