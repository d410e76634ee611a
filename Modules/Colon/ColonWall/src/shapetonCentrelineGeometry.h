#ifndef shapetonCentrelineGeometry_h
#define shapetonCentrelineGeometry_h

#include "shapetonCurveSet.h"
#include "shapetonLumenTopology.h"

#include <functional>

namespace shapeton
{
/** Positions of a grid: p = origin + matrix * index, index of the buffer (from 0 on). */
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

/** Calls `body(x, y, z)` for the voxels of the image that a polyline from a to b passes, in order, each next one a
 * neighbour by a face. */
void
ForVoxelsOfSegment(const GridGeometry &                             grid,
                   const itk::Size<3> &                             size,
                   const Eigen::Vector3d &                          a,
                   const Eigen::Vector3d &                          b,
                   const std::function<void(std::array<long, 3>)> & body);
} // namespace shapeton

#endif
