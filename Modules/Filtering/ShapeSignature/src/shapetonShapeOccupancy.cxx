#include "shapetonShapeOccupancy.h"

#include "shapetonExceptions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

namespace shapeton
{
namespace
{
/** Limits the filled fractions to half a gigabyte. */
constexpr double MostVoxels = 1 << 27;

/** Affine map from image indices to LPS mm: p = origin + matrix * index. */
struct IndexToPoint
{
  Eigen::Matrix3d matrix;
  Eigen::Vector3d origin;

  explicit IndexToPoint(const itk::ImageBase<3> * image)
  {
    const auto &          direction = image->GetDirection();
    const auto            start = image->GetBufferedRegion().GetIndex();
    itk::Point<double, 3> first;
    image->TransformIndexToPhysicalPoint(start, first);
    for (int row = 0; row < 3; ++row)
    {
      origin[row] = first[row];
      for (int column = 0; column < 3; ++column)
      {
        matrix(row, column) = direction(row, column) * image->GetSpacing()[column];
      }
    }
  }
};

template <typename TBody>
void
ForEachVoxel(const VoxelRuns & shape, const TBody & body)
{
  ForEachRun(shape, [&](std::size_t run, int j, int k) {
    for (int i = shape.runs[run].begin; i < shape.runs[run].end; ++i)
    {
      body(Eigen::Vector3d(i, j, k));
    }
  });
}

/** Quadratic B-spline around 0: the weight at a given distance in voxels. */
double
QuadraticSpline(double x)
{
  const double     distance = std::abs(x);
  constexpr double peak = 0.75, reach = 1.5;
  return distance < 0.5 ? peak - distance * distance : 0.5 * (reach - distance) * (reach - distance);
}

/** A point mass in the neighborhood of a voxel, in units of its grid. */
struct MassPoint
{
  double offset;
  double mass;
};

/** Number of points along an axis that represent a voxel: at least two per voxel of the finer grid. A much smaller
 * voxel is a single point. */
std::vector<MassPoint>
PointsOfVoxel(double voxelsOfGrid)
{
  if (voxelsOfGrid <= 0.25)
  {
    return { { 0.0, 1.0 } };
  }
  const int              pointsOfVoxel = static_cast<int>(std::ceil(2.0 * voxelsOfGrid));
  std::vector<MassPoint> points;
  for (int i = 0; i < 3 * pointsOfVoxel; ++i) // an integer per voxel: the masses of neighbors sum to 1 everywhere
  {
    const double offset = (i + 0.5) / pointsOfVoxel - 1.5;
    points.push_back({ offset, QuadraticSpline(offset) / pointsOfVoxel });
  }
  return points;
}

/** Distributes a mass to the voxels around a point, with trilinear weights. */
void
AddMass(const Eigen::Vector3d & place, double mass, ShapeOccupancy & occupancy)
{
  const int             i = static_cast<int>(place[0]), j = static_cast<int>(place[1]), k = static_cast<int>(place[2]);
  const Eigen::Vector3d high = place - Eigen::Vector3d(i, j, k);
  const Eigen::Vector3d low = Eigen::Vector3d::Ones() - high;
  const auto &          stride = occupancy.grid.stride;
  float *               corner = occupancy.values.data() + occupancy.grid.Index(i, j, k);
  for (int c = 0; c < 4; ++c)
  {
    const bool   isNextRow = (c & 1) != 0, isNextSlice = (c & 2) != 0;
    const double share = mass * (isNextRow ? high[1] : low[1]) * (isNextSlice ? high[2] : low[2]);
    float *      row = corner + (isNextRow ? stride[1] : 0) + (isNextSlice ? stride[2] : 0);
    row[0] += static_cast<float>(share * low[0]);
    row[1] += static_cast<float>(share * high[0]);
  }
}

/** The offsets and masses of the points that represent each voxel, in units of the finer grid. */
std::vector<std::pair<Eigen::Vector3d, double>>
SpreadOfVoxel(const Eigen::Matrix3d & toGrid)
{
  std::array<std::vector<MassPoint>, 3> points;
  for (int axis = 0; axis < 3; ++axis)
  {
    points[axis] = PointsOfVoxel(toGrid.col(axis).norm());
  }
  const double                                    volume = std::abs(toGrid.determinant());
  std::vector<std::pair<Eigen::Vector3d, double>> spread;
  for (const MassPoint & z : points[2])
  {
    for (const MassPoint & y : points[1])
    {
      for (const MassPoint & x : points[0])
      {
        spread.emplace_back(toGrid * Eigen::Vector3d(x.offset, y.offset, z.offset), x.mass * y.mass * z.mass * volume);
      }
    }
  }
  return spread;
}

/** The grid that covers `low` to `high`, with a border. */
VoxelGrid
GridBetween(const Eigen::Vector3d & low, const Eigen::Vector3d & high)
{
  const Eigen::Vector3d extent = high - low;
  if ((extent.array() + 4.0).prod() > MostVoxels)
  {
    throw InputError("the shape is so thin for its length that a grid that resolves it does not fit into memory");
  }
  return VoxelGrid(static_cast<int>(extent[0]) + 4, static_cast<int>(extent[1]) + 4, static_cast<int>(extent[2]) + 4);
}
} // namespace

ShapeMoments
MomentsOf(const VoxelRuns & shape, const itk::ImageBase<3> * image)
{
  double          voxels = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  ForEachVoxel(shape, [&](const Eigen::Vector3d & index) {
    voxels += 1.0;
    sum += index;
  });
  const Eigen::Vector3d mean = sum / voxels;
  Eigen::Matrix3d       covariance = Eigen::Matrix3d::Zero();
  ForEachVoxel(shape,
               [&](const Eigen::Vector3d & index) { covariance += (index - mean) * (index - mean).transpose(); });
  constexpr double perVariance = 12.0; // a voxel is a box, a uniform distribution of width 1
  covariance = covariance / voxels + Eigen::Matrix3d::Identity() / perVariance;

  const IndexToPoint toPoint(image);
  ShapeMoments       moments;
  moments.volume = voxels * std::abs(toPoint.matrix.determinant());
  moments.center = toPoint.origin + toPoint.matrix * mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(toPoint.matrix * covariance * toPoint.matrix.transpose());
  moments.deviations = solver.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
  moments.axes = solver.eigenvectors().rowwise().reverse();
  if (moments.axes.determinant() < 0.0)
  {
    moments.axes.col(2) *= -1.0;
  }
  return moments;
}

ShapeOccupancy
OccupancyOf(const VoxelRuns & shape, const itk::ImageBase<3> * image, const ShapeMoments & moments, double spacing)
{
  const IndexToPoint    toPoint(image);
  const Eigen::Matrix3d toGrid = moments.axes.transpose() * toPoint.matrix / spacing;
  const Eigen::Vector3d center = moments.axes.transpose() * (toPoint.origin - moments.center) / spacing;
  const auto            placeOf = [&](const Eigen::Vector3d & index) { return (center + toGrid * index).eval(); };

  Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300), high = -low;
  ForEachRun(shape, [&](std::size_t run, int j, int k) {
    for (const int i : { shape.runs[run].begin, shape.runs[run].end - 1 })
    {
      low = low.cwiseMin(placeOf(Eigen::Vector3d(i, j, k)));
      high = high.cwiseMax(placeOf(Eigen::Vector3d(i, j, k)));
    }
  });
  const Eigen::Vector3d reach = 1.5 * toGrid.cwiseAbs().rowwise().sum();
  low -= reach;
  high += reach;

  ShapeOccupancy occupancy;
  occupancy.grid = GridBetween(low, high);
  occupancy.values.assign(occupancy.grid.NumberOfVoxels(), 0.0F);
  const auto            spread = SpreadOfVoxel(toGrid);
  const Eigen::Vector3d first = low - Eigen::Vector3d::Ones();
  ForEachVoxel(shape, [&](const Eigen::Vector3d & index) {
    const Eigen::Vector3d place = placeOf(index) - first;
    for (const auto & point : spread)
    {
      AddMass(place + point.first, point.second, occupancy);
    }
  });
  return occupancy;
}
} // namespace shapeton
