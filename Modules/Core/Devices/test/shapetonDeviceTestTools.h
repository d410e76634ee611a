#ifndef shapetonDeviceTestTools_h
#define shapetonDeviceTestTools_h

#include "shapetonDevice.h"

#include <gtest/gtest.h>

#include <cstdlib>

/** In a test that compares a GPU with the CPU: skips it where there is none. The stand-in is always there. */
#define SHAPETON_REQUIRE_DEVICE()                                                                                      \
  if (!shapeton::test::HasDevice())                                                                                    \
  {                                                                                                                    \
    GTEST_SKIP() << shapeton::ChooseDevice(shapeton::Device::Automatic, 0).reason;                                     \
  }

namespace shapeton
{
namespace test
{
inline bool
IsStandIn()
{
  return std::getenv("SHAPETON_DEVICE_PLUGIN") != nullptr;
}

inline bool
HasDevice()
{
  return IsStandIn() || ChooseDevice(Device::Automatic, 0).gpu;
}
} // namespace test
} // namespace shapeton

#endif
