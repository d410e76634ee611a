#include "shapetonToolDevice.h"
#include "shapetonCommandLine.h"

namespace shapeton
{
Device
ReadDevice(const CommandLine & commandLine)
{
  const std::string name = commandLine.GetString("device");
  return name == NameOf(Device::Cpu) ? Device::Cpu : name == NameOf(Device::Cuda) ? Device::Cuda : Device::Automatic;
}
} // namespace shapeton
