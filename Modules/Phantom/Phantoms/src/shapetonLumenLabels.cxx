#include "shapetonLumenLabels.h"

#include "itkImageRegionIterator.h"
#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
LumenLabels::LumenLabels(const ColonAnatomy & anatomy,
                         const ColonFluid &   fluid,
                         LabelImageType *     lumen,
                         LabelImageType *     segments)
  : m_Anatomy(anatomy), m_Fluid(fluid), m_Lumen(lumen), m_Segments(segments)
{}

// Away from the wall distances may be too large by a factor, so only blocks of half the reach are classified by their
// center.
bool
LumenLabels::MissesLumen(const RegionType & block) const
{
  itk::ContinuousIndex<double, 3> middle;
  double                          squared = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto steps = static_cast<double>(block.GetSize(i)) - 1.0;
    middle[i] = static_cast<double>(block.GetIndex(i)) + 0.5 * steps;
    squared += 0.25 * steps * steps * m_Lumen->GetSpacing()[i] * m_Lumen->GetSpacing()[i];
  }
  const double radius = 1.001 * std::sqrt(squared);
  if (radius >= 0.5 * ColonAnatomy::Reach)
  {
    return false;
  }
  itk::Point<double, 3> center;
  m_Lumen->TransformContinuousIndexToPhysicalPoint(middle, center);
  return m_Anatomy.Evaluate({ center[0], center[1], center[2] }).distance <= -ColonAnatomy::Reach;
}

void
LumenLabels::Fill(const RegionType & region) const
{
  const auto size = region.GetSize();
  const auto axis = static_cast<unsigned int>(std::max_element(size.begin(), size.end()) - size.begin());
  if (this->MissesLumen(region))
  {
    itk::ImageRegionIterator<LabelImageType> lumen(m_Lumen, region);
    itk::ImageRegionIterator<LabelImageType> segment(m_Segments, region);
    for (; !lumen.IsAtEnd(); ++lumen, ++segment)
    {
      lumen.Set(0);
      segment.Set(0);
    }
    return;
  }
  if (size[axis] <= 4)
  {
    this->FillVoxels(region);
    return;
  }
  RegionType lower = region;
  lower.SetSize(axis, size[axis] / 2);
  RegionType upper = region;
  upper.SetSize(axis, size[axis] - size[axis] / 2);
  upper.SetIndex(axis, region.GetIndex(axis) + static_cast<itk::IndexValueType>(size[axis] / 2));
  this->Fill(lower);
  this->Fill(upper);
}

void
LumenLabels::FillVoxels(const RegionType & block) const
{
  itk::ImageRegionIteratorWithIndex<LabelImageType> lumen(m_Lumen, block);
  itk::ImageRegionIterator<LabelImageType>          segment(m_Segments, block);
  for (; !lumen.IsAtEnd(); ++lumen, ++segment)
  {
    itk::Point<double, 3> p;
    m_Lumen->TransformIndexToPhysicalPoint(lumen.GetIndex(), p);
    const Eigen::Vector3d point(p[0], p[1], p[2]);
    const auto            sample = m_Anatomy.Evaluate(point);
    const bool            inside = sample.distance > 0.0;
    const bool            wet = inside && m_Fluid.DepthBelowLevel(point, sample.arcLength) > 0.0;
    lumen.Set(inside ? (wet ? 2 : 1) : 0);
    segment.Set(static_cast<unsigned char>(inside ? sample.segment : 0));
  }
}
} // namespace shapeton
