#include "shapetonDevice.h"
#include "shapetonExceptions.h"
#include "shapetonOperatingSystem.h"

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>

namespace shapeton
{
namespace
{
/** The kernel library, kept open once found, or the reason why it is not available. */
struct Plugin
{
  void *      handle{ nullptr };
  std::string missing;
};

std::string
PathOfPlugin()
{
  const char * const given = std::getenv("SHAPETON_DEVICE_PLUGIN");
  return given ? given : FolderOfThisLibrary() + '/' + SHAPETON_DEVICE_PLUGIN;
}

Plugin
OpenPlugin()
{
  const std::string path = PathOfPlugin();
  if (!std::filesystem::exists(path))
  {
    return { nullptr, "the plug-in " + path + " is missing; build Shapeton with SHAPETON_USE_CUDA=ON" };
  }
  void * const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle)
  {
    return { nullptr, std::string("the plug-in cannot be loaded: ") + dlerror() };
  }
  const auto version = reinterpret_cast<PluginVersionFunction *>(dlsym(handle, "ShapetonPluginVersion"));
  if (!version || version() != std::string(SHAPETON_DEVICE_VERSION))
  {
    return { nullptr, "the plug-in " + path + " was not built with Shapeton " + SHAPETON_DEVICE_VERSION };
  }
  return { handle, {} };
}

const Plugin &
ThePlugin()
{
  static const Plugin plugin = OpenPlugin();
  return plugin;
}

std::string
Megabytes(std::size_t bytes)
{
  constexpr std::size_t megabyte = 1000000;
  return std::to_string((bytes + megabyte - 1) / megabyte) + " MB";
}

/** The usable GPU memory: the free memory, limited by the environment variable SHAPETON_DEVICE_MEMORY for shared GPUs.
 */
std::size_t
AllowedMemory(std::size_t bytesFree)
{
  const char * const given = std::getenv("SHAPETON_DEVICE_MEMORY");
  return given ? std::min<std::size_t>(bytesFree, std::strtoull(given, nullptr, 10)) : bytesFree;
}

/** Sets name and memory of the GPU; returns the reason if none can be used, otherwise an empty string. */
std::string
FindGpu(DeviceUse & use)
{
  if (!ThePlugin().handle)
  {
    return ThePlugin().missing;
  }
  const auto  describe = reinterpret_cast<DescribeDeviceFunction *>(FindDeviceFunction("ShapetonDescribeDevice"));
  std::string text;
  if (!describe(text, use.memory))
  {
    return text;
  }
  use.device = text;
  use.memory = AllowedMemory(use.memory);
  return {};
}
} // namespace

DeviceUse
ChooseDevice(Device wanted, std::size_t bytes, std::size_t leastBytes)
{
  if (wanted == Device::Cpu)
  {
    return {};
  }
  DeviceUse         use;
  const std::size_t needed = wanted == Device::Cuda ? leastBytes : bytes;
  std::string       missing = FindGpu(use);
  if (missing.empty() && needed > use.memory)
  {
    missing = "this volume requires " + Megabytes(needed) + " of its memory, " + Megabytes(use.memory) +
              " are free on " + use.device;
  }
  if (missing.empty())
  {
    use.gpu = true;
    return use;
  }
  if (wanted == Device::Cuda)
  {
    throw DeviceError("the GPU cannot be used: " + missing);
  }
  DeviceUse cpu;
  cpu.reason = "no GPU: " + missing;
  return cpu;
}

void *
FindDeviceFunction(const char * name)
{
  void * const function = dlsym(ThePlugin().handle, name);
  if (!function)
  {
    throw DeviceError(std::string("the plug-in for the GPU lacks the function ") + name);
  }
  return function;
}
} // namespace shapeton
