#include "shapetonStartRegion.h"

#include "itkImageRegionIterator.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** The bounding box of a ball in voxels, clipped to the volume. */
itk::ImageRegion<3>
BoxOf(const itk::ImageBase<3> * image, const Ball & ball)
{
  itk::ContinuousIndex<double, 3> middle;
  image->TransformPhysicalPointToContinuousIndex(ball.center, middle);
  const auto          region = image->GetLargestPossibleRegion();
  itk::ImageRegion<3> box;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double reach = ball.radius / image->GetSpacing()[axis];
    const auto   first = static_cast<double>(region.GetIndex(axis));
    const auto   last = first + static_cast<double>(region.GetSize(axis)) - 1.0;
    const double low = std::clamp(std::floor(middle[axis] - reach), first, last);
    const double high = std::clamp(std::ceil(middle[axis] + reach), first, last);
    box.SetIndex(axis, static_cast<itk::IndexValueType>(low));
    box.SetSize(axis, static_cast<itk::SizeValueType>(high - low) + 1);
  }
  return box;
}
} // namespace

StartMask::Pointer
MaskOfBalls(const itk::ImageBase<3> * image, const std::vector<Ball> & balls)
{
  const auto mask = NewImageOn<StartMask>(image, true);
  bool       isEmpty = true;
  for (const Ball & ball : balls)
  {
    const auto    box = BoxOf(image, ball);
    itk::Index<3> index;
    for (std::size_t i = 0; i < box.GetNumberOfPixels(); ++i)
    {
      const std::size_t row = i / box.GetSize(0);
      index[0] = box.GetIndex(0) + static_cast<itk::IndexValueType>(i % box.GetSize(0));
      index[1] = box.GetIndex(1) + static_cast<itk::IndexValueType>(row % box.GetSize(1));
      index[2] = box.GetIndex(2) + static_cast<itk::IndexValueType>(row / box.GetSize(1));
      itk::Point<double, 3> point;
      image->TransformIndexToPhysicalPoint(index, point);
      if (point.EuclideanDistanceTo(ball.center) <= ball.radius)
      {
        mask->SetPixel(index, 1);
        isEmpty = false;
      }
    }
  }
  return isEmpty ? nullptr : mask;
}

StartMask::Pointer
MaskOfPlane(const itk::ImageBase<3> * image, const itk::Index<3> & voxel, unsigned int axis)
{
  const auto mask = NewImageOn<StartMask>(image, true);
  auto       plane = mask->GetLargestPossibleRegion();
  plane.SetIndex(axis, voxel[axis]);
  plane.SetSize(axis, 1);
  for (itk::ImageRegionIterator<StartMask> it(mask, plane); !it.IsAtEnd(); ++it)
  {
    it.Set(1);
  }
  return mask;
}

StartMask::Pointer
UnionOf(const StartMask * first, const StartMask * second)
{
  auto both = MapVoxels<unsigned char>(first, [](unsigned char voxel) { return voxel != 0 ? 1 : 0; });
  if (second)
  {
    unsigned char * const voxels = both->GetBufferPointer();
    std::transform(voxels,
                   voxels + both->GetBufferedRegion().GetNumberOfPixels(),
                   second->GetBufferPointer(),
                   voxels,
                   [](unsigned char a, unsigned char b) { return a != 0 || b != 0 ? 1 : 0; });
  }
  return both;
}
} // namespace shapeton
