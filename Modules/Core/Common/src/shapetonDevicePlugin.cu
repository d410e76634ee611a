#include "shapetonDeviceRuntime.h"

using namespace shapeton;

SHAPETON_DEVICE_FUNCTION const char *
ShapetonPluginVersion()
{
  return SHAPETON_DEVICE_VERSION;
}

namespace
{
struct Triad
{
  float *       a;
  const float * b;
  const float * c;

  SHAPETON_HOST_DEVICE void
  operator()(std::size_t i) const
  {
    a[i] = b[i] + 0.5F * c[i];
  }
};
} // namespace

// Measures the peak memory bandwidth, for benchmarks.
SHAPETON_DEVICE_FUNCTION void
ShapetonRunTriads(std::size_t number, unsigned int triads)
{
  static DeviceRuntime::Memory<float> memory;
  if (memory.GetNumber() != 3 * number)
  {
    memory = DeviceRuntime::Memory<float>(3 * number);
    memory.Clear();
  }
  for (unsigned int k = 0; k < triads; ++k)
  {
    DeviceRuntime::ForEach(number, Triad{ memory.Get(), memory.Get() + number, memory.Get() + 2 * number });
  }
  DeviceRuntime::Synchronize();
}

#if defined(__CUDACC__)
SHAPETON_DEVICE_FUNCTION bool
ShapetonDescribeDevice(std::string & name, std::size_t & memory)
{
  int            devices = 0;
  cudaError_t    status = cudaGetDeviceCount(&devices);
  cudaDeviceProp properties{};
  if (status == cudaSuccess)
  {
    status = cudaGetDeviceProperties(&properties, 0);
  }
  std::size_t whole = 0;
  if (status == cudaSuccess)
  {
    status = cudaMemGetInfo(&memory, &whole);
  }
  name = status == cudaSuccess ? properties.name : cudaGetErrorString(status);
  return status == cudaSuccess;
}
#else
SHAPETON_DEVICE_FUNCTION bool
ShapetonDescribeDevice(std::string & name, std::size_t & memory)
{
  memory = std::size_t{ 1 } << 36;
  name = "stand-in";
  return true;
}
#endif
