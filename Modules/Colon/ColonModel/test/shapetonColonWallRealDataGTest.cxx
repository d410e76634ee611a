#include "shapetonColonWall.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonVolumeReader.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
/** The mask of a real colon, cropped to its bounding box with a margin of one voxel; null without test data. */
shapeton::LumenMaskImage::Pointer
RealMask()
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (folder == nullptr || *folder == '\0')
  {
    return nullptr;
  }
  const auto   image = shapeton::ReadVolume(std::string(folder) + "/ctc/colon-lumen-mask.nii.gz").image;
  const auto   size = image->GetBufferedRegion().GetSize();
  std::int64_t low[3] = { 1 << 20, 1 << 20, 1 << 20 };
  std::int64_t high[3] = { 0, 0, 0 };
  const auto   forEachVoxel = [&](const auto & body) {
    std::size_t i = 0;
    for (std::int64_t z = 0; z < static_cast<std::int64_t>(size[2]); ++z)
    {
      for (std::int64_t y = 0; y < static_cast<std::int64_t>(size[1]); ++y)
      {
        for (std::int64_t x = 0; x < static_cast<std::int64_t>(size[0]); ++x, ++i)
        {
          if (image->GetBufferPointer()[i] > 0.0F)
          {
            body({ { x, y, z } });
          }
        }
      }
    }
  };
  forEachVoxel([&](const itk::Index<3> & index) {
    for (int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], index[k] - 1);
      high[k] = std::max(high[k], index[k] + 1);
    }
  });
  auto          mask = shapeton::LumenMaskImage::New();
  itk::Index<3> first{ { low[0], low[1], low[2] } };
  itk::Size<3>  extent;
  for (int k = 0; k < 3; ++k)
  {
    extent[k] = static_cast<itk::SizeValueType>(high[k] - low[k] + 1);
  }
  mask->CopyInformation(image);
  mask->SetRegions({ first, extent });
  mask->Allocate(true);
  forEachVoxel([&](const itk::Index<3> & index) { mask->SetPixel(index, 1); });
  return mask;
}
} // namespace

// The Euler number of the surface is -34: 18 handles.
TEST(ColonWallRealData, RepairsAColonOfEighteenHandles)
{
  const auto mask = RealMask();
  if (!mask)
  {
    GTEST_SKIP() << "SHAPETON_TEST_DATA_DIR is not set";
  }
  const auto occupancy = shapeton::OccupancyFromMask(mask);
  const auto raw = shapeton::SurfaceConnectivity(shapeton::ExtractWall(occupancy));
  EXPECT_EQ(-34, raw.Components().front().eulerCharacteristic);
  EXPECT_EQ(18, raw.Components().front().genus.value_or(-1));
  const auto topology = shapeton::RepairLumenTopology(occupancy, shapeton::CurveSet());
  EXPECT_EQ(18, topology.report.handlesBefore);
  EXPECT_EQ(0, topology.report.handlesAfter);
  EXPECT_NEAR(3565.5, topology.report.lumenVolume, 0.1); // ml
  EXPECT_GT(0.5, topology.report.cutVolume);
  const auto repaired = shapeton::SurfaceConnectivity(shapeton::ExtractWall(occupancy, topology.mask));
  EXPECT_TRUE(repaired.IsClosed());
  EXPECT_EQ(0, repaired.Components().front().genus.value_or(-1));
}
