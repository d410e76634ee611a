#ifndef shapetonToolDevice_h
#define shapetonToolDevice_h

#include "ToolInputExport.h"
#include "shapetonDevice.h"

namespace shapeton
{
class CommandLine;

/** The value of the parameter "device": auto, cpu or cuda. \ingroup ToolInput */
ToolInput_EXPORT Device
ReadDevice(const CommandLine & commandLine);

/** Checks the device before any work on pictures of a CT. Throws DeviceError if the GPU was requested and none is
 * usable, ParameterError if it was requested and there is no CT. \ingroup ToolInput */
ToolInput_EXPORT void
RequireDeviceForCt(const CommandLine & commandLine, bool hasCt);
} // namespace shapeton

#endif
