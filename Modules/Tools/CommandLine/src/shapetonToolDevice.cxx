#include "shapetonToolDevice.h"
#include "shapetonDeviceOptions.h"
#include "shapetonExceptions.h"
#include "shapetonReadOptions.h"

namespace shapeton
{
Device
ReadDevice(const CommandLine & commandLine)
{
  DeviceOptions options;
  ReadOptions(commandLine, options);
  return options.device;
}

void
RequireDeviceForCt(const CommandLine & commandLine, bool hasCt)
{
  if (ReadDevice(commandLine) == Device::Cuda)
  {
    RequireParameter(hasCt, "the GPU only renders pictures of a CT, but there is no CT: remove --device cuda");
    ChooseDevice(Device::Cuda, 0);
  }
}
} // namespace shapeton
