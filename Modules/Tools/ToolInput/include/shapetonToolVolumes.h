#ifndef shapetonToolVolumes_h
#define shapetonToolVolumes_h

#include "ToolInputExport.h"
#include "shapetonVolumeReader.h"

namespace shapeton
{
class CommandLine;

/** ReadVolume() for a tool: `parameter` names the input in the tool's XML, which also declares the options seriesUID,
 * resampleGaps, deshear and dropDuplicates. Adds identity and repairs to the provenance, notes to the warnings.
 * \ingroup ToolInput */
ToolInput_EXPORT Volume
ReadVolume(CommandLine & commandLine, const std::string & parameter, bool allowSingleSlice = false);

/** Warns of a volume that says it is of another modality, for a tool that takes values for Hounsfield units.
 * \ingroup ToolInput */
ToolInput_EXPORT void
WarnUnlessCT(CommandLine & commandLine, const Volume & volume);

/** MaskForImage() for a tool, of the volume that the input `parameter` names. Adds its identity to the provenance.
 * \ingroup ToolInput */
ToolInput_EXPORT itk::Image<unsigned char, 3>::Pointer
                 ReadMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image);

/** The same of an image of labels: throws InputError where it holds a negative or broken number, as a CT does.
 * \ingroup ToolInput */
ToolInput_EXPORT itk::Image<unsigned char, 3>::Pointer
ReadLabelMask(CommandLine & commandLine, const std::string & parameter, const itk::ImageBase<3> * image);

/** Throws ParameterError unless the option intensityWindow, if given, holds two ascending numbers. \ingroup ToolInput
 */
ToolInput_EXPORT void
RequireIntensityWindow(const CommandLine & commandLine);
} // namespace shapeton

#endif
