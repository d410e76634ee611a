#ifndef shapetonPhantomGrid_h
#define shapetonPhantomGrid_h

#include "ShapePhantomExport.h"

#include "itkImageBase.h"

#include <optional>
#include <vector>

namespace shapeton
{
/** The voxels of a phantom.
 * \ingroup ShapePhantom */
struct PhantomGrid
{
  itk::ImageBase<3>::SizeType      size;
  itk::ImageBase<3>::SpacingType   spacing; ///< mm
  itk::ImageBase<3>::DirectionType direction;
};

/** Makes a grid of what a user gives: size (three integers from 2), spacing (three numbers from 0.001 to 1000 mm) and
 * direction (nine numbers, row by row; orthonormal to 0.001, which is removed). `bytesPerVoxel` is what will be held in
 * memory. `extent` in mm is what the voxels cover together where no spacing is given.
 * Throws ParameterError, also when the volume does not fit into the memory of the machine.
 * \ingroup ShapePhantom */
ShapePhantom_EXPORT PhantomGrid
MakePhantomGrid(const std::vector<int> &                      size,
                const std::vector<double> &                   spacing,
                const std::vector<double> &                   direction,
                double                                        bytesPerVoxel,
                const std::optional<itk::Vector<double, 3>> & extent = {});
} // namespace shapeton

#endif
