#include "shapetonDeviceTestTools.h"
#include "shapetonFlatTestCt.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace
{
using namespace flatcolon;
using shapeton::Device;

Eigen::Matrix3d
ObliqueAxes()
{
  return (Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()) *
          Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
    .toRotationMatrix();
}

void
ExpectTheSame(const Colon & colon, const Ct * ct, const shapeton::FlatVolumeOptions & options)
{
  const auto use = shapeton::ChooseFlatVolumeDevice(ct, Device::Cuda);
  ASSERT_TRUE(use.gpu);
  const auto                  gpu = colon.Paint(ct, options, use);
  const auto                  cpu = colon.Paint(ct, options, shapeton::ChooseFlatVolumeDevice(ct, Device::Cpu));
  const std::size_t           bytes = 3 * cpu->GetBufferedRegion().GetNumberOfPixels();
  const unsigned char * const pixels = cpu->GetBufferPointer()->GetDataPointer();
  EXPECT_EQ(std::memcmp(gpu->GetBufferPointer(), pixels, bytes), 0);
  EXPECT_GT(std::set<unsigned char>(pixels, pixels + bytes).size(), 30U); // not empty
}
} // namespace

TEST(FlatVolumeOnDevice, ObliqueVolumesAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  // Large enough for several batches of rays.
  const Colon colon(RadiusAt, 0.2);
  const auto  huAt = [](const Eigen::Vector3d & p) { return HuAt(p, RadiusAt); };
  const auto  ct = MakeCt(ObliqueAxes(), Eigen::Vector3d(1.2, 0.7, 1.5), huAt);
  ExpectTheSame(colon, ct, {});
  shapeton::FlatVolumeOptions deep;
  deep.depthOfLumen = 6.0;
  deep.extinction = 0.7;
  ExpectTheSame(colon, ct, deep);
}

TEST(FlatVolumeOnDevice, RaysThatLeaveTheVolumeAreTheSameBytes)
{
  SHAPETON_REQUIRE_DEVICE();
  const Colon colon(RadiusAt, 1.0);
  const auto  ct =
    MakeCt(ObliqueAxes(), Eigen::Vector3d(1.2, 1.0, 1.5), [](const Eigen::Vector3d & p) { return HuAt(p, RadiusAt); });
  shapeton::FlatVolumeOptions far;
  far.depthOfWall = 40.0;
  far.extinction = 0.02;
  ExpectTheSame(colon, ct, far);
}
