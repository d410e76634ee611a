#ifndef shapetonToolVolumes_h
#define shapetonToolVolumes_h

#include "ToolInputExport.h"
#include "shapetonVolumeReader.h"

#include <future>

namespace shapeton
{
class CommandLine;

/** ReadVolume() for a tool: `parameter` names the input in the tool's XML, which also declares the options seriesUID,
 * resampleGaps, deshear and dropDuplicates. Adds identity and repairs to the provenance, notes to the warnings.
 * \ingroup ToolInput */
ToolInput_EXPORT Volume
ReadVolume(CommandLine & commandLine, const std::string & parameter, bool allowSingleSlice = false);

/** \class VolumeBeside
 * \brief ReadVolume() of an input that may be left out, beside the work of a tool that needs the voxels later.
 *
 * \ingroup ToolInput */
class ToolInput_EXPORT VolumeBeside
{
public:
  /** Starts to read, if the input is given. */
  VolumeBeside(CommandLine & commandLine, const std::string & parameter);
  VolumeBeside(const VolumeBeside &) = delete;
  VolumeBeside &
  operator=(const VolumeBeside &) = delete;

  /** Waits for the volume, once; without an image where the input is not given. Adds to provenance and warnings and
   * throws as ReadVolume() does. */
  Volume
  Get();

private:
  CommandLine &     m_CommandLine;
  std::string       m_Parameter;
  Volume            m_Volume;
  std::future<void> m_Reading; ///< the last member: goes first, which waits for the thread
};

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
