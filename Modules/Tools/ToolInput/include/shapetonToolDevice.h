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
} // namespace shapeton

#endif
