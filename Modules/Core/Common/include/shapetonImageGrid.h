#ifndef shapetonImageGrid_h
#define shapetonImageGrid_h

#include "ShapetonCommonExport.h"
#include "shapetonVoxelGrid.h"

#include "itkImageBase.h"

namespace shapeton
{
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
