#include "shapetonDeviceRuntime.h"

using namespace shapeton;

SHAPETON_DEVICE_FUNCTION const char *
ShapetonPluginVersion()
{
  return SHAPETON_DEVICE_VERSION;
}

#if defined(__CUDACC__)
SHAPETON_DEVICE_FUNCTION bool
ShapetonDescribeDevice(std::string & name, std::size_t & memory)
{
  int         devices = 0;
  cudaError_t status = cudaGetDeviceCount(&devices);
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
