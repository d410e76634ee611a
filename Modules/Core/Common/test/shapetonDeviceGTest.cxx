#include "shapetonDevice.h"
#include "shapetonDeviceOptions.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

namespace
{
using shapeton::ChooseDevice;
using shapeton::Device;

TEST(Device, CpuNeedsNothing)
{
  const auto use = ChooseDevice(Device::Cpu, std::size_t{ 1 } << 62);
  EXPECT_FALSE(use.gpu);
  EXPECT_EQ(use.Describe(), "cpu");
}

// A volume of four exabytes does not fit into any GPU.
TEST(Device, AutomaticFallsBackToTheCpuAndSaysWhy)
{
  const auto use = ChooseDevice(Device::Automatic, std::size_t{ 1 } << 62);
  EXPECT_FALSE(use.gpu);
  EXPECT_EQ(use.device, "cpu");
  EXPECT_EQ(use.Describe().rfind("cpu (no GPU: ", 0), 0U) << use.Describe();
}

TEST(Device, AskedForAndMissingIsAnErrorOfOneLine)
{
  const std::string text =
    basetest::ErrorOf<shapeton::DeviceError>([] { ChooseDevice(Device::Cuda, std::size_t{ 1 } << 62); });
  EXPECT_EQ(text.rfind("the GPU cannot be used: ", 0), 0U) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_THROW(ChooseDevice(Device::Cuda, std::size_t{ 1 } << 62), itk::ExceptionObject);
}

TEST(Device, HasTheWordsOfItsOption)
{
  EXPECT_STREQ(shapeton::WordOf(&shapeton::DeviceOptions::device, Device::Automatic), "auto");
  EXPECT_STREQ(shapeton::WordOf(&shapeton::DeviceOptions::device, Device::Cpu), "cpu");
  EXPECT_STREQ(shapeton::WordOf(&shapeton::DeviceOptions::device, Device::Cuda), "cuda");
}
} // namespace
