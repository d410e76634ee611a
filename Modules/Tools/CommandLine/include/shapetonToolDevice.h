#ifndef shapetonToolDevice_h
#define shapetonToolDevice_h

#include "ShapetonCommandLineExport.h"
#include "shapetonDevice.h"

namespace shapeton
{
class CommandLine;

/** The value of the parameter "device": auto, cpu or cuda. \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT Device
ReadDevice(const CommandLine & commandLine);

/** Checks the device before any work on pictures of a CT. Throws DeviceError if the GPU was requested but is not
 * usable, ParameterError if it was requested without a CT. \ingroup ShapetonCommandLine */
ShapetonCommandLine_EXPORT void
RequireDeviceForCt(const CommandLine & commandLine, bool hasCt);
} // namespace shapeton

#endif
