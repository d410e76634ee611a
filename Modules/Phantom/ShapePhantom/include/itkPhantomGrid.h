#ifndef itkPhantomGrid_h
#define itkPhantomGrid_h

#include "ShapePhantomExport.h"

#include "itkImageBase.h"

#include <optional>

#include <string>

namespace itk
{
class CommandLine;

/** The voxels of a phantom.
 * \ingroup ShapePhantom */
struct PhantomGrid
{
  ImageBase<3>::SizeType      size;
  ImageBase<3>::SpacingType   spacing; ///< mm
  ImageBase<3>::DirectionType direction;
};

/** Reads the options size (three integers from 2), spacing (three numbers from 0.001 to 1000 mm) and direction (nine
 * numbers, row by row; orthonormal to 0.001, which is removed) of a tool. `bytesPerVoxel` is what the tool will hold in
 * memory. `extent` in mm is what the voxels cover together where the option spacing has neither a value nor a default.
 * Throws UsageError, also when the volume does not fit into the memory of the machine.
 * \ingroup ShapePhantom */
ShapePhantom_EXPORT PhantomGrid
ReadPhantomGrid(const CommandLine &                      commandLine,
                double                                   bytesPerVoxel,
                const std::optional<Vector<double, 3>> & extent = {});

/** Image Comments of a series that a phantom tool writes: its provenance, "key=value" with semicolons between.
 * \ingroup ShapePhantom */
ShapePhantom_EXPORT std::string
                    ProvenanceComment(const CommandLine & commandLine);

/** A folder's name without slashes at its end, so that names can be made from it. \ingroup ShapePhantom */
ShapePhantom_EXPORT std::string
                    WithoutTrailingSlashes(std::string path);
} // namespace itk

#endif
