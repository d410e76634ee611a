#include "shapetonObliqueBoxes.h"
#include "shapetonSeededHeatSegmentationImageFilter.h"
#include "shapetonTestImages.h"

#include "gtest/gtest.h"

namespace
{
using namespace obliqueboxes;
using FilterType = shapeton::SeededHeatSegmentationImageFilter<ImageType>;

/** A point in the first box, a stroke of 11 voxels in the second one, two points in the third one. */
SeedImage::Pointer
MakeSeeds(const ImageType * image)
{
  const auto seeds = shapeton::NewImageOn<shapeton::SeedImage>(image, true);
  seeds->SetPixel({ { 2, 3, 4 } }, 1);
  for (int i = 0; i <= 10; ++i)
  {
    seeds->SetPixel({ { 12 + i / 2, 2 + i, 2 + i / 2 } }, 2);
  }
  seeds->SetPixel({ { 29, 13, 8 } }, 3);
  seeds->SetPixel({ { 25, 1, 0 } }, 3);
  return seeds;
}
} // namespace

TEST(SeededHeatSegmentationImageFilter, LabelsBoxesOnAnObliqueGrid)
{
  const auto image = MakeBoxes();
  const auto seeds = MakeSeeds(image);
  auto       filter = FilterType::New();
  EXPECT_EQ(filter->GetP(), 100.0);
  filter->SetInput(image);
  filter->SetSeeds(seeds);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetOrigin(), image->GetOrigin());
  EXPECT_EQ(filter->GetOutput()->GetDirection(), image->GetDirection());
  EXPECT_EQ(filter->GetUncertaintyOutput()->GetSpacing(), image->GetSpacing());
  const auto probabilities = filter->GetProbabilities(2);
  for (itk::ImageRegionIteratorWithIndex<SeedImage> it(filter->GetOutput(), image->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    ASSERT_EQ(it.Get(), 1 + it.GetIndex()[0] / 10);
    ASSERT_EQ(probabilities->GetPixel(it.GetIndex()) > 0.5F, it.Get() == 2);
    ASSERT_LT(filter->GetUncertaintyOutput()->GetPixel(it.GetIndex()), 0.1F);
  }
}

TEST(SeededHeatSegmentationImageFilter, RunsAgainWhatHasChanged)
{
  const auto image = MakeBoxes();
  const auto seeds = MakeSeeds(image);
  auto       filter = FilterType::New();
  filter->SetInput(image);
  filter->SetSeeds(seeds);
  filter->Update();
  EXPECT_GT(filter->GetIterations(), 0u);
  seeds->Modified(); // unchanged seeds: the last solution is reused
  filter->Update();
  EXPECT_EQ(filter->GetIterations(), 0u);
  image->SetPixel({ { 5, 5, 5 } }, 600);
  image->Modified(); // another volume: everything is recomputed
  filter->Update();
  EXPECT_GT(filter->GetIterations(), 0u);
  filter->SetLeastWeight(0.001);
  filter->Update();
  EXPECT_GT(filter->GetIterations(), 0u);
  filter->SetSmoothing(0.5);
  filter->Update();
  EXPECT_GT(filter->GetIterations(), 0u);
  filter->KeepProbabilitiesOff();
  filter->Update();
  EXPECT_THROW(filter->GetProbabilities(1), shapeton::ParameterError);
}

TEST(SeededHeatSegmentationImageFilter, NothingOfTheLastRunRemainsAfterAnError)
{
  const auto image = MakeBoxes();
  const auto seeds = MakeSeeds(image);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetSeeds(seeds);
  filter->KeepProbabilitiesOn();
  filter->Update();
  EXPECT_NO_THROW(filter->GetProbabilities(1));
  seeds->FillBuffer(0);
  seeds->Modified();
  EXPECT_THROW(filter->Update(), shapeton::InputError);
  EXPECT_TRUE(filter->GetLabelValues().empty());
  filter->SetSeeds(basetest::WithoutPixels<shapeton::SeedImage>(image));
  EXPECT_THROW(filter->Update(), shapeton::InputError);
  EXPECT_THROW(filter->GetProbabilities(1), shapeton::ParameterError);
}

TEST(SeededHeatSegmentationImageFilter, OutputsMayBeTakenAwayBetweenRuns)
{
  const auto image = MakeBoxes();
  const auto seeds = MakeSeeds(image);
  auto       filter = FilterType::New();
  filter->SetInput(image);
  filter->SetSeeds(seeds);
  filter->Update();
  const FilterType::LabelImageType::Pointer labels = filter->GetOutput();
  const FilterType::HeatImageType::Pointer  uncertainty = filter->GetUncertaintyOutput();
  labels->DisconnectPipeline();
  uncertainty->DisconnectPipeline();
  ASSERT_NE(dynamic_cast<FilterType::HeatImageType *>(filter->GetIndexedOutputs()[1].GetPointer()), nullptr);
  seeds->Modified();
  filter->Update();
  EXPECT_NE(filter->GetOutput(), labels);
  const auto number = labels->GetBufferedRegion().GetNumberOfPixels();
  EXPECT_TRUE(std::equal(
    labels->GetBufferPointer(), labels->GetBufferPointer() + number, filter->GetOutput()->GetBufferPointer()));
  const FilterType::LabelImageType::Pointer taken = filter->GetOutput();
  taken->DisconnectPipeline();
  const auto probabilities = filter->GetProbabilities(2); // of the last run, independent of its labels
  EXPECT_EQ(probabilities->GetBufferedRegion(), image->GetBufferedRegion());
  EXPECT_EQ(probabilities->GetOrigin(), image->GetOrigin());
  EXPECT_GT(probabilities->GetPixel({ { 15, 7, 4 } }), 0.5F);
  EXPECT_TRUE(std::equal(uncertainty->GetBufferPointer(),
                         uncertainty->GetBufferPointer() + number,
                         filter->GetUncertaintyOutput()->GetBufferPointer()));
}

TEST(SeededHeatSegmentationImageFilter, NamesWhatIsWrong)
{
  const auto image = MakeBoxes();
  auto       filter = FilterType::New();
  filter->SetInput(image);
  EXPECT_TRUE(Refuses([&] { filter->Update(); }, "Seeds")); // required
  const auto seeds = shapeton::NewImageOn<shapeton::SeedImage>(image, true);
  filter->SetSeeds(seeds);
  EXPECT_TRUE(Refuses([&] { filter->Update(); }, "no voxel has a seed"));
  seeds->SetPixel({ { 1, 1, 1 } }, 7);
  seeds->Modified();
  EXPECT_TRUE(Refuses([&] { filter->Update(); }, "all seeds have the label 7"));
  seeds->SetPixel({ { 1, 1, 2 } }, 8);
  seeds->Modified();
  filter->SetTolerance(2.0);
  EXPECT_TRUE(Refuses([&] { filter->Update(); }, "\"tolerance\""));
  filter->SetTolerance(1e-5);
  for (const double weight : { -1.0, 0.0, std::nan("") })
  {
    filter->SetLeastWeight(weight);
    EXPECT_THROW(filter->Update(), shapeton::ParameterError) << weight;
  }
  filter->SetLeastWeight(0.01);
  EXPECT_NO_THROW(filter->Update());
}

TEST(SeededHeatSegmentationImageFilter, ProgressAscendsToTheEnd)
{
  const auto image = MakeBoxes();
  auto       filter = FilterType::New();
  filter->SetInput(image);
  filter->SetSeeds(MakeSeeds(image));
  std::vector<double> shares;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { shares.push_back(filter->GetProgress()); });
  filter->Update();
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_NEAR(shares.back(), 1.0, 1e-6);
}

TEST(HeatSeeds, ClassesGiveSeedsAwayFromTheirBorders)
{
  auto       classes = basetest::NewImage<SeedImage>({ { 20, 10, 10 } });
  const auto fill = [&](const itk::Index<3> & low, const itk::Index<3> & high, unsigned short value) {
    for (itk::ImageRegionIteratorWithIndex<SeedImage> it(classes, classes->GetLargestPossibleRegion()); !it.IsAtEnd();
         ++it)
    {
      const auto i = it.GetIndex();
      if (i[0] >= low[0] && i[1] >= low[1] && i[2] >= low[2] && i[0] < high[0] && i[1] < high[1] && i[2] < high[2])
      {
        it.Set(value);
      }
    }
  };
  fill({ { 1, 1, 1 } }, { { 4, 4, 4 } }, 5);   // 27 voxels, one inside
  fill({ { 10, 2, 2 } }, { { 15, 7, 7 } }, 5); // 125 voxels, 27 inside
  fill({ { 17, 8, 8 } }, { { 19, 9, 9 } }, 9); // consists of border voxels only
  shapeton::ClassSeeds choice;                 // lines
  auto                 seeds = shapeton::SeedsOfClasses(classes, choice);
  EXPECT_EQ(Count(seeds, 1), 28u);
  EXPECT_EQ(Count(seeds, 2), 2u);
  EXPECT_EQ(Count(seeds, 0), 2000u - 30u);
  choice.components = 2;
  choice.classes = { 5 };
  seeds = shapeton::SeedsOfClasses(classes, choice);
  EXPECT_EQ(Count(seeds, 1), 27u); // the largest first
  EXPECT_EQ(Count(seeds, 2), 1u);
  EXPECT_EQ(Count(seeds, 3), 0u);
  choice.classes = { 6 };
  EXPECT_TRUE(Refuses([&] { shapeton::SeedsOfClasses(classes, choice); }, "class 6 has no voxel"));
}
