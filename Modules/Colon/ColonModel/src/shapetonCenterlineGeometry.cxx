#include "shapetonCenterlineGeometry.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
GridGeometry::GridGeometry(const itk::ImageBase<3> * image)
{
  const auto                   first = image->GetBufferedRegion().GetIndex();
  itk::ImageBase<3>::PointType point;
  image->TransformIndexToPhysicalPoint(first, point);
  for (int i = 0; i < 3; ++i)
  {
    origin[i] = point[i];
    spacing[i] = image->GetSpacing()[i];
    for (int k = 0; k < 3; ++k)
    {
      matrix(i, k) = image->GetDirection()(i, k) * image->GetSpacing()[k];
    }
  }
  inverse = matrix.inverse();
}

void
ForVoxelsOfSegment(const GridGeometry &                             grid,
                   const itk::Size<3> &                             size,
                   const Eigen::Vector3d &                          a,
                   const Eigen::Vector3d &                          b,
                   const std::function<void(std::array<long, 3>)> & body)
{
  // Amanatides, Woo: A fast voxel traversal algorithm for ray tracing (1987).
  const Eigen::Vector3d begin = grid.IndexOf(a);
  const Eigen::Vector3d way = grid.IndexOf(b) - begin;
  std::array<long, 3>   voxel;
  std::array<long, 3>   last;
  Eigen::Vector3d       next;
  for (int i = 0; i < 3; ++i)
  {
    voxel[i] = std::lround(begin[i]);
    last[i] = std::lround(begin[i] + way[i]);
    const double border = static_cast<double>(voxel[i]) + (way[i] > 0.0 ? 0.5 : -0.5);
    next[i] = way[i] == 0.0 ? std::numeric_limits<double>::infinity() : (border - begin[i]) / way[i];
  }
  long steps = std::labs(last[0] - voxel[0]) + std::labs(last[1] - voxel[1]) + std::labs(last[2] - voxel[2]);
  for (;; --steps)
  {
    bool isInside = true;
    for (int i = 0; i < 3; ++i)
    {
      isInside = isInside && voxel[i] >= 0 && voxel[i] < static_cast<long>(size[i]);
    }
    if (isInside)
    {
      body(voxel);
    }
    if (steps == 0)
    {
      return;
    }
    int axis = 0;
    next.minCoeff(&axis);
    voxel[axis] += way[axis] > 0.0 ? 1 : -1;
    next[axis] += std::abs(1.0 / way[axis]);
  }
}
} // namespace shapeton
