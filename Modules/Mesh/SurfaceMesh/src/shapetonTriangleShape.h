#ifndef shapetonTriangleShape_h
#define shapetonTriangleShape_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** Normal vector whose length is twice the area. */
inline Eigen::Vector3d
DoubleAreaNormal(const Eigen::Vector3d & a, const Eigen::Vector3d & b, const Eigen::Vector3d & c)
{
  return (b - a).cross(c - a);
}

/** The angle at `a` in radians; 0 if a side has zero length. */
inline double
AngleAt(const Eigen::Vector3d & a, const Eigen::Vector3d & b, const Eigen::Vector3d & c)
{
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/** Cosine of the smallest angle, opposite to the shortest side; 1 for a zero-area triangle. */
inline double
CosineOfSmallestAngle(const Eigen::Vector3d & a, const Eigen::Vector3d & b, const Eigen::Vector3d & c)
{
  double x = (b - a).squaredNorm();
  double y = (c - b).squaredNorm();
  double z = (a - c).squaredNorm();
  if (y < x)
  {
    std::swap(x, y);
  }
  if (z < x)
  {
    std::swap(x, z);
  }
  const double product = y * z;
  return product > 0.0 ? std::min((y + z - x) / (2.0 * std::sqrt(product)), 1.0) : 1.0;
}

/** Longest side over the inscribed diameter, scaled to 1 for an equilateral triangle; infinity for zero area. */
inline double
AspectRatio(const Eigen::Vector3d & a, const Eigen::Vector3d & b, const Eigen::Vector3d & c)
{
  const double x = (b - a).norm();
  const double y = (c - b).norm();
  const double z = (a - c).norm();
  const double doubleArea = DoubleAreaNormal(a, b, c).norm();
  return std::max({ x, y, z }) * (x + y + z) / (2.0 * std::sqrt(3.0) * doubleArea);
}
} // namespace shapeton

#endif
