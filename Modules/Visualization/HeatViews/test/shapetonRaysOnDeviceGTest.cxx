#include "shapetonDeviceTestTools.h"
#include "shapetonVolumeRendering.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace
{
using namespace shapeton;
using Heat = itk::Image<float, 3>;

/** Nested bodies of different heat on a rotated, anisotropic grid. */
Heat::Pointer
MakeHeat(unsigned int nx, unsigned int ny, unsigned int nz)
{
  const auto heat =
    basetest::NewImage<Heat>({ { nx, ny, nz } }, { 0.8, 1.1, 2.3 }, { 11.0, -7.0, 3.0 }, basetest::Rotation(2, 0.4));
  float * voxel = heat->GetBufferPointer();
  for (unsigned int z = 0; z < nz; ++z)
  {
    for (unsigned int y = 0; y < ny; ++y)
    {
      for (unsigned int x = 0; x < nx; ++x)
      {
        const double u = 2.0 * x / nx - 1.0;
        const double v = 2.0 * y / ny - 1.0;
        const double w = 2.0 * z / nz - 1.0;
        *voxel++ = static_cast<float>(std::max(0.0, 0.9 - 0.8 * std::hypot(u, v, w) + 0.05 * std::sin(9.0 * u)));
      }
    }
  }
  return heat;
}

void
ExpectTheSame(const Heat * heat, const VolumeRenderingOptions & options)
{
  const auto           lines = ShapeTransferFunction::Parse("0.3-0.4:red:0.2,0.45-0.6:ivory:0.5,0.7-1:lime:1");
  const VolumeRenderer gpu(heat, lines, Device::Cuda);
  const VolumeRenderer cpu(heat, lines, Device::Cpu);
  EXPECT_TRUE(gpu.GetDeviceUse().gpu);
  EXPECT_FALSE(cpu.GetDeviceUse().gpu);
  const auto        a = gpu.Render(options);
  const auto        b = cpu.Render(options);
  const std::size_t bytes = 3 * a->GetBufferedRegion().GetNumberOfPixels();
  ASSERT_EQ(bytes, 3 * b->GetBufferedRegion().GetNumberOfPixels());
  const unsigned char * const pixels = b->GetBufferPointer()->GetDataPointer();
  EXPECT_EQ(std::memcmp(a->GetBufferPointer(), pixels, bytes), 0);
  EXPECT_GT(std::set<unsigned char>(pixels, pixels + bytes).size(), 30U); // not empty
}

TEST(RaysOnDevice, PicturesFromAllSidesAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  const auto heat = test::IsStandIn() ? MakeHeat(61, 47, 33) : MakeHeat(256, 256, 256);
  for (const double azimuth : { 0.0, 25.0, 90.0, -130.0 })
  {
    for (const double elevation : { 0.0, 33.0, -90.0 })
    {
      VolumeRenderingOptions options;
      options.azimuth = azimuth;
      options.elevation = elevation;
      options.width = test::IsStandIn() ? 157 : 1000;
      options.height = test::IsStandIn() ? 101 : 1000;
      options.annotations = elevation > 0.0;
      ExpectTheSame(heat, options);
    }
  }
}

TEST(RaysOnDevice, ThinVolumesAndEnlargedPartsAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  VolumeRenderingOptions options;
  options.width = 201;
  options.height = 120;
  options.azimuth = 40.0;
  ExpectTheSame(MakeHeat(40, 31, 2), options);
  options.zoom = 7.5;
  ExpectTheSame(MakeHeat(40, 31, 22), options);
}
} // namespace
