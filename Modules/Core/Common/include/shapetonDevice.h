#ifndef shapetonDevice_h
#define shapetonDevice_h

#include "ShapetonCommonExport.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace shapeton
{
/** Device that runs a computation. Results are identical on all devices.
 * \ingroup ShapetonCommon */
enum class Device
{
  Automatic, ///< the GPU if one is available and has enough memory, else the CPU
  Cpu,
  Cuda
};

/** \class DeviceFailure
 * \brief A GPU failed during a computation; thrown by the plug-in, which does not depend on ITK.
 * \ingroup ShapetonCommon */
class DeviceFailure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The device chosen by ChooseDevice().
 * \ingroup ShapetonCommon */
struct DeviceUse
{
  bool        gpu{ false };
  std::string device{ "cpu" }; ///< "cpu", or the name of the GPU
  std::string reason;          ///< why the GPU is not used, if the choice was automatic
  std::size_t memory{ 0 };     ///< free memory of the GPU in bytes

  /** One-line description for the log of a run. */
  std::string
  Describe() const
  {
    return reason.empty() ? device : device + " (" + reason + ")";
  }
};

/** Chooses the device for a computation that needs `bytes` of memory on a GPU, or at least `leastBytes` if the GPU
 * is requested. Throws DeviceError if the GPU is requested and cannot be used. On first use the plug-in is loaded from
 * the folder Shapeton-0.2 next to this library, or from the path in the environment variable SHAPETON_DEVICE_PLUGIN.
 * SHAPETON_DEVICE_MEMORY may limit the bytes of GPU memory to use. \ingroup ShapetonCommon */
ShapetonCommon_EXPORT DeviceUse
ChooseDevice(Device wanted, std::size_t bytes, std::size_t leastBytes);
inline DeviceUse
ChooseDevice(Device wanted, std::size_t bytes)
{
  return ChooseDevice(wanted, bytes, bytes);
}

/** Finds a function of the plug-in by name. Call it only after ChooseDevice() has chosen the GPU. See DeviceRuntime.
 * \ingroup ShapetonCommon */
ShapetonCommon_EXPORT void *
FindDeviceFunction(const char * name);

/** Type of the plug-in's function ShapetonDescribeDevice(). Returns true if a GPU can be used, with its name and its
 * free memory in bytes; otherwise false, with the reason instead of the name. \ingroup ShapetonCommon */
using DescribeDeviceFunction = bool(std::string & name, std::size_t & memory);

/** Type of ShapetonRunTriads(): a = b + 0.5 c for given numbers of elements and repetitions; for benchmarks.
 * \ingroup ShapetonCommon */
using RunTriadsFunction = void(std::size_t number, unsigned int triads);

/** Type of ShapetonPluginVersion(): the version of Shapeton that the plug-in was built with.
 * \ingroup ShapetonCommon */
using PluginVersionFunction = const char *();
} // namespace shapeton

#endif
