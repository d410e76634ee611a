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

/** Before any work on pictures of a CT: throws DeviceError where the GPU is asked for and none can be used,
 * ParameterError where it is asked for and there is no CT. \ingroup ToolInput */
ToolInput_EXPORT void
RequireDeviceForCt(const CommandLine & commandLine, bool hasCt);
} // namespace shapeton

#endif
