#ifndef shapetonLumenShapes_h
#define shapetonLumenShapes_h

#include "shapetonCurveSet.h"
#include "shapetonLumenTopology.h"
#include "shapetonTestFrames.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>

/** Lumens defined by the signed distance to the wall, mm, positive inside. */
namespace lumenshapes
{
constexpr double Pi = 3.14159265358979323846;
using Depth = std::function<double(const Eigen::Vector3d &)>;
using Points = std::vector<Eigen::Vector3d>;

struct Grid
{
  Eigen::Matrix3d direction{ Eigen::Matrix3d::Identity() };
  Eigen::Vector3d spacing{ 1.0, 1.0, 1.0 };
};

inline Grid
ObliqueGrid(bool isLeftHanded)
{
  Grid grid;
  grid.direction = Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  grid.spacing = { 0.8, 0.9, 1.3 };
  if (isLeftHanded)
  {
    grid.direction.col(1) *= -1.0;
  }
  return grid;
}

/** The field 0.5 + depth / width, clamped to [0, 1], on a grid around a shape. Linear near the wall if the width is at
 * least two voxels. */
inline shapeton::OccupancyImage::Pointer
Occupancy(const Depth & depth, const Eigen::AlignedBox3d & box, const Grid & grid = {}, double width = 3.0)
{
  Eigen::AlignedBox3d inner;
  for (int corner = 0; corner < 8; ++corner)
  {
    inner.extend(grid.direction.transpose() * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
  shapeton::OccupancyImage::SizeType size;
  const Eigen::Vector3d              first = inner.min() - 3.0 * grid.spacing;
  for (int i = 0; i < 3; ++i)
  {
    size[i] = static_cast<unsigned int>(std::ceil((inner.max()[i] - first[i]) / grid.spacing[i])) + 4;
  }
  const auto image =
    basetest::NewImageInFrame<shapeton::OccupancyImage>(size, grid.spacing, grid.direction * first, grid.direction);
  basetest::Sample(image.GetPointer(), [&](const auto & point) {
    return std::clamp(0.5 + depth(basetest::ToEigen(point)) / width, 0.0, 1.0);
  });
  return image;
}

inline Depth
Sphere(const Eigen::Vector3d & center, double radius)
{
  return [=](const Eigen::Vector3d & p) { return radius - (p - center).norm(); };
}

/** Shapes in a plane z = const. */
inline Depth
Torus(const Eigen::Vector3d & center, double ring, double radius)
{
  return [=](const Eigen::Vector3d & p) {
    const Eigen::Vector3d q = p - center;
    return radius - std::hypot(std::hypot(q[0], q[1]) - ring, q[2]);
  };
}

/** A tube with round ends along a polyline. */
inline Depth
Tube(const Points & axis, double radius)
{
  return [=](const Eigen::Vector3d & p) {
    double square = 1e300;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    {
      const Eigen::Vector3d way = axis[i + 1] - axis[i];
      const double          share = std::clamp((p - axis[i]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      square = std::min(square, (p - axis[i] - share * way).squaredNorm());
    }
    return radius - std::sqrt(square);
  };
}

inline Depth
Union(const Depth & a, const Depth & b)
{
  return [=](const Eigen::Vector3d & p) { return std::max(a(p), b(p)); };
}

inline Depth
Without(const Depth & a, const Depth & b)
{
  return [=](const Eigen::Vector3d & p) { return std::min(a(p), -b(p)); };
}

inline Points
Line(const Eigen::Vector3d & a, const Eigen::Vector3d & b, double step = 1.0)
{
  Points    points;
  const int steps = static_cast<int>(std::ceil((b - a).norm() / step));
  for (int i = 0; i <= steps; ++i)
  {
    points.emplace_back(a + (b - a) * i / steps);
  }
  return points;
}

/** Two parallel legs at x = 0 and x = distance from z = 0 to `length`, joined there by a semicircle. */
inline Points
UTurn(double length, double distance)
{
  Points    points = Line({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, length - 2.0 }, 2.0);
  const int steps = 24;
  for (int i = 0; i <= steps; ++i)
  {
    const double angle = Pi * i / steps;
    points.emplace_back(0.5 * distance * (1.0 - std::cos(angle)), 0.0, length + 0.5 * distance * std::sin(angle));
  }
  const Points back = Line({ distance, 0.0, length - 2.0 }, { distance, 0.0, 0.0 }, 2.0);
  points.insert(points.end(), back.begin(), back.end());
  return points;
}

/** A centerline with arrays arcLength, radius and gap; `isGap` selects the points in a gap. */
inline shapeton::CurveSet
Centerline(const Points & points, const std::function<bool(const Eigen::Vector3d &)> & isGap = {})
{
  shapeton::CurveSet curves;
  const auto         n = static_cast<Eigen::Index>(points.size());
  curves.V.resize(n, 3);
  curves.curves.resize(1);
  shapeton::SurfaceArray arcLength{ "arcLength", shapeton::SurfaceArray::ValueMatrix::Zero(n, 1), false };
  shapeton::SurfaceArray radius{ "radius", shapeton::SurfaceArray::ValueMatrix::Ones(n, 1), false };
  shapeton::SurfaceArray gap{ "gap", shapeton::SurfaceArray::ValueMatrix::Zero(n, 1), true };
  for (Eigen::Index i = 0; i < n; ++i)
  {
    curves.V.row(i) = points[i];
    curves.curves[0].push_back(static_cast<int>(i));
    arcLength.values(i, 0) = i == 0 ? 0.0 : arcLength.values(i - 1, 0) + (points[i] - points[i - 1]).norm();
    gap.values(i, 0) = isGap && isGap(points[i]) ? 1.0 : 0.0;
  }
  curves.pointArrays = { arcLength, radius, gap };
  return curves;
}

inline Eigen::AlignedBox3d
BoxOf(const Points & points, double margin)
{
  Eigen::AlignedBox3d box;
  for (const auto & point : points)
  {
    box.extend(point);
  }
  const Eigen::Vector3d around = Eigen::Vector3d::Constant(margin);
  return { box.min() - around, box.max() + around };
}
} // namespace lumenshapes

#endif
