#ifndef shapetonTrilinearVolume_h
#define shapetonTrilinearVolume_h

#include "itkImage.h"

#include <Eigen/LU>

#include <algorithm>

namespace shapeton
{
/** A volume between its voxels, by indices that stand for points in space: along a ray they are steps of a vector. */
class TrilinearVolume
{
public:
  explicit TrilinearVolume(const itk::Image<float, 3> * image) : m_Image(image), m_Voxels(image->GetBufferPointer())
  {
    const auto &    size = image->GetLargestPossibleRegion().GetSize();
    const auto &    first = image->GetLargestPossibleRegion().GetIndex();
    const auto &    direction = image->GetDirection();
    const auto &    spacing = image->GetSpacing();
    Eigen::Matrix3d axes; // columns: a step of each index in space
    for (int k = 0; k < 3; ++k)
    {
      m_Size[k] = static_cast<int>(size[k]);
      m_Stride[k] = k == 0 ? 1 : m_Stride[k - 1] * m_Size[k - 1];
      for (int row = 0; row < 3; ++row)
      {
        axes(row, k) = direction[row][k] * spacing[k];
      }
    }
    m_ToIndex = axes.inverse();
    itk::Point<double, 3> origin;
    image->TransformIndexToPhysicalPoint(first, origin);
    m_Origin = Eigen::Vector3d(origin[0], origin[1], origin[2]);
    m_SmallestSpacing = std::min({ spacing[0], spacing[1], spacing[2] });
    m_GradientStep = m_SmallestSpacing * m_ToIndex.rowwise().norm();
  }

  double
  SmallestSpacing() const
  {
    return m_SmallestSpacing;
  }
  /** From (0, 0, 0) in the middle of the first voxel on. */
  Eigen::Vector3d
  IndexOf(const Eigen::Vector3d & point) const
  {
    return m_ToIndex * (point - m_Origin);
  }
  Eigen::Vector3d
  IndexOfVector(const Eigen::Vector3d & vector) const
  {
    return m_ToIndex * vector;
  }
  bool
  Holds(const Eigen::Vector3d & index) const
  {
    return index.minCoeff() >= -0.5 && index.x() <= m_Size[0] - 0.5 && index.y() <= m_Size[1] - 0.5 &&
           index.z() <= m_Size[2] - 0.5;
  }
  /** Whether a ball around this place, `radius` mm, lies within the voxels' middles. */
  bool
  HoldsBall(const Eigen::Vector3d & index, double radius) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const double margin = radius * m_ToIndex.row(k).norm();
      if (index[k] - margin < 0.0 || index[k] + margin >= m_Size[k] - 1.0)
      {
        return false;
      }
    }
    return true;
  }
  /** Beyond the border what is at the border; with `IsInside` the place must lie within the voxels' middles. */
  template <bool IsInside>
  float
  At(const Eigen::Vector3d & index) const
  {
    const float *  corner = m_Voxels;
    double         share[3];
    std::ptrdiff_t next[3]; // to the voxels on the other side; 0 in the last ones
    for (int k = 0; k < 3; ++k)
    {
      const double place = IsInside ? index[k] : std::clamp(index[k], 0.0, m_Size[k] - 1.0);
      const int    voxel = static_cast<int>(place);
      share[k] = place - voxel;
      next[k] = IsInside || voxel + 1 < m_Size[k] ? m_Stride[k] : 0;
      corner += voxel * m_Stride[k];
    }
    const auto alongX = [&](const float * from) { return from[0] + (double{ from[next[0]] } - from[0]) * share[0]; };
    const auto alongY = [&](const float * from) {
      const double low = alongX(from);
      return low + (alongX(from + next[1]) - low) * share[1];
    };
    const double low = alongY(corner);
    return static_cast<float>(low + (alongY(corner + next[2]) - low) * share[2]);
  }
  /** In space, per mm: differences over a smallest spacing to both sides along each axis of the volume. */
  template <bool IsInside>
  Eigen::Vector3d
  GradientAt(const Eigen::Vector3d & index) const
  {
    Eigen::Vector3d ofIndex;
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d step = m_GradientStep[k] * Eigen::Vector3d::Unit(k);
      ofIndex[k] = (this->At<IsInside>(index + step) - this->At<IsInside>(index - step)) / (2.0 * step[k]);
    }
    return m_ToIndex.transpose() * ofIndex;
  }

private:
  itk::Image<float, 3>::ConstPointer m_Image;
  const float *                      m_Voxels;
  Eigen::Matrix3d                    m_ToIndex;
  Eigen::Vector3d                    m_Origin;
  Eigen::Vector3d                    m_GradientStep; ///< of each index, a smallest spacing long
  int                                m_Size[3];
  std::ptrdiff_t                     m_Stride[3];
  double                             m_SmallestSpacing;
};
} // namespace shapeton

#endif
