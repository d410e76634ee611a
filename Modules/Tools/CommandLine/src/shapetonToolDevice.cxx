#include "shapetonToolDevice.h"
#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"

namespace shapeton
{
Device
ReadDevice(const CommandLine & commandLine)
{
  const std::string name = commandLine.GetString("device");
  return name == NameOf(Device::Cpu) ? Device::Cpu : name == NameOf(Device::Cuda) ? Device::Cuda : Device::Automatic;
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
