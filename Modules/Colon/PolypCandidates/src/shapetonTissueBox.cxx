#include "shapetonTissueBox.h"

#include "shapetonExceptions.h"

#include "itkImageRegionConstIterator.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
TissueBox::TissueBox(const PolypLumenImage * lumen, const std::vector<Eigen::Vector3d> & points, double margin)
  : m_Lumen(lumen)
{
  const auto          region = lumen->GetLargestPossibleRegion();
  itk::IndexValueType low[3] = { region.GetUpperIndex()[0], region.GetUpperIndex()[1], region.GetUpperIndex()[2] };
  itk::IndexValueType high[3] = { region.GetIndex(0), region.GetIndex(1), region.GetIndex(2) };
  for (const Eigen::Vector3d & point : points)
  {
    const auto index = lumen->TransformPhysicalPointToContinuousIndex<double>(itk::Point<double, 3>(point.data()));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double reach = margin / lumen->GetSpacing()[axis];
      low[axis] = std::min(low[axis], static_cast<itk::IndexValueType>(std::floor(index[axis] - reach)));
      high[axis] = std::max(high[axis], static_cast<itk::IndexValueType>(std::ceil(index[axis] + reach)));
    }
  }
  PolypLumenImage::SizeType size;
  for (int axis = 0; axis < 3; ++axis)
  {
    m_First[axis] = std::max(low[axis], region.GetIndex(axis));
    const itk::IndexValueType last = std::min(high[axis], region.GetUpperIndex()[axis]);
    if (last < m_First[axis])
    {
      throw InputError("the lumen and the wall do not overlap; use files of the same folder");
    }
    size[axis] = static_cast<itk::SizeValueType>(last - m_First[axis] + 1);
    m_Size[axis] = size[axis];
  }
  m_IsLumen.reserve(this->NumberOfVoxels());
  for (itk::ImageRegionConstIterator<PolypLumenImage> voxel(lumen, { m_First, size }); !voxel.IsAtEnd(); ++voxel)
  {
    m_IsLumen.push_back(voxel.Get() != 0 ? 1 : 0);
  }
  m_Intensities.resize(m_IsLumen.size());
  std::transform(m_IsLumen.begin(), m_IsLumen.end(), m_Intensities.begin(), [](unsigned char isLumen) {
    return isLumen ? 0.0F : 1.0F;
  });
}

std::array<double, 3>
TissueBox::Spacing() const
{
  return { { m_Lumen->GetSpacing()[0], m_Lumen->GetSpacing()[1], m_Lumen->GetSpacing()[2] } };
}

double
TissueBox::LongestSide() const
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, m_Lumen->GetSpacing()[axis] * static_cast<double>(m_Size[axis]));
  }
  return longest;
}

void
TissueBox::TakeIntensities(const itk::Image<float, 3> * ct)
{
  constexpr float gas = -1000.0F, bright = 200.0F; // HU, mapped to 0 and 1; chosen: soft tissue is darker
  if (ct->GetLargestPossibleRegion() != m_Lumen->GetLargestPossibleRegion())
  {
    throw InputError("the cleansed CT and the lumen have different grids; use files of the same folder");
  }
  const itk::Size<3> size = { { m_Size[0], m_Size[1], m_Size[2] } };
  float *            value = m_Intensities.data();
  for (itk::ImageRegionConstIterator<itk::Image<float, 3>> voxel(ct, { m_First, size }); !voxel.IsAtEnd(); ++voxel)
  {
    *value++ = (std::clamp(voxel.Get(), gas, bright) - gas) / (bright - gas);
  }
}

std::vector<unsigned char>
TissueBox::TissueNearLumen(double depth) const
{
  std::vector<unsigned char> isNear = m_IsLumen;
  std::size_t                stride = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto reach = static_cast<std::ptrdiff_t>(std::lround(depth / m_Lumen->GetSpacing()[axis]));
    const auto length = static_cast<std::ptrdiff_t>(m_Size[axis]);
    const std::vector<unsigned char> before = isNear;
    for (std::size_t voxel = 0; voxel < before.size(); ++voxel)
    {
      if (before[voxel])
      {
        const auto place = static_cast<std::ptrdiff_t>(voxel / stride % m_Size[axis]);
        for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(-reach, -place); k <= reach && place + k < length; ++k)
        {
          isNear[voxel + k * static_cast<std::ptrdiff_t>(stride)] = 1;
        }
      }
    }
    stride *= m_Size[axis];
  }
  for (std::size_t voxel = 0; voxel < isNear.size(); ++voxel)
  {
    isNear[voxel] = isNear[voxel] && !m_IsLumen[voxel];
  }
  return isNear;
}

std::ptrdiff_t
TissueBox::VoxelAt(const Eigen::Vector3d & point) const
{
  const auto     index = m_Lumen->TransformPhysicalPointToIndex(itk::Point<double, 3>(point.data()));
  std::ptrdiff_t voxel = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const itk::IndexValueType place = index[axis] - m_First[axis];
    if (place < 0 || place >= static_cast<itk::IndexValueType>(m_Size[axis]))
    {
      return -1;
    }
    voxel = voxel * static_cast<std::ptrdiff_t>(m_Size[axis]) + place;
  }
  return voxel;
}

double
TissueBox::MeanAt(const std::vector<float> & values, const std::vector<Eigen::Vector3d> & points) const
{
  double sum = 0.0;
  int    number = 0;
  for (const Eigen::Vector3d & point : points)
  {
    const std::ptrdiff_t voxel = this->VoxelAt(point);
    if (voxel >= 0 && !m_IsLumen[voxel])
    {
      sum += values[voxel];
      ++number;
    }
  }
  return number > 0 ? sum / number : 0.0;
}
} // namespace shapeton
