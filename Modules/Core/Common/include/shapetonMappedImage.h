#ifndef shapetonMappedImage_h
#define shapetonMappedImage_h

#include "itkImage.h"

#include <algorithm>

namespace shapeton
{
/** A new image on the grid of another one; its values are 0 if `isZero`, else not initialized.
 * \ingroup ShapetonCommon */
template <typename TImage>
typename TImage::Pointer
NewImageOn(const itk::ImageBase<3> * grid, bool isZero = false)
{
  const auto image = TImage::New();
  image->CopyInformation(grid);
  image->SetRegions(grid->GetLargestPossibleRegion());
  image->Allocate(isZero);
  return image;
}

/** The image with the value `function(voxel)` for each voxel of a buffered image. \ingroup ShapetonCommon */
template <typename TValue, typename TVoxel, typename TFunction>
typename itk::Image<TValue, 3>::Pointer
MapVoxels(const itk::Image<TVoxel, 3> * image, const TFunction & function)
{
  const auto           mapped = NewImageOn<itk::Image<TValue, 3>>(image);
  const TVoxel * const first = image->GetBufferPointer();
  std::transform(
    first, first + image->GetLargestPossibleRegion().GetNumberOfPixels(), mapped->GetBufferPointer(), function);
  return mapped;
}
} // namespace shapeton

#endif
