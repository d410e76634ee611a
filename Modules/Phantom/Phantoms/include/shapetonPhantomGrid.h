#ifndef shapetonPhantomGrid_h
#define shapetonPhantomGrid_h

#include "ShapetonPhantomsExport.h"

#include "itkImageBase.h"

#include <optional>
#include <vector>

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

/** Creates a grid from user input: size (three integers from 2), spacing (three numbers from 0.001 to 1000 mm) and
 * direction (nine numbers, row by row; orthonormal to 0.001, then orthonormalized). `bytesPerVoxel` is the memory per
 * voxel. `extent` is the total extent of the voxels in mm if no spacing is given. Throws ParameterError for invalid
 * input, or if the volume does not fit in memory.
 * \ingroup ShapetonPhantoms */
ShapetonPhantoms_EXPORT PhantomGrid
MakePhantomGrid(const std::vector<int> &                      size,
                const std::vector<double> &                   spacing,
                const std::vector<double> &                   direction,
                double                                        bytesPerVoxel,
                const std::optional<itk::Vector<double, 3>> & extent = {});
} // namespace shapeton

#endif
