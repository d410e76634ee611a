#include "shapetonObjectColors.h"

#include "shapetonTestErrors.h"
#include "shapetonTestImages.h"
#include "shapetonTransferFunctionPicture.h"
#include "shapetonVolumeRendering.h"

#include <gtest/gtest.h>

namespace
{
using HeatImage = itk::Image<float, 3>;
using LabelImage = shapeton::HeatObjectList::LabelImage;
using shapeton::ObjectColor;

const HeatImage::SizeType size{ { 24, 20, 16 } };

/** Label 2 in label 1, label 3 apart, in a heat that rises along x; anisotropic. */
struct Scene
{
  Scene()
  {
    for (std::size_t voxel = 0; voxel < heat->GetBufferedRegion().GetNumberOfPixels(); ++voxel)
    {
      const auto index = heat->ComputeIndex(static_cast<itk::OffsetValueType>(voxel));
      const bool isInside =
        index[0] > 3 && index[0] < 12 && index[1] > 3 && index[1] < 16 && index[2] > 2 && index[2] < 13;
      const bool isCore = isInside && index[1] > 7 && index[1] < 12 && index[2] > 5 && index[2] < 10;
      const bool isApart =
        index[0] > 15 && index[0] < 21 && index[1] > 5 && index[1] < 14 && index[2] > 4 && index[2] < 12;
      labels->GetBufferPointer()[voxel] = isCore ? 2 : isInside ? 1 : isApart ? 3 : 0;
      heat->GetBufferPointer()[voxel] = static_cast<float>(index[0] + 1) / 32.0F;
      ++voxels[labels->GetBufferPointer()[voxel]];
    }
  }

  HeatImage::Pointer  heat{ basetest::NewImage<HeatImage>(size, { 0.5, 0.75, 1.5 }) };
  LabelImage::Pointer labels{ basetest::NewImage<LabelImage>(size, { 0.5, 0.75, 1.5 }) };
  std::uint64_t       voxels[4]{};
};

const shapeton::RGBColor red = shapeton::MakeColor(255, 0, 0);
const shapeton::RGBColor blue = shapeton::MakeColor(0, 0, 255);
} // namespace

TEST(ObjectColors, TheSmallestObjectOfAVoxelTakesPrecedenceOverLargerOnesAndLines)
{
  const Scene                    scene;
  const auto                     lines = shapeton::ShapeTransferFunction::Parse("0-0.25:lime:1,0.5-0.75:yellow:1");
  const std::vector<ObjectColor> objects{ { 2, { 2 }, scene.voxels[2], red, 1.0 },
                                          { 1, { 1, 2 }, scene.voxels[1] + scene.voxels[2], blue, 0.5 } };
  const auto [values, classes] = shapeton::ColorObjects(scene.heat, lines, scene.labels, objects, "labels.nrrd");
  for (std::size_t voxel = 0; voxel < scene.heat->GetBufferedRegion().GetNumberOfPixels(); ++voxel)
  {
    const auto label = scene.labels->GetBufferPointer()[voxel];
    const int  expected = label == 2 ? 2 : label == 1 ? 3 : lines.LineOf(scene.heat->GetBufferPointer()[voxel]);
    ASSERT_EQ(classes.LineOf(values->GetBufferPointer()[voxel]), expected) << voxel;
  }
  const auto legend = shapeton::LegendOf(classes);
  EXPECT_EQ(legend[0].text, "0 to 0.25");
  EXPECT_EQ(legend[2].text, "object 2");
  EXPECT_EQ(legend[2].color, red);
  EXPECT_EQ(shapeton::CountVoxelsOfLines(values, classes)[3], scene.voxels[1]);
}

TEST(ObjectColors, AnObjectIsDrawnLikeALineOfItsVoxels)
{
  const Scene scene;
  auto        mask = basetest::NewImage<HeatImage>(size, { 0.5, 0.75, 1.5 });
  for (std::size_t voxel = 0; voxel < mask->GetBufferedRegion().GetNumberOfPixels(); ++voxel)
  {
    mask->GetBufferPointer()[voxel] = scene.labels->GetBufferPointer()[voxel] == 3 ? 0.5F : 0.0F;
  }
  const auto drawn =
    shapeton::ColorObjects(scene.heat, {}, scene.labels, { { 3, { 3 }, scene.voxels[3], red, 0.7 } }, "labels");
  const auto one = shapeton::RenderVolume(drawn.values, drawn.lines);
  const auto other = shapeton::RenderVolume(mask, shapeton::ShapeTransferFunction::Parse("0.25-0.75:#ff0000:0.7"));
  const auto pixels = one->GetBufferedRegion().GetNumberOfPixels();
  ASSERT_EQ(other->GetBufferedRegion().GetNumberOfPixels(), pixels);
  EXPECT_TRUE(std::equal(one->GetBufferPointer(), one->GetBufferPointer() + pixels, other->GetBufferPointer()));
}

TEST(ObjectColors, RefusesLabelsOfOtherObjects)
{
  const Scene scene;
  const auto  fault = [&](const ObjectColor & object) {
    return basetest::ErrorOf([&] { shapeton::ColorObjects(scene.heat, {}, scene.labels, { object }, "labels.nrrd"); });
  };
  EXPECT_EQ(fault({ 1, { 1, 2 }, scene.voxels[1] + scene.voxels[2], red, 1.0 }), "");
  EXPECT_NE(fault({ 1, { 1 }, 7, red, 1.0 })
              .find("object 1 has " + std::to_string(scene.voxels[1]) + " voxels in labels.nrrd, but 7"),
            std::string::npos);
  EXPECT_NE(fault({ 9, { 9 }, 5, red, 1.0 }).find("object 9 has 0 voxels"), std::string::npos);
}

TEST(ObjectColors, ClassesAreToldApartUpToTwoHundredObjects)
{
  const std::vector<shapeton::TransferFunctionLine> lines(212);
  const auto                                        classes = shapeton::ShapeTransferFunction::OfClasses(lines);
  for (int i = 0; i < 212; ++i)
  {
    EXPECT_EQ(classes.LineOf((static_cast<float>(i) + 0.5F) / 212.0F), i);
  }
}
