#ifndef shapetonDevice_h
#define shapetonDevice_h

#include "DevicesExport.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace shapeton
{
/** Where a computation runs. The results are the same bytes.
 * \ingroup Devices */
enum class Device
{
  Automatic, ///< on the GPU when one is there and has the memory, else on the CPU
  Cpu,
  Cuda
};

/** "auto", "cpu", "cuda".
 * \ingroup Devices */
Devices_EXPORT const char *
NameOf(Device device);

/** \class DeviceError
 * \brief A GPU is asked for, and something that it needs is missing; or it failed.
 * \ingroup Devices */
class DeviceError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** What ChooseDevice() has decided.
 * \ingroup Devices */
struct DeviceUse
{
  bool        gpu{ false };
  std::string device{ "cpu" }; ///< "cpu", or the name of the GPU
  std::string reason;          ///< why not the GPU, where the choice was automatic
  std::size_t memory{ 0 };     ///< bytes that are free on the GPU

  /** In one line, for the record of a run. */
  std::string
  Describe() const
  {
    return reason.empty() ? device : device + " (" + reason + ")";
  }
};

/** Decides where to run what needs `bytes` of memory on a GPU, or can do with `leastBytes` where the GPU is asked for.
 * Throws DeviceError where the GPU is asked for and cannot be used. The plug-in is looked for when it is first needed:
 * beside this library, or where the environment variable SHAPETON_DEVICE_PLUGIN says. SHAPETON_DEVICE_MEMORY may say
 * how many bytes of the GPU's memory to use at most. \ingroup Devices */
Devices_EXPORT DeviceUse
ChooseDevice(Device wanted, std::size_t bytes, std::size_t leastBytes);
inline DeviceUse
ChooseDevice(Device wanted, std::size_t bytes)
{
  return ChooseDevice(wanted, bytes, bytes);
}

/** A function of the plug-in by its name; only after ChooseDevice() has chosen the GPU. See DeviceRuntime.
 * \ingroup Devices */
Devices_EXPORT void *
FindDeviceFunction(const char * name);

/** The type of the plug-in's function ShapetonDescribeDevice(): true where a GPU can be used, then its name and its
 * free memory in bytes; false and the reason in place of the name otherwise. \ingroup Devices */
using DescribeDeviceFunction = bool(std::string & name, std::size_t & memory);

/** The type of ShapetonRunTriads(): a = b + 0.5 c of so many numbers, so many times; for benchmarks.
 * \ingroup Devices */
using RunTriadsFunction = void(std::size_t number, unsigned int triads);

/** The type of ShapetonPluginVersion(): the version of Shapeton that the plug-in was built with.
 * \ingroup Devices */
using PluginVersionFunction = const char *();
} // namespace shapeton

#endif
