#include "shapetonVolume.h"

#include "shapetonExceptions.h"

#include <algorithm>

namespace shapeton
{
namespace
{
const std::string prefixOfSeries = "seriesInstanceUID:";
}

std::string
IdentityOfSeries(const std::string & selector)
{
  return prefixOfSeries + selector;
}

std::string
SeriesOfIdentity(const std::string & identity)
{
  return identity.rfind(prefixOfSeries, 0) == 0 ? identity.substr(prefixOfSeries.size()) : "";
}

bool
HaveSameGrid(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b)
{
  const itk::ImageRegion<3> region = a->GetLargestPossibleRegion();
  if (region != b->GetLargestPossibleRegion())
  {
    return false;
  }
  const auto & spacing = a->GetSpacing();
  const double tolerance = 0.01 * std::min({ spacing[0], spacing[1], spacing[2] });
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    itk::Index<3> index = region.GetIndex();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      index[axis] += (corner >> axis) & 1U ? static_cast<itk::IndexValueType>(region.GetSize(axis)) - 1 : 0;
    }
    itk::ImageBase<3>::PointType pointA;
    itk::ImageBase<3>::PointType pointB;
    a->TransformIndexToPhysicalPoint(index, pointA);
    b->TransformIndexToPhysicalPoint(index, pointB);
    if (pointA.EuclideanDistanceTo(pointB) > tolerance)
    {
      return false;
    }
  }
  return true;
}

itk::Image<unsigned char, 3>::Pointer
MaskOfVolume(const Volume & volume, const std::string & path)
{
  auto mask = itk::Image<unsigned char, 3>::New();
  mask->CopyInformation(volume.image);
  mask->SetRegions(volume.image->GetLargestPossibleRegion());
  mask->Allocate();
  const float * const begin = volume.image->GetBufferPointer();
  const float * const end = begin + volume.image->GetLargestPossibleRegion().GetNumberOfPixels();
  std::transform(
    begin, end, mask->GetBufferPointer(), [](float value) { return static_cast<unsigned char>(value != 0.0F); });
  if (std::all_of(begin, end, [](float value) { return value == 0.0F; }))
  {
    throw InputError(path + ": the mask is empty: it must contain nonzero voxels");
  }
  return mask;
}

itk::Image<unsigned char, 3>::Pointer
MaskForImage(const Volume & volume, const std::string & path, const itk::ImageBase<3> * image)
{
  if (!HaveSameGrid(image, volume.image))
  {
    throw InputError(path + ": the mask differs in size or position from the volume; use a mask of that volume");
  }
  const auto mask = MaskOfVolume(volume, path);
  mask->CopyInformation(image); // equal up to rounding
  return mask;
}
} // namespace shapeton
