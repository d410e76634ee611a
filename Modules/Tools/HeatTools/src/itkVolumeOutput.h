#ifndef itkVolumeOutput_h
#define itkVolumeOutput_h

#include "itkCommandLine.h"
#include "itkVolumeWriter.h"

namespace itk
{
/** CommandLine::OutputOf() for a volume: throws ParameterError when its extension cannot be written. */
inline std::string
VolumeOutput(CommandLine & commandLine, const std::string & parameter)
{
  RequireVolumeName(commandLine.GetString(parameter));
  return commandLine.OutputOf(parameter);
}
} // namespace itk

#endif
