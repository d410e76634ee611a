#include "shapetonSliceChoice.h"

#include "gtest/gtest.h"

namespace
{
using LabelImage = shapeton::HeatObjectList::LabelImage;
using HeatImage = itk::Image<float, 3>;

/** 40 x 40 x 40 voxels, starting at the index (5, 0, -3). */
template <typename TImage>
typename TImage::Pointer
MakeCube()
{
  auto                              image = TImage::New();
  const typename TImage::RegionType region({ { 5, 0, -3 } }, { { 40, 40, 40 } });
  image->SetRegions(region);
  image->Allocate(true);
  return image;
}

/** Sets a cube of voxels; (x, y, z) counts from the first voxel of the image. */
template <typename TImage>
void
Fill(TImage * image, int x, int y, int z, int side, typename TImage::PixelType value)
{
  for (int i = 0; i < side * side * side; ++i)
  {
    image->SetPixel({ { x + i % side + 5, y + i / side % side, z + i / side / side - 3 } }, value);
  }
}

constexpr itk::Index<3> middle{ { 24, 19, 16 } }; // the first of the two slices at the middle
} // namespace

TEST(SliceChoice, SeveralPartsCountMoreThanOneLargerPart)
{
  const auto labels = MakeCube<LabelImage>();
  Fill(labels.GetPointer(), 2, 2, 4, 9, 1);
  Fill(labels.GetPointer(), 20, 20, 6, 9, 2); // shares z from 6 to 12 with the first
  Fill(labels.GetPointer(), 20, 2, 25, 12, 3);
  const auto cut = shapeton::CutThroughParts(labels);
  EXPECT_EQ(cut[2], 12 - 3) << "of equal slices, the one nearest to the middle";
  EXPECT_EQ(cut[0], 20 + 5) << "parts 2 and 3";
  EXPECT_EQ(cut[1], 10) << "parts 1 and 3";
}

TEST(SliceChoice, TinyPartsDoNotDecide)
{
  const auto labels = MakeCube<LabelImage>();
  Fill(labels.GetPointer(), 4, 4, 4, 12, 1);
  for (int i = 0; i < 5; ++i)
  {
    Fill(labels.GetPointer(), 30, 5 * i, 35, 1, static_cast<unsigned short>(2 + i)); // five parts of one voxel
  }
  const auto cut = shapeton::CutThroughParts(labels);
  EXPECT_EQ(cut[2], 15 - 3);
  EXPECT_EQ(cut[0], 15 + 5);
}

TEST(SliceChoice, LinesAreParts)
{
  const auto heat = MakeCube<HeatImage>();
  Fill(heat.GetPointer(), 2, 2, 2, 4, 0.3F);
  Fill(heat.GetPointer(), 20, 20, 20, 12, 0.6F);
  const auto at = [&](const char * lines) {
    return shapeton::CutThroughParts(heat, shapeton::ShapeTransferFunction::Parse(lines));
  };
  EXPECT_EQ(at("0.2-0.4:red:1,0.5-0.7:blue:1"), (itk::Index<3>{ { 25, 20, 17 } }));
  EXPECT_EQ(at("0.2-0.4:red:1,0.5-0.7:blue:0"), (itk::Index<3>{ { 10, 5, 2 } })) << "without the transparent line";
  EXPECT_EQ(at("0.8-0.9:red:1"), middle) << "no part";
}
