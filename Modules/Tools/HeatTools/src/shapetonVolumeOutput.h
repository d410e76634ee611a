#ifndef shapetonVolumeOutput_h
#define shapetonVolumeOutput_h

#include "shapetonCommandLine.h"
#include "shapetonVolumeWriter.h"

namespace shapeton
{
/** CommandLine::OutputOf() for a volume: throws ParameterError for an unsupported extension. */
inline std::string
VolumeOutput(CommandLine & commandLine, const std::string & parameter)
{
  RequireVolumeName(commandLine.GetString(parameter));
  return commandLine.OutputOf(parameter);
}
} // namespace shapeton

#endif
