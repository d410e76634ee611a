#include "shapetonImageGrid.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
bool
HaveSameGrid(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b)
{
  const itk::ImageRegion<3> regionA = a->GetLargestPossibleRegion();
  const itk::ImageRegion<3> regionB = b->GetLargestPossibleRegion();
  if (regionA.GetSize() != regionB.GetSize())
  {
    return false;
  }
  const auto & spacing = a->GetSpacing();
  const double tolerance = 0.01 * std::min({ std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2]) });
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    itk::Offset<3> offset;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      offset[axis] = (corner >> axis) & 1U ? static_cast<itk::OffsetValueType>(regionA.GetSize(axis)) - 1 : 0;
    }
    itk::ImageBase<3>::PointType pointA;
    itk::ImageBase<3>::PointType pointB;
    a->TransformIndexToPhysicalPoint(regionA.GetIndex() + offset, pointA);
    b->TransformIndexToPhysicalPoint(regionB.GetIndex() + offset, pointB);
    if (pointA.EuclideanDistanceTo(pointB) > tolerance)
    {
      return false;
    }
  }
  return true;
}
} // namespace shapeton
