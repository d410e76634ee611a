#ifndef shapetonSameGrid_h
#define shapetonSameGrid_h

#include "ShapetonCommonExport.h"

#include "itkImageBase.h"

namespace shapeton
{
/** Whether two volumes have the same size and the same voxel positions, to a hundredth of the smallest spacing.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT bool
HaveSameGrid(const itk::ImageBase<3> * a, const itk::ImageBase<3> * b);
} // namespace shapeton

#endif
