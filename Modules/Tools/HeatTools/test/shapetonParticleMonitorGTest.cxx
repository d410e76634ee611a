#include "shapetonParticleMonitor.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonTestImages.h"

namespace
{
using ImageType = itk::Image<float, 3>;

/** 24^3 voxels of 0 with a box of 100, from index 4 to 11 along each axis. */
ImageType::Pointer
MakeBox()
{
  auto image = basetest::NewImage<ImageType>({ { 24, 24, 24 } });
  image->FillBuffer(0.0F);
  for (int i = 0; i < 8 * 8 * 8; ++i)
  {
    image->SetPixel({ { 4 + i % 8, 4 + i / 8 % 8, 4 + i / 64 } }, 100.0F);
  }
  return image;
}

TEST(ParticleMonitor, CutsThroughTheMiddleOfTheObjects)
{
  const auto box = MakeBox();
  // 7.5 is rounded up.
  EXPECT_EQ(shapeton::MiddleOfObjects(box, 0.0), (itk::Index<3>{ { 8, 8, 8 } }));
  EXPECT_EQ(shapeton::MiddleOfObjects(box, 100.0), (itk::Index<3>{ { 12, 12, 12 } }));
}

TEST(ParticleMonitor, PreviewShowsFewVisitsInBlueAndManyInRed)
{
  const auto box = MakeBox();
  auto       visits = itk::Image<std::uint32_t, 3>::New();
  visits->SetRegions(box->GetLargestPossibleRegion());
  visits->Allocate();
  for (std::size_t voxel = 0; voxel < 24 * 24 * 24; ++voxel)
  {
    const bool inside = box->GetBufferPointer()[voxel] > 0.0F;
    visits->GetBufferPointer()[voxel] = (inside ? 500U : 50U) + static_cast<std::uint32_t>(voxel % 3);
  }
  shapeton::ParticleProgress progress;
  progress.measures.step = 10;
  progress.timeSteps = 100;
  const auto preview = shapeton::DrawParticlePreview(box, visits, { { 8, 8, 8 } }, progress);
  ASSERT_EQ(preview->GetBufferedRegion().GetSize(0), 1200U);
  // Count colors in the whole picture: the box covers (8/24)^2 of each slice.
  double red = 0.0;
  double blue = 0.0;
  for (unsigned int y = 90; y < preview->GetBufferedRegion().GetSize(1) - 60; ++y)
  {
    for (int x = 20; x < 1180; ++x)
    {
      const auto color = shapeton::At(preview, x, static_cast<int>(y));
      red += color[0] > color[2] + 40;
      blue += color[2] > color[0] + 40;
    }
  }
  EXPECT_NEAR(red / (red + blue), 1.0 / 9.0, 0.02);
}

TEST(ParticleMonitor, PreviewsDifferByTheirStep)
{
  const auto box = MakeBox();
  auto       visits = itk::Image<std::uint32_t, 3>::New();
  visits->SetRegions(box->GetLargestPossibleRegion());
  visits->Allocate();
  visits->FillBuffer(3);
  shapeton::ParticleProgress progress;
  progress.timeSteps = 100;
  const auto first = shapeton::DrawParticlePreview(box, visits, { { 8, 8, 8 } }, progress);
  progress.measures.step = 99;
  const auto last = shapeton::DrawParticlePreview(box, visits, { { 8, 8, 8 } }, progress);
  EXPECT_GT(shapeton::GreatestDifference(first, last), 100);
  EXPECT_EQ(shapeton::GreatestDifference(last, shapeton::DrawParticlePreview(box, visits, { { 8, 8, 8 } }, progress)),
            0);
}
} // namespace
