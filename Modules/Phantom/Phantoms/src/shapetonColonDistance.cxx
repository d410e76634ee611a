#include "shapetonColonDistance.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
ColonDistance
SphereDistance(const Eigen::Vector3d & point, const Eigen::Vector3d & center, double radius)
{
  const Eigen::Vector3d off = point - center;
  const double          length = std::max(off.norm(), 1e-9);
  return { length - radius, off / length };
}

ColonDistance
CapsuleDistance(const Eigen::Vector3d & point, const Eigen::Vector3d & from, const Eigen::Vector3d & to, double radius)
{
  const Eigen::Vector3d along = to - from;
  const double          t = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return SphereDistance(point, from + t * along, radius);
}

ColonDistance
JoinTissue(const ColonDistance & a, const ColonDistance & b, double fillet)
{
  if (a.value >= fillet || b.value >= fillet)
  {
    return a.value < b.value ? a : b;
  }
  const double  x = fillet - a.value;
  const double  y = fillet - b.value;
  const double  r = std::sqrt(x * x + y * y);
  ColonDistance result{ fillet - r, (x * a.gradient + y * b.gradient) / r };
  // Corrects for adjacent bodies, which are counted twice.
  const double length = result.gradient.norm();
  if (length > 1.0)
  {
    result.gradient /= length;
  }
  return result;
}
} // namespace shapeton
