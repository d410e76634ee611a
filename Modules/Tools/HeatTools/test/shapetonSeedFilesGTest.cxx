#include "shapetonSeedFiles.h"
#include "shapetonObliqueBoxes.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonTestImages.h"

#include "gtest/gtest.h"

namespace
{
using namespace obliqueboxes;
using shapeton::Markup;

Eigen::Vector3d
PlaceOf(const itk::ImageBase<3> * image, const itk::Index<3> & index)
{
  itk::Point<double, 3> point;
  image->TransformIndexToPhysicalPoint(index, point);
  return { point[0], point[1], point[2] };
}

std::vector<Markup>
MakeMarkups(const ImageType * image)
{
  std::vector<Markup> markups(3);
  markups[0].name = "dark";
  markups[0].points = { PlaceOf(image, { { 2, 3, 4 } }) };
  markups[1].name = "gray";
  markups[1].points = { PlaceOf(image, { { 12, 2, 2 } }), PlaceOf(image, { { 17, 12, 7 } }) };
  markups[1].kind = Markup::Kind::Curve;
  markups[2].name = "bright";
  markups[2].points = { PlaceOf(image, { { 29, 13, 8 } }), PlaceOf(image, { { 25, 1, 0 } }) };
  return markups;
}
} // namespace

TEST(SeedFiles, MarkupsLabelBoxesOnAnObliqueGrid)
{
  const auto image = MakeBoxes();
  const auto seeds = shapeton::SeedsOfMarkups(MakeMarkups(image), image);
  EXPECT_EQ(Count(seeds, 1), 1u);
  EXPECT_GE(Count(seeds, 2), 11u); // a stroke over eleven rows
  EXPECT_EQ(Count(seeds, 3), 2u);
  const auto filter = shapeton::SeededHeatSegmentationImageFilter<ImageType>::New();
  filter->SetInput(image);
  filter->SetSeeds(seeds);
  filter->Update();
  for (itk::ImageRegionIteratorWithIndex<SeedImage> it(filter->GetOutput(), image->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    ASSERT_EQ(it.Get(), 1 + it.GetIndex()[0] / 10);
  }
}

TEST(SeedFiles, AStrokeMarksAllVoxelsThatItPasses)
{
  const auto image = MakeBoxes();
  auto       markups = MakeMarkups(image);
  markups.resize(2); // the second one is a stroke
  markups[1].points = { PlaceOf(image, { { 1, 1, 1 } }), PlaceOf(image, { { 28, 12, 7 } }) };
  const auto  seeds = shapeton::SeedsOfMarkups(markups, image);
  std::size_t passed = 0;
  for (itk::ImageRegionIteratorWithIndex<SeedImage> it(seeds, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    double enter = 0.0; // interval of the stroke between the faces of the voxel, axis by axis
    double leave = 1.0;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double along[3] = { 27.0, 11.0, 6.0 };
      const double from = static_cast<double>(it.GetIndex()[axis]) - 1.0;
      enter = std::max(enter, (from - 0.5) / along[axis]);
      leave = std::min(leave, (from + 0.5) / along[axis]);
    }
    if (std::abs(leave - enter) > 1e-9) // a touched corner depends on rounding
    {
      EXPECT_EQ(it.Get() == 2, leave > enter) << it.GetIndex();
      passed += leave > enter ? 1 : 0;
    }
  }
  EXPECT_GT(passed, 40U); // 27 + 11 + 6 crossings of faces, some at edges
}

TEST(SeedFiles, MarkupsThatCannotBeSeedsAreRefused)
{
  const auto image = MakeBoxes();
  auto       markups = MakeMarkups(image);
  markups[2].points.push_back(PlaceOf(image, { { 31, 2, 2 } }));
  EXPECT_EQ(basetest::ErrorOf([&] { shapeton::SeedsOfMarkups(markups, image); }),
            "point 3 of the markup \"bright\" is outside the volume; move it into the segmented volume");
  markups[2].points.back() = markups[0].points[0];
  EXPECT_TRUE(Refuses([&] { shapeton::SeedsOfMarkups(markups, image); }, "already a seed of label 1"));
  markups[2].points.clear();
  EXPECT_TRUE(Refuses([&] { shapeton::SeedsOfMarkups(markups, image); }, "\"bright\" has no point"));
}

TEST(SeedFiles, LabelMapsLieOnTheGridAndHoldWholeNumbers)
{
  const auto       image = MakeBoxes();
  shapeton::Volume volume;
  volume.image = shapeton::NewImageOn<shapeton::Volume::ImageType>(image, true);
  volume.image->SetPixel({ { 3, 3, 3 } }, 65535.0F);
  EXPECT_EQ(Count(shapeton::LabelsOfVolume(volume, "map", image), 65535), 1u);
  for (const float value : { 0.5F, -1.0F, 65536.0F })
  {
    volume.image->SetPixel({ { 3, 3, 3 } }, value);
    EXPECT_TRUE(Refuses([&] { shapeton::LabelsOfVolume(volume, "map", image); }, "map: labels must be whole"));
  }
  const double moved[3] = { 0.0, 0.0, 0.0 };
  volume.image->SetOrigin(moved);
  EXPECT_TRUE(Refuses([&] { shapeton::LabelsOfVolume(volume, "map", image); }, "different grids"));
}
