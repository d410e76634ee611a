#ifndef shapetonPhantomGrid_h
#define shapetonPhantomGrid_h

#include "ShapetonPhantomsExport.h"
#include "shapetonPhantomGridOptions.h"

#include "itkImageBase.h"

#include <optional>

namespace shapeton
{
/** The grid of a phantom.
 * \ingroup ShapetonPhantoms */
struct PhantomGrid
{
  itk::ImageBase<3>::SizeType      size;
  itk::ImageBase<3>::SpacingType   spacing; ///< mm
  itk::ImageBase<3>::DirectionType direction;
};

/** Creates a grid from user input; the direction is orthonormalized. `bytesPerVoxel` is the memory per voxel. `extent`
 * is the total extent of the voxels in mm if no spacing is given. Throws ParameterError for invalid input, or if the
 * volume does not fit in memory. \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT PhantomGrid
MakePhantomGrid(const PhantomGridOptions &                    options,
                double                                        bytesPerVoxel,
                const std::optional<itk::Vector<double, 3>> & extent = {});
} // namespace shapeton

#endif
