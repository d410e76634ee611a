#ifndef shapetonCenterlineGeometry_h
#define shapetonCenterlineGeometry_h

#include "shapetonCurveSet.h"
#include "shapetonLumenTopology.h"

#include <functional>

namespace shapeton
{
/** Transform from buffer index (from 0) to position: p = origin + matrix * index. */
struct GridGeometry
{
  Eigen::Matrix3d matrix;
  Eigen::Matrix3d inverse;
  Eigen::Vector3d origin;
  Eigen::Vector3d spacing;

  explicit GridGeometry(const itk::ImageBase<3> * image);
  Eigen::Vector3d
  PointOf(const Eigen::Vector3d & index) const
  {
    return origin + matrix * index;
  }
  Eigen::Vector3d
  IndexOf(const Eigen::Vector3d & point) const
  {
    return inverse * (point - origin);
  }
};

/** Calls `body(x, y, z)` in order for the face-connected voxels of the image on the line from a to b. */
void
ForVoxelsOfSegment(const GridGeometry &                             grid,
                   const itk::Size<3> &                             size,
                   const Eigen::Vector3d &                          a,
                   const Eigen::Vector3d &                          b,
                   const std::function<void(std::array<long, 3>)> & body);
} // namespace shapeton

#endif
