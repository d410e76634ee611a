#include "shapetonColonWall.h"
#include "shapetonLumenDistance.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonTestImages.h"
#include "shapetonVolumeReader.h"

#include "itkRegionOfInterestImageFilter.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
/** The mask of a real colon, cropped to its bounding box with a margin of one voxel; null if there are no test data. */
shapeton::LumenMaskImage::Pointer
RealMask()
{
  const char * const folder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (folder == nullptr || *folder == '\0')
  {
    return nullptr;
  }
  const auto image = shapeton::ReadVolume(std::string(folder) + "/ctc/colon-lumen-mask.nii.gz").image;
  const auto whole =
    shapeton::MapVoxels<unsigned char>(image.GetPointer(), [](float value) { return value > 0.0F ? 1 : 0; });
  const auto crop = itk::RegionOfInterestImageFilter<shapeton::LumenMaskImage, shapeton::LumenMaskImage>::New();
  crop->SetInput(whole);
  crop->SetRegionOfInterest(shapeton::LumenRegion(whole, 1));
  crop->Update();
  return crop->GetOutput();
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
