#include "shapetonShapeAnalysis.h"
#include "shapetonPictureTestUtilities.h"

#include "shapetonHeatSnapshot.h"
#include "shapetonVisitDensity.h"
#include "shapetonTestImages.h"

#include <algorithm>
#include <numeric>

namespace
{
using VisitsType = itk::Image<std::uint32_t, 3>;

/** Slices of 100 voxels with these numbers of visits; the middle ones vary by one. */
VisitsType::Pointer
MakeVisits(const std::vector<std::uint32_t> & slices)
{
  auto image = basetest::NewImage<VisitsType>({ { 10, 10, slices.size() } });
  for (std::size_t voxel = 0; voxel < 100 * slices.size(); ++voxel)
  {
    const std::uint32_t visits = slices[voxel / 100];
    image->GetBufferPointer()[voxel] = visits == 0 ? 0 : visits + static_cast<std::uint32_t>(voxel % 2);
  }
  return image;
}

TEST(VisitDensity, IsInUnitsOfTheGreatestNumber)
{
  const auto visits = MakeVisits({ 0, 10, 99 });
  const auto density = shapeton::NormalizeVisits(visits);
  EXPECT_EQ(shapeton::GreatestVisits(visits), 100U);
  EXPECT_FLOAT_EQ(density->GetBufferPointer()[0], 0.0F);
  EXPECT_FLOAT_EQ(density->GetBufferPointer()[100], 0.1F);
  EXPECT_FLOAT_EQ(density->GetBufferPointer()[299], 1.0F);
}

TEST(VisitDensity, HistogramCountsEachVoxelOnceAndSpreadsSmallNumbers)
{
  shapeton::HeatHistogram histogram({ 7 });
  shapeton::AddVisitsToRow(MakeVisits({ 0, 1, 3, 20000 }), 0, histogram);
  const std::uint32_t * const row = histogram.GetRow(0);
  EXPECT_EQ(std::accumulate(row, row + shapeton::HeatHistogram::NumberOfBins, 0U), 400U);
  EXPECT_EQ(row[0], 100U);
  // 50 voxels with one visit are spread from 0.5 to 1.5 visits, over several bins.
  const double       greatest = 20001.0;
  const unsigned int first = shapeton::HeatHistogram::BinOf(static_cast<float>(0.5 / greatest));
  const unsigned int end = shapeton::HeatHistogram::BinOf(static_cast<float>(1.4999 / greatest));
  EXPECT_EQ(std::accumulate(row + first, row + end + 1, 0U), 50U);
  EXPECT_LT(*std::max_element(row + first, row + end + 1), 25U);
}

TEST(ShapeAnalysis, TellsVisitsApartAndGivesEachClassTheSameRoom)
{
  // Nine slices of surroundings, two objects.
  const auto visits = MakeVisits({ 20, 20, 20, 20, 20, 20, 20, 20, 20, 200, 2000 });
  const auto shape = shapeton::AnalyzeVisits(visits, 50);
  ASSERT_EQ(shape.classes.size(), 4U); // including the background, which is empty
  EXPECT_EQ(shape.classes[1].voxels, 900U);
  EXPECT_EQ(shape.classes[2].voxels, 100U);
  EXPECT_EQ(shape.classes[3].voxels, 100U);
  EXPECT_EQ(shape.quantity.name, "density");
  EXPECT_EQ(shape.quantity.greatestVisits, 2001U);
  EXPECT_EQ(shape.histogram.GetTimeSteps(), std::vector<std::uint64_t>({ 50 }));
  EXPECT_EQ(shape.labels->GetPixel({ { 0, 0, 9 } }), 2);
  const shapeton::HeatAxis axis(shape.axisHistogram);
  EXPECT_NEAR(axis.PositionOf(shape.classes[1].upperHeat), 1.0 / 3.0, 0.01);
  EXPECT_NEAR(axis.PositionOf(shape.classes[2].upperHeat), 2.0 / 3.0, 0.01);
  // Red: high density; blue: low density.
  const auto most = axis.ColorOf(shape.classes[3].meanHeat);
  const auto least = axis.ColorOf(shape.classes[1].meanHeat);
  EXPECT_GT(most[0], most[2]);
  EXPECT_GT(least[2], least[0]);
}

TEST(ShapeAnalysis, DistinguishesAnObjectFromItsHaloAndFromSpeckle)
{
  constexpr int side = 24;
  const auto    visits = basetest::NewImage<itk::Image<std::uint32_t, 3>>({ { side, side, side } });
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        const bool isInCube = std::min({ x, y, z }) >= 8 && std::max({ x, y, z }) < 16;
        const bool isSpeck = z >= 20 && z < 23 && x % 3 == 1 && y % 3 == 1 && z % 2 == 0;
        visits->SetPixel({ { x, y, z } }, z < 6 ? 3U : isInCube ? 200U : isSpeck ? 1500U : 0U);
      }
    }
  }
  const auto classes = shapeton::AnalyzeVisits(visits, 10).classes;
  ASSERT_EQ(classes.size(), 4U);
  EXPECT_TRUE(classes[1].isSurroundings);
  EXPECT_LT(classes[1].borderShare, 0.5);
  EXPECT_FALSE(classes[2].isSurroundings);
  EXPECT_NEAR(*classes[2].coherence, 0.75, 1e-12) << "a cube of 8 voxels: 6 * 8 * 8 * (7 - 1) of 6 * 8^3 faces";
  EXPECT_EQ(*classes[3].coherence, 0.0);
}

TEST(ShapeAnalysis, OfNoVisitsIsBackground)
{
  const auto shape = shapeton::AnalyzeVisits(MakeVisits({ 0, 0 }), 1);
  ASSERT_EQ(shape.classes.size(), 1U);
  EXPECT_EQ(shape.classes[0].voxels, 200U);
}

TEST(HeatSnapshot, VisitsAreWholeNumbersOfAStatedTimeStep)
{
  auto       values = basetest::NewImage<itk::Image<float, 3>>({ { 2, 1, 1 } });
  const auto set = [&](float a, float b) {
    values->GetBufferPointer()[0] = a;
    values->GetBufferPointer()[1] = b;
  };
  const shapeton::HeatSnapshot stated{ "a.nrrd", 5 };
  const shapeton::HeatSnapshot unknown{ "a.nii", {} };
  set(0.0F, 7.0F);
  const auto visits = shapeton::VisitsOf(values, stated);
  ASSERT_NE(visits, nullptr);
  EXPECT_EQ(visits->GetBufferPointer()[1], 7U);
  EXPECT_EQ(shapeton::VisitsOf(values, unknown), nullptr);
  set(0.5F, 7.0F);
  EXPECT_EQ(shapeton::VisitsOf(values, stated), nullptr);
  set(-1.0F, 7.0F);
  EXPECT_EQ(shapeton::VisitsOf(values, stated), nullptr);
  set(0.0F, 1.0F); // may be heat
  EXPECT_EQ(shapeton::VisitsOf(values, stated), nullptr);
}
} // namespace
