#ifndef shapetonToolVolumes_h
#define shapetonToolVolumes_h

#include "ShapetonCommandLineExport.h"
#include "shapetonVolumeReader.h"

namespace shapeton
{
class CommandLine;

/** ReadVolume() for a tool: `parameter` names the input in the tool's XML, which also declares the options seriesUID,
 * resampleGaps, deshear and dropDuplicates. Adds identity and repairs to the provenance, notes to the warnings.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT Volume
ReadVolume(CommandLine & commandLine, const std::string & parameter, bool allowSingleSlice = false);

/** Warns if a volume has a known modality other than CT, for a tool that interprets values as Hounsfield units.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT void
WarnUnlessCT(CommandLine & commandLine, const Volume & volume);

/** MaskForImage() for the volume named by the input `parameter`. Adds its identity to the provenance.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT itk::Image<unsigned char, 3>::Pointer
ReadMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image);

/** MaskForImage() for a label image: throws InputError for negative or fractional values, as in a CT.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT itk::Image<unsigned char, 3>::Pointer
ReadLabelMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image);

/** The voxels of an image in the label mask of the input `mask` and not in that of the input `barrier`; null if neither
 * is given. Throws InputError if no voxel is left. \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT itk::Image<unsigned char, 3>::Pointer
                           ReadDomain(CommandLine & commandLine, const itk::ImageBase<3> * image);

/** Throws ParameterError unless the option intensityWindow is absent or has two ascending numbers.
 * \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT void
RequireIntensityWindow(const CommandLine & commandLine);
} // namespace shapeton

#endif
