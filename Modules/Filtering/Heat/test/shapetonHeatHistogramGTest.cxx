#include "shapetonExceptions.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatHistogram.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

using namespace shapeton;

TEST(HeatHistogram, EveryBinHoldsItsOwnEdges)
{
  for (unsigned int bin = 1; bin < HeatHistogram::NumberOfBins; ++bin)
  {
    const auto lower = static_cast<float>(HeatHistogram::LowerEdge(bin));
    EXPECT_EQ(HeatHistogram::BinOf(lower), bin);
    EXPECT_EQ(HeatHistogram::BinOf(std::nextafter(lower, 0.0F)), bin - 1);
    EXPECT_LT(HeatHistogram::LowerEdge(bin), HeatHistogram::LowerEdge(bin + 1));
  }
  EXPECT_EQ(HeatHistogram::LowerEdge(HeatHistogram::NumberOfBins), 1.0);
  EXPECT_EQ(HeatHistogram::BinOf(1.0F), HeatHistogram::NumberOfBins - 1);
  EXPECT_EQ(HeatHistogram::BinOf(1.5F), HeatHistogram::NumberOfBins - 1);
  EXPECT_EQ(HeatHistogram::BinOf(0.0F), 0U);
  EXPECT_EQ(HeatHistogram::BinOf(-0.1F), 0U);
}

TEST(HeatHistogram, CountsEveryVoxelOnce)
{
  HeatHistogram            histogram({ 0, 10 });
  const std::vector<float> heats{ 0.0F, 0.5F, 0.5F, 0.25F, 1.0F, -1e-7F };
  histogram.AddToRow(1, heats.data(), heats.size());
  EXPECT_EQ(histogram.GetCount(1, HeatHistogram::BinOf(0.5F)), 2U);
  EXPECT_EQ(histogram.GetCount(1, 0), 2U);
  EXPECT_EQ(std::accumulate(histogram.GetRow(1), histogram.GetRow(1) + HeatHistogram::NumberOfBins, 0U), 6U);
  EXPECT_EQ(std::accumulate(histogram.GetRow(0), histogram.GetRow(0) + HeatHistogram::NumberOfBins, 0U), 0U);
  EXPECT_THROW(HeatHistogram({ 10, 0 }), ParameterError);
  EXPECT_THROW(histogram.AddToRow(2, heats.data(), heats.size()), ParameterError);
  EXPECT_THROW(FindHeatClasses(histogram, 2), ParameterError);
  EXPECT_THROW(FindHeatClasses(HeatHistogram(), 0), ParameterError);
}

TEST(HeatClassification, RefusesWhatIsNoHeat)
{
  using Image = itk::Image<float, 3>;
  const auto heat = basetest::NewImage<Image>({ { 4, 4, 4 } });
  EXPECT_NO_THROW(ClassifyHeat(heat));
  EXPECT_THROW(ClassifyHeat(heat, CumulativeHeatDiffusionResult()), ParameterError); // without classes
  for (const float wrong : { std::numeric_limits<float>::quiet_NaN(), 40.0F, -1000.0F })
  {
    heat->SetPixel({ { 1, 2, 3 } }, wrong);
    EXPECT_THROW(ClassifyHeat(heat), InputError);
  }
  EXPECT_THROW(ClassifyHeat(basetest::WithoutPixels<Image>(heat)), InputError);
  EXPECT_THROW(ClassifyHeat(nullptr), InputError);
}

TEST(HeatHistogram, EqualizationGivesEachHeatTheShareOfTheVoxelsBelowIt)
{
  HeatHistogram      histogram({ 0 });
  std::vector<float> heats(100, 0.0F); // background is not counted
  heats.insert(heats.end(), 30, 0.1F);
  heats.insert(heats.end(), 60, 0.11F);
  heats.insert(heats.end(), 10, 0.9F);
  histogram.AddToRow(0, heats.data(), heats.size());
  const auto place = histogram.GetEqualization();
  ASSERT_EQ(place.size(), HeatHistogram::NumberOfBins + 1);
  EXPECT_TRUE(std::is_sorted(place.begin(), place.end()));
  EXPECT_DOUBLE_EQ(place.front(), 0.0);
  EXPECT_DOUBLE_EQ(place.back(), 1.0);
  EXPECT_DOUBLE_EQ(place[HeatHistogram::BinOf(0.1F)], 0.0);
  EXPECT_DOUBLE_EQ(place[HeatHistogram::BinOf(0.11F)], 0.3);
  EXPECT_DOUBLE_EQ(place[HeatHistogram::BinOf(0.9F)], 0.9);
}

TEST(HeatHistogram, EqualizationCountsEachRowTheSame)
{
  HeatHistogram            histogram({ 0, 10 });
  const std::vector<float> many(1000, 0.01F);
  const std::vector<float> few(10, 0.5F);
  histogram.AddToRow(0, many.data(), many.size());
  histogram.AddToRow(1, few.data(), few.size());
  const auto place = histogram.GetEqualization();
  EXPECT_DOUBLE_EQ(place[HeatHistogram::BinOf(0.01F) + 1], 0.5);
  EXPECT_DOUBLE_EQ(place[HeatHistogram::BinOf(0.5F)], 0.5);
}

namespace
{
/** Normally distributed heat around a mean, as quantiles instead of random numbers. */
void
AddPeak(std::vector<float> & heats, double mean, double deviation, int number)
{
  for (int i = 0; i < number; ++i)
  {
    const double u = (i + 0.5) / number;
    heats.push_back(static_cast<float>(mean + deviation * std::log(u / (1.0 - u)) * 0.5513)); // logistic, unit variance
  }
}

itk::Image<float, 3>::Pointer
MakeHeatImage(const std::vector<float> & heats)
{
  auto image = basetest::NewImage<itk::Image<float, 3>>({ { heats.size(), 1, 1 } }, { { 0.5, 1.0, 2.0 } });
  std::copy(heats.begin(), heats.end(), image->GetBufferPointer());
  return image;
}
} // namespace

TEST(HeatClassification, FindsThePeaksInAscendingOrder)
{
  std::vector<float> heats(5000, 0.0F);
  AddPeak(heats, 0.047, 0.0003, 2000);
  AddPeak(heats, 0.093, 0.001, 3000);
  AddPeak(heats, 0.19, 0.0001, 500);
  HeatHistogram histogram({ 1000 });
  histogram.AddToRow(0, heats.data(), heats.size());
  auto classes = FindHeatClasses(histogram, 0);
  ASSERT_EQ(classes.size(), 4U);
  EXPECT_EQ(classes[0].voxels, 5000U);
  const std::vector<double> means{ 0.0, 0.047, 0.093, 0.19 };
  for (unsigned int label = 1; label < 4; ++label)
  {
    EXPECT_EQ(classes[label].label, label);
    EXPECT_NEAR(classes[label].meanHeat, means[label], 0.01 * means[label]);
    EXPECT_EQ(classes[label].lowerHeat, classes[label - 1].upperHeat);
  }
  EXPECT_EQ(classes.back().upperHeat, 1.0);

  const auto labels = LabelHeat(MakeHeatImage(heats), classes);
  EXPECT_EQ(labels->GetPixel({ { 0, 0, 0 } }), 0);
  EXPECT_EQ(labels->GetPixel({ { 6000, 0, 0 } }), 1);
  EXPECT_EQ(labels->GetPixel({ { 8500, 0, 0 } }), 2);
  EXPECT_EQ(labels->GetPixel({ { 10400, 0, 0 } }), 3);
  EXPECT_EQ(classes[1].voxels + classes[2].voxels + classes[3].voxels, 5500U);
  EXPECT_DOUBLE_EQ(classes[0].volume, 5000.0);
}

TEST(HeatClassification, AShallowValleyMakesNoClassAndTheLimitHolds)
{
  std::vector<float> heats;
  AddPeak(heats, 0.100, 0.004, 3000);
  AddPeak(heats, 0.106, 0.004, 3000); // merged with the first
  AddPeak(heats, 0.300, 0.002, 2000);
  AddPeak(heats, 0.600, 0.002, 2000);
  HeatHistogram histogram({ 1000 });
  histogram.AddToRow(0, heats.data(), heats.size());
  EXPECT_EQ(FindHeatClasses(histogram, 0).size(), 4U);
  HeatClassificationRule two;
  two.maximumNumberOfClasses = 2;
  EXPECT_EQ(FindHeatClasses(histogram, 0, two).size(), 3U);
  two.maximumNumberOfClasses = 0;
  EXPECT_THROW(FindHeatClasses(histogram, 0, two), ParameterError);
}

TEST(HeatClassification, AnEvenSpreadOverOctavesIsOneClass)
{
  // Uniform in log(heat), across the octaves where the width of the bins doubles.
  std::vector<float> heats;
  for (int i = 0; i < 200000; ++i)
  {
    heats.push_back(static_cast<float>(0.01 * std::exp2(5.0 * (i + 0.5) / 200000)));
  }
  HeatHistogram histogram({ 0 });
  histogram.AddToRow(0, heats.data(), heats.size());
  EXPECT_EQ(FindHeatClasses(histogram, 0).size(), 2U);
}

TEST(HeatClassification, LinesBelowTheBackgroundHeatAreBackground)
{
  std::vector<float> heats(1000, 0.0F);
  AddPeak(heats, 0.0002, 0.000005, 2000);
  AddPeak(heats, 0.0006, 0.00001, 2000);
  AddPeak(heats, 0.002, 0.00001, 2000);
  HeatHistogram histogram({ 0 });
  histogram.AddToRow(0, heats.data(), heats.size());
  const auto classes = FindHeatClasses(histogram, 0);
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].voxels, 5000U);
  EXPECT_NEAR(classes[1].meanHeat, 0.002, 0.00002);
  EXPECT_EQ(classes[1].lowerHeat, classes[0].upperHeat);
}

TEST(HeatClassification, AColdVolumeHasOnlyBackground)
{
  const std::vector<float> heats(64, 0.0F);
  HeatHistogram            histogram({ 0 });
  histogram.AddToRow(0, heats.data(), heats.size());
  auto classes = FindHeatClasses(histogram, 0);
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].voxels, 64U);
  EXPECT_EQ(LabelHeat(MakeHeatImage(heats), classes)->GetPixel({ { 3, 0, 0 } }), 0);
}

TEST(HeatClassification, TheSurroundingsHoldTheBorder)
{
  auto heat = basetest::NewImage<itk::Image<float, 3>>({ { 10, 10, 10 } });
  heat->FillBuffer(0.01F);
  for (itk::IndexValueType z = 2; z < 8; ++z)
  {
    for (itk::IndexValueType y = 2; y < 8; ++y)
    {
      for (itk::IndexValueType x = 2; x < 10; ++x)
      {
        heat->SetPixel({ { x, y, z } }, 0.2F); // touches one side
      }
    }
  }
  const auto classification = ClassifyHeat(heat);
  ASSERT_EQ(classification.classes.size(), 3U);
  const double border = 1000.0 - 512.0;
  EXPECT_NEAR(classification.classes[2].borderShare, 36.0 / border, 1e-12);
  EXPECT_NEAR(classification.classes[1].borderShare, (border - 36.0) / border, 1e-12);
}

TEST(HeatClassification, ContiguityIsHighForACubeAndZeroForACheckerboard)
{
  constexpr int side = 10;
  auto          labels = itk::Image<unsigned char, 3>::New();
  labels->SetRegions(itk::Size<3>{ { 3 * side, 3 * side, 3 * side } });
  labels->Allocate(true);
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        labels->SetPixel({ { x + 2, y + 2, z + 2 } }, (x + y + z) % 2 == 0 ? 1 : 0);
        labels->SetPixel({ { x + 2 * side, y + 2 * side, z + 2 * side } },
                         2); // at the border: three sides without faces
      }
    }
  }
  std::vector<shapeton::HeatClass> classes(3);
  for (unsigned int label = 0; label < 3; ++label)
  {
    classes[label].label = label;
  }
  shapeton::MeasureContiguity(labels, classes);
  EXPECT_EQ(*classes[1].coherence, 0.0);
  constexpr double inside = 6.0 * side * side * (side - 1);
  constexpr double outside = 3.0 * side * side;
  EXPECT_NEAR(*classes[2].coherence, (inside - outside) / (inside + outside), 1e-12);
}

TEST(HeatClassification, ConvergedComponentsJoinTheClassOfTheirHeat)
{
  std::vector<HeatClass> classes(3);
  classes[0].upperHeat = classes[1].lowerHeat = 1e-5;
  classes[1].upperHeat = classes[2].lowerHeat = 0.15;
  classes[2].upperHeat = 1.0;
  classes[1].label = 1;
  classes[2].label = 2;
  std::vector<ShapeComponent> components(5);
  const std::vector<double>   heats{ 0.1, 0.12, 0.2, 0.0, 0.3 };
  for (std::size_t i = 0; i < 5; ++i)
  {
    components[i].index = { i, 0, 0 };
    components[i].closed = i != 3;
    components[i].voxels = 100 * (i + 1);
    components[i].convergedHeat = heats[i];
    components[i].normalizedHeat = 0.8 + 0.1 * i;
  }
  const auto heat = MakeHeatImage({ 0.1F, 0.123F, 0.2F, 0.0F, 0.1F }); // the last one has not converged
  AssignComponents(components, heat, classes);
  EXPECT_EQ(classes[0].components, 0U);
  EXPECT_EQ(classes[1].components, 2U);
  EXPECT_EQ(classes[2].components, 1U);
  EXPECT_NEAR(classes[1].normalizedHeat, (100 * 0.8 + 200 * 0.9) / 300.0, 1e-12);
  EXPECT_NEAR(classes[2].normalizedHeat, 1.0, 1e-12);
}
