#ifndef shapetonOccupancySampling_h
#define shapetonOccupancySampling_h

#include "shapetonCenterlineGeometry.h"

#include <cmath>

namespace shapeton
{
/** Trilinear interpolation of an occupancy; 0 outside the image. */
class OccupancySampler
{
public:
  explicit OccupancySampler(const OccupancyImage * image)
    : m_Grid(image), m_Size(image->GetBufferedRegion().GetSize()), m_Values(image->GetBufferPointer())
  {}

  double
  operator()(const Eigen::Vector3d & point) const
  {
    const Eigen::Vector3d index = m_Grid.IndexOf(point);
    const Eigen::Vector3d low = index.array().floor();
    const Eigen::Vector3d share = index - low;
    double                sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      long   voxel[3];
      for (int i = 0; i < 3; ++i)
      {
        const int step = corner >> i & 1;
        voxel[i] = std::lround(low[i]) + step;
        weight *= step == 1 ? share[i] : 1.0 - share[i];
      }
      sum += weight * this->ValueAt(voxel);
    }
    return sum;
  }

private:
  double
  ValueAt(const long (&voxel)[3]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      if (voxel[i] < 0 || voxel[i] >= static_cast<long>(m_Size[i]))
      {
        return 0.0;
      }
    }
    return m_Values[(static_cast<std::size_t>(voxel[2]) * m_Size[1] + voxel[1]) * m_Size[0] + voxel[0]];
  }

  GridGeometry  m_Grid;
  itk::Size<3>  m_Size;
  const float * m_Values;
};
} // namespace shapeton

#endif
