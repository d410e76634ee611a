#ifndef shapetonDeviceTestTools_h
#define shapetonDeviceTestTools_h

#include "shapetonDevice.h"

#include <gtest/gtest.h>

#include <cstdlib>

/** Skips tests that compare GPU and CPU if no GPU is found. The emulation is always available. */
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
