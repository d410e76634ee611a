#include "shapetonLumenLabels.h"

#include "itkImageRegionIterator.h"
#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using LabelImageType = itk::Image<unsigned char, 3>;
using RegionType = itk::ImageRegion<3>;

// Away from the wall distances may be too large by a factor, so only blocks of half the reach are classified by their
// center.
bool
MissesLumen(const ColonAnatomy & anatomy, const RegionType & block, const LabelImageType * lumen)
{
  itk::ContinuousIndex<double, 3> middle;
  double                          squared = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto steps = static_cast<double>(block.GetSize(i)) - 1.0;
    middle[i] = static_cast<double>(block.GetIndex(i)) + 0.5 * steps;
    squared += 0.25 * steps * steps * lumen->GetSpacing()[i] * lumen->GetSpacing()[i];
  }
  const double radius = 1.001 * std::sqrt(squared);
  if (radius >= 0.5 * ColonAnatomy::Reach)
  {
    return false;
  }
  itk::Point<double, 3> center;
  lumen->TransformContinuousIndexToPhysicalPoint(middle, center);
  return anatomy.Evaluate({ center[0], center[1], center[2] }).distance <= -ColonAnatomy::Reach;
}
} // namespace

void
FillLumenLabels(const ColonAnatomy & anatomy,
                const ColonFluid &   fluid,
                const RegionType &   region,
                LabelImageType *     lumen,
                LabelImageType *     segments)
{
  if (MissesLumen(anatomy, region, lumen))
  {
    return;
  }
  const auto size = region.GetSize();
  const auto axis = static_cast<unsigned int>(std::max_element(size.begin(), size.end()) - size.begin());
  if (size[axis] > 4)
  {
    RegionType half = region;
    half.SetSize(axis, size[axis] / 2);
    FillLumenLabels(anatomy, fluid, half, lumen, segments);
    half.SetSize(axis, size[axis] - size[axis] / 2);
    half.SetIndex(axis, region.GetIndex(axis) + static_cast<itk::IndexValueType>(size[axis] / 2));
    FillLumenLabels(anatomy, fluid, half, lumen, segments);
    return;
  }
  itk::ImageRegionIteratorWithIndex<LabelImageType> label(lumen, region);
  itk::ImageRegionIterator<LabelImageType>          segment(segments, region);
  for (; !label.IsAtEnd(); ++label, ++segment)
  {
    itk::Point<double, 3> p;
    lumen->TransformIndexToPhysicalPoint(label.GetIndex(), p);
    const Eigen::Vector3d point(p[0], p[1], p[2]);
    const auto            sample = anatomy.Evaluate(point);
    if (sample.distance > 0.0)
    {
      label.Set(fluid.DepthBelowLevel(point, sample.arcLength) > 0.0 ? 2 : 1);
      segment.Set(static_cast<unsigned char>(sample.segment));
    }
  }
}
} // namespace shapeton
