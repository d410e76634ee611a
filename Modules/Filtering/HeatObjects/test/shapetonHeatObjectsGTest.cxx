#include "shapetonExceptions.h"
#include "shapetonHeatObjectsImageFilter.h"
#include "shapetonTestImages.h"
#include "shapetonTestThreads.h"
#include "shapetonVoxelGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace shapeton;

namespace
{
using HeatImage = itk::Image<float, 3>;

constexpr int side = 40;

/** A heat volume computed from the offsets of each voxel from the center of the volume, in voxels. */
HeatImage::Pointer
MakeHeat(const std::function<float(double x, double y, double z)> & heat)
{
  const auto      image = basetest::NewImage<HeatImage>(HeatImage::SizeType::Filled(side));
  const VoxelGrid grid(side, side, side);
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    const auto   place = grid.Voxel(voxel);
    const double middle = 0.5 * (side - 1);
    image->GetBufferPointer()[voxel] = heat(place[0] - middle, place[1] - middle, place[2] - middle);
  }
  return image;
}

/** A ball at 0.5 with a core at 0.8 and a cold cavity, and a box at 0.3; surroundings at 0.001. */
float
Scene(double x, double y, double z)
{
  const auto isInBall = [&](double cx, double radius) {
    return (x - cx) * (x - cx) + y * y + z * z <= radius * radius;
  };
  if (isInBall(-8.0, 9.0))
  {
    return isInBall(-11.0, 3.0) ? 0.8F : isInBall(-4.0, 3.0) ? 0.1F : 0.5F;
  }
  return x > 6.0 && x < 15.0 && std::abs(y) < 6.0 && std::abs(z) < 6.0 ? 0.3F : 0.001F;
}

HeatObjectOptions
AllObjects()
{
  HeatObjectOptions options;
  options.leastProbability = 0.0;
  return options;
}

std::uint64_t
CountMask(const HeatObjectList & list, int object)
{
  const auto mask = MaskOfObject(list, object);
  return std::count(mask->GetBufferPointer(), mask->GetBufferPointer() + side * side * side, 1);
}
} // namespace

TEST(HeatObjects, NestedRegionsStayNested)
{
  const auto heat = MakeHeat(Scene);
  const auto list = FindHeatObjects({ heat }, AllObjects());
  ASSERT_EQ(list.objects.size(), 4U); // ball, box, core, cavity
  const auto & ball = list.objects[0];
  EXPECT_TRUE(ball.isWarm);
  EXPECT_EQ(ball.parent, 0);
  EXPECT_GE(ball.heat, 0.1F); // with the cavity or without, which is the same object
  EXPECT_LE(ball.heat, 0.5F);
  EXPECT_EQ(list.objects[1].parent, 0);
  EXPECT_FLOAT_EQ(list.objects[1].heat, 0.3F);
  EXPECT_EQ(list.objects[2].parent, 1);
  EXPECT_EQ(list.objects[3].parent, 1);
  EXPECT_NE(list.objects[2].isWarm, list.objects[3].isWarm);
  for (int object = 1; object <= 4; ++object)
  {
    EXPECT_EQ(CountMask(list, object), list.objects[object - 1].voxels) << object;
  }
}

TEST(HeatObjects, LabelsAreTheSmallestObjects)
{
  const auto heat = MakeHeat(Scene);
  const auto list = FindHeatObjects({ heat }, AllObjects());
  const auto number = [&](int x, int y, int z) { return list.labels->GetPixel({ { x, y, z } }); };
  EXPECT_EQ(number(5, 20, 20), 1);  // in the ball
  EXPECT_EQ(number(30, 20, 20), 2); // in the box
  EXPECT_TRUE(list.objects[number(9, 20, 20) - 1].isWarm);
  EXPECT_FALSE(list.objects[number(15, 20, 20) - 1].isWarm);
  EXPECT_EQ(number(0, 0, 0), 0);
}

TEST(HeatObjects, GeometryIsThatOfTheImage)
{
  const auto heat = MakeHeat(Scene);
  heat->SetSpacing(std::array<double, 3>{ { 0.5, 1.0, 2.0 } }.data());
  heat->SetOrigin(std::array<double, 3>{ { 10.0, -20.0, 30.0 } }.data());
  heat->SetDirection(basetest::Rotation(1, 0.6));
  const auto   list = FindHeatObjects({ heat }, AllObjects());
  const auto & box = list.objects[1];
  EXPECT_DOUBLE_EQ(box.volume, static_cast<double>(box.voxels)); // 0.5 x 1 x 2 mm^3 per voxel
  itk::ContinuousIndex<double, 3> middle;
  middle[0] = 0.5 * (26 + 34); // the box: x of 6.5 to 14.5 from the middle
  middle[1] = middle[2] = 0.5 * (side - 1);
  itk::Point<double, 3> expected;
  heat->TransformContinuousIndexToPhysicalPoint(middle, expected);
  EXPECT_LT(box.center.EuclideanDistanceTo(expected), 1e-9);
}

TEST(HeatObjects, CompactnessOfABoxIsKnown)
{
  const auto   list = FindHeatObjects({ MakeHeat(Scene) }, AllObjects());
  const auto & box = list.objects[1];
  ASSERT_EQ(box.voxels, 9U * 12U * 12U);
  const double surface = 2.0 / 3.0 * (2 * 12 * 12 + 4 * 9 * 12);
  EXPECT_NEAR(box.compactness, 36.0 * 3.14159265 * 1296.0 * 1296.0 / (surface * surface * surface), 1e-6);
  EXPECT_NEAR(box.contrast, std::log(0.3 / 0.001), 1e-5);
  EXPECT_EQ(box.growth, 0.0);
  EXPECT_EQ(box.cut, 0.0);
}

TEST(HeatObjects, APlateauOfASlopeIsAnObjectAndTheSlopeIsNot)
{
  const auto heat = MakeHeat([](double x, double y, double z) {
    const double r = std::sqrt(x * x + y * y + z * z);
    return static_cast<float>(r < 8.0 ? 0.5 : 0.25 * std::exp(-0.3 * (r - 8.0)));
  });
  const auto list = FindHeatObjects({ heat }, AllObjects());
  ASSERT_GE(list.objects.size(), 1U);
  const auto best = std::max_element(list.objects.begin(), list.objects.end(), [](const auto & a, const auto & b) {
    return a.probability < b.probability;
  });
  EXPECT_FLOAT_EQ(best->heat, 0.5F);
  EXPECT_GT(best->probability, 0.5);
}

TEST(HeatObjects, AnObjectOfTwoTimesCountsOnce)
{
  const auto heat = MakeHeat(Scene);
  const auto later = MakeHeat([](double x, double y, double z) { return 0.5F * Scene(x, y, z); });
  const auto list = FindHeatObjects({ heat, later }, AllObjects());
  ASSERT_EQ(list.objects.size(), 4U);
  for (const auto & object : list.objects)
  {
    ASSERT_EQ(object.heatCurve.size(), 2U);
    EXPECT_NEAR(object.heatCurve[1], 0.5 * object.heatCurve[0], 1e-6);
  }
}

TEST(HeatObjects, TheFilterAndThreadsDoNotChangeTheResult)
{
  const auto heat = MakeHeat(Scene);
  const auto list = [&] {
    const basetest::ThreadNumber single(1);
    return FindHeatObjects({ heat });
  }();
  const auto filter = HeatObjectsImageFilter::New();
  filter->SetInput(heat);
  filter->Update();
  ASSERT_EQ(filter->GetObjects().size(), list.objects.size());
  EXPECT_EQ(basetest::BytesOf(list.labels), basetest::BytesOf(filter->GetOutput()));
  filter->SetLeastVoxels(2000); // only the ball
  filter->Update();
  EXPECT_EQ(filter->GetObjects().size(), 1U);
  filter->SetLeastVoxels(1);
  EXPECT_THROW(filter->Update(), ParameterError);
}

TEST(HeatObjects, WrongInputIsRefused)
{
  const auto heat = MakeHeat(Scene);
  const auto moved = MakeHeat(Scene);
  moved->SetSpacing(itk::Vector<double, 3>(2.0));
  EXPECT_THROW(FindHeatObjects({}), ParameterError);
  HeatObjectOptions options;
  options.leastProbability = 2.0;
  EXPECT_THROW(FindHeatObjects({ heat }, options), ParameterError);
  EXPECT_THROW(FindHeatObjects({ heat, moved }), InputError);
  EXPECT_THROW(FindHeatObjects({ MakeHeat([](double, double, double) { return 0.0F; }) }), InputError);
  EXPECT_THROW(FindHeatObjects({ MakeHeat([](double x, double, double) { return x > 0 ? 1.0F : std::nanf(""); }) }),
               InputError);
  EXPECT_THROW(MaskOfObject({}, 1), ParameterError);
}
