#ifndef shapetonImageGrid_h
#define shapetonImageGrid_h

#include "ShapetonCommonExport.h"
#include "shapetonExceptions.h"
#include "shapetonVoxelGrid.h"

#include "itkImageBase.h"

namespace shapeton
{
/** Throws InputError that begins with `what` if an image is null or its pixels are not allocated.
 * \ingroup ShapetonCommon */
template <typename TImage>
void
RequirePixels(const TImage * image, const char * what)
{
  if (!image || !image->GetBufferPointer())
  {
    throw InputError(std::string(what) + " has no pixels; update the filter that makes it");
  }
}

/** The grid of the buffer of an image. \ingroup ShapetonCommon */
inline VoxelGrid
GridOf(const itk::ImageBase<3> * image)
{
  const auto & size = image->GetBufferedRegion().GetSize();
  return { static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]) };
}

/** Whether two volumes have the same size and the same voxel positions, to a hundredth of the smallest spacing; the
 * indices of their first voxels may differ.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT bool
HaveSameGrid(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b);
} // namespace shapeton

#endif
