#include "shapetonVolume.h"

#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"
#include "shapetonMappedImage.h"

#include <algorithm>

namespace shapeton
{
namespace
{
const std::string prefixOfSeries = "seriesInstanceUID:"; // of the identity of a DICOM series
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

itk::Image<unsigned char, 3>::Pointer
MaskOfVolume(const Volume & volume, const std::string & path)
{
  const auto mask =
    MapVoxels<unsigned char>(volume.image.GetPointer(), [](float value) { return value != 0.0F ? 1 : 0; });
  const unsigned char * const begin = mask->GetBufferPointer();
  const unsigned char * const end = begin + mask->GetLargestPossibleRegion().GetNumberOfPixels();
  if (std::all_of(begin, end, [](unsigned char value) { return value == 0; }))
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
