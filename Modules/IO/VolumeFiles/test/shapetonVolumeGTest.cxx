#include "shapetonExceptions.h"
#include "shapetonImageFile.h"
#include "shapetonImageGrid.h"
#include "shapetonTestFolder.h"
#include "shapetonVolumeWriter.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
using ImageType = shapeton::Volume::ImageType;

/** Oblique and anisotropic, with the numbers 0 to 59. */
ImageType::Pointer
MakeImage()
{
  const auto image = basetest::NewImage<ImageType>(
    { { 5, 4, 3 } }, { 0.5, 0.75, 2.0 }, { -12.5, 30.25, 100.0 }, basetest::Rotation(2, std::acos(0.6)));
  std::iota(image->GetBufferPointer(), image->GetBufferPointer() + 60, 0.0F);
  return image;
}

TEST(Volume, ComesBackFromEveryFormat)
{
  const basetest::Folder folder;
  const auto             image = MakeImage();
  for (const std::string name : { "a.nrrd", "a.nii", "a.nii.gz", "a.mha" })
  {
    shapeton::WriteVolume(image.GetPointer(), folder / name);
    ASSERT_TRUE(shapeton::IsImageFile(folder / name));
    const shapeton::Volume copy = shapeton::ReadImageFile(folder / name);
    EXPECT_TRUE(shapeton::HaveSameGrid(image, copy.image)) << name;
    EXPECT_EQ(copy.image->GetPixel({ { 1, 2, 2 } }), 51.0F) << name;
    EXPECT_EQ(copy.identity.substr(0, 7), "sha256:") << name;
  }
}

TEST(Volume, OfAnotherGridIsToldApart)
{
  const auto image = MakeImage();
  auto       other = MakeImage();
  EXPECT_TRUE(shapeton::HaveSameGrid(image, other));
  auto origin = other->GetOrigin();
  origin[2] += 0.02; // a hundredth of the least spacing is 0.005
  other->SetOrigin(origin);
  EXPECT_FALSE(shapeton::HaveSameGrid(image, other));
}

TEST(Volume, AsAMaskHasOnesAndTheGridOfTheImage)
{
  const auto       image = MakeImage();
  shapeton::Volume volume;
  volume.image = MakeImage();
  const auto mask = shapeton::MaskForImage(volume, "m.nrrd", image);
  EXPECT_EQ(mask->GetPixel({ { 0, 0, 0 } }), 0);
  EXPECT_EQ(mask->GetPixel({ { 1, 0, 0 } }), 1);
  EXPECT_TRUE(shapeton::HaveSameGrid(image, mask));

  volume.image->FillBuffer(0.0F);
  EXPECT_EQ(basetest::MessageOf([&] { shapeton::MaskForImage(volume, "m.nrrd", image); }),
            "InputError: m.nrrd: the mask is empty: it must contain nonzero voxels");
  volume.image->SetSpacing(2.0);
  EXPECT_NE(
    basetest::MessageOf([&] { shapeton::MaskForImage(volume, "m.nrrd", image); }).find("differs in size or position"),
    std::string::npos);
}
} // namespace
