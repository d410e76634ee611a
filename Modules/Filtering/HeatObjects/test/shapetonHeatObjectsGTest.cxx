#include "shapetonExceptions.h"
#include "shapetonHeatObjectsImageFilter.h"
#include "shapetonTestImages.h"
#include "shapetonTestThreads.h"
#include "shapetonVoxelGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

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

TEST(HeatObjects, ObjectsAreNestedAndKnowTheirVoxels)
{
  const auto heat = MakeHeat(Scene);
  const auto list = FindHeatObjects(heat, AllObjects());
  ASSERT_GE(list.objects.size(), 2U); // ball and box
  for (int object = 1; object <= static_cast<int>(list.objects.size()); ++object)
  {
    const HeatObject & one = list.objects[object - 1];
    EXPECT_EQ(CountMask(list, object), one.voxels);
    double sum = 0.0;
    for (const VoxelRange & range : list.ranges[object - 1])
    {
      sum += std::accumulate(heat->GetBufferPointer() + range.begin, heat->GetBufferPointer() + range.end, 0.0);
    }
    EXPECT_NEAR(one.meanHeat, sum / static_cast<double>(one.voxels), 1e-9);
    if (one.parent > 0)
    {
      const auto inside = MaskOfObject(list, object);
      const auto around = MaskOfObject(list, one.parent);
      for (std::size_t voxel = 0; voxel < side * side * side; ++voxel)
      {
        ASSERT_LE(inside->GetBufferPointer()[voxel], around->GetBufferPointer()[voxel]);
      }
      const HeatObject & parent = list.objects[one.parent - 1];
      EXPECT_TRUE(one.score > parent.score || 2 * one.voxels <= parent.voxels);
    }
  }
}

TEST(HeatObjects, AClickSelectsThePartThatIsShown)
{
  const auto list = FindHeatObjects(MakeHeat(Scene), AllObjects());
  const auto voxelsAt = [&](int x, int y, int z) {
    const int number = list.labels->GetPixel({ { x, y, z } });
    return number > 0 ? list.objects[ObjectOfClick(list, number) - 1].voxels : 0;
  };
  std::uint64_t ball = 0;
  for (int x = 0; x < side; ++x)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int z = 0; z < side; ++z)
      {
        const double middle = 0.5 * (side - 1);
        ball += x < 26 && Scene(x - middle, y - middle, z - middle) > 0.001F ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(voxelsAt(30, 20, 20), 9U * 12U * 12U); // the box
  EXPECT_EQ(voxelsAt(11, 12, 20), ball);           // with the small core and the small cavity
  EXPECT_EQ(voxelsAt(0, 0, 0), 0U);                // the surroundings: more than mostShare of the volume
}

TEST(HeatObjects, NoObjectHasMoreThanTheGreatestShare)
{
  const auto   heat = MakeHeat(Scene);
  const double volume = side * side * side;
  const auto   largest = static_cast<double>(FindHeatObjects(heat, AllObjects()).objects.front().voxels);
  auto         options = AllObjects();
  for (const double change : { -1.0, 0.0, 1.0 }) // voxels
  {
    options.mostShare = (largest + change) / volume;
    const auto voxels = static_cast<double>(FindHeatObjects(heat, options).objects.front().voxels);
    EXPECT_EQ(voxels == largest, change >= 0.0);
    EXPECT_LE(voxels, largest + change);
  }
}

TEST(HeatObjects, GeometryIsThatOfTheImage)
{
  const auto heat = MakeHeat(Scene);
  heat->SetSpacing(std::array<double, 3>{ { 0.5, 1.0, 2.0 } }.data());
  heat->SetOrigin(std::array<double, 3>{ { 10.0, -20.0, 30.0 } }.data());
  heat->SetDirection(basetest::Rotation(1, 0.6));
  const auto   list = FindHeatObjects(heat, AllObjects());
  const auto & box = list.objects[ObjectOfClick(list, list.labels->GetPixel({ { 30, 20, 20 } })) - 1];
  EXPECT_DOUBLE_EQ(box.volume, static_cast<double>(box.voxels)); // 0.5 x 1 x 2 mm^3 per voxel
  itk::ContinuousIndex<double, 3> middle;
  middle[0] = 0.5 * (26 + 34); // the box: x of 6.5 to 14.5 from the middle
  middle[1] = middle[2] = 0.5 * (side - 1);
  itk::Point<double, 3> expected;
  heat->TransformContinuousIndexToPhysicalPoint(middle, expected);
  EXPECT_LT(box.center.EuclideanDistanceTo(expected), 1e-9);
}

TEST(HeatObjects, MeasuresOfABoxAreKnown)
{
  const auto   list = FindHeatObjects(MakeHeat(Scene), AllObjects());
  const auto & box = list.objects[ObjectOfClick(list, list.labels->GetPixel({ { 30, 20, 20 } })) - 1];
  ASSERT_EQ(box.voxels, 9U * 12U * 12U);
  const double surface = 2.0 / 3.0 * (2 * 12 * 12 + 4 * 9 * 12);
  EXPECT_NEAR(box.compactness, 36.0 * 3.14159265 * 1296.0 * 1296.0 / (surface * surface * surface), 1e-6);
  EXPECT_NEAR(box.contrast, std::log(0.3 / 0.001), 1e-5);
  EXPECT_EQ(box.cut, 0.0);
  EXPECT_GT(box.probability, 0.5);
}

TEST(HeatObjects, AHalfOutsideOfTheVolumeIsCut)
{
  const auto   list = FindHeatObjects(MakeHeat([](double x, double y, double z) {
                                      return std::hypot(x - 20.0, y, z) < 12.0 ? 0.5F : 0.01F; // middle on the border
                                    }),
                                    AllObjects());
  const auto & half = list.objects[ObjectOfClick(list, list.labels->GetPixel({ { 38, 20, 20 } })) - 1];
  EXPECT_NEAR(half.cut, 1.0 / 4.0, 0.03); // of the faces: the disk, its shadow on the other side, and four half disks
}

TEST(HeatObjects, ASlopeIsLessProbableThanAPlateau)
{
  const auto heat = MakeHeat([](double x, double y, double z) {
    const double r = std::sqrt(x * x + y * y + z * z);
    return static_cast<float>(r < 8.0 ? 0.5 : 0.25 * std::exp(-0.3 * (r - 8.0)));
  });
  const auto list = FindHeatObjects(heat, AllObjects());
  const auto best = std::max_element(list.objects.begin(), list.objects.end(), [](const auto & a, const auto & b) {
    return a.probability < b.probability;
  });
  ASSERT_NE(best, list.objects.end());
  EXPECT_FLOAT_EQ(best->meanHeat, 0.5F);
  EXPECT_EQ(best - list.objects.begin() + 1, ObjectOfClick(list, list.labels->GetPixel({ { 20, 20, 20 } })));
}

TEST(HeatObjects, AClickOnNothingSelectsAnOffer)
{
  const auto        heat = MakeHeat(Scene);
  HeatObjectOptions options = AllObjects();
  const auto        all = FindHeatObjects(heat, options);
  options.leastProbability = 0.5 * (all.objects[0].probability + all.objects[1].probability); // between ball and box
  const HeatObjectTree tree(heat, options);
  const auto           objects = tree.List();
  const auto           list = tree.List(true);
  ASSERT_EQ(objects.objects.size(), 1U);
  ASSERT_GE(list.numberOfOffers, 1U);
  EXPECT_EQ(list.objects[0].voxels, objects.objects[0].voxels);
  for (std::size_t voxel = 0; voxel < side * side * side; ++voxel)
  {
    const int  label = list.labels->GetBufferPointer()[voxel];
    const bool isInObject = objects.labels->GetBufferPointer()[voxel] != 0;
    ASSERT_EQ(isInObject, label != 0 && !list.IsOffer(label));
    if (label != 0)
    {
      ASSERT_EQ(list.IsOffer(ObjectOfClick(list, label)), !isInObject);
    }
  }
  for (int offer = 2; offer <= static_cast<int>(list.objects.size()); ++offer)
  {
    EXPECT_LT(list.objects[offer - 1].probability, options.leastProbability);
  }
  for (const auto & place : { itk::Index<3>{ { 30, 20, 20 } }, itk::Index<3>{ { 11, 12, 20 } } }) // box and ball
  {
    const int of = ObjectOfClick(list, list.labels->GetPixel(place));
    EXPECT_EQ(list.objects[of - 1].voxels, all.objects[ObjectOfClick(all, all.labels->GetPixel(place)) - 1].voxels);
  }
}

TEST(HeatObjects, ObjectsStayInTheDomain)
{
  const auto heat = MakeHeat(Scene);
  const auto domain = basetest::NewImage<HeatObjectTree::MaskImage>(HeatImage::SizeType::Filled(side));
  for (std::size_t voxel = 0; voxel < side * side * side; ++voxel)
  {
    domain->GetBufferPointer()[voxel] = VoxelGrid(side, side, side).Voxel(voxel)[1] != 20 ? 1 : 0; // a plane
  }
  const auto   list = HeatObjectTree(heat, AllObjects(), domain).List();
  const auto & below = list.objects[ObjectOfClick(list, list.labels->GetPixel({ { 30, 17, 20 } })) - 1];
  const auto & above = list.objects[ObjectOfClick(list, list.labels->GetPixel({ { 30, 23, 20 } })) - 1];
  EXPECT_EQ(below.voxels, 9U * 6U * 12U); // the plane divides the box
  EXPECT_EQ(above.voxels, 9U * 5U * 12U);
  EXPECT_EQ(list.labels->GetPixel({ { 30, 20, 20 } }), 0);
  heat->SetPixel({ { 0, 20, 0 } }, std::nanf("")); // outside
  EXPECT_EQ(basetest::BytesOf(HeatObjectTree(heat, AllObjects(), domain).List().labels),
            basetest::BytesOf(list.labels));
}

TEST(HeatObjects, AFactorOfHeatDoesNotChangeTheObjects)
{
  const auto list = FindHeatObjects(MakeHeat(Scene), AllObjects());
  const auto visits =
    FindHeatObjects(MakeHeat([](double x, double y, double z) { return 1024.0F * Scene(x, y, z); }), AllObjects());
  ASSERT_EQ(visits.objects.size(), list.objects.size());
  EXPECT_EQ(basetest::BytesOf(visits.labels), basetest::BytesOf(list.labels));
}

TEST(HeatObjects, TheFilterAndThreadsDoNotChangeTheResult)
{
  const auto heat = MakeHeat(Scene);
  const auto list = [&] {
    const basetest::ThreadNumber single(1);
    return FindHeatObjects(heat);
  }();
  const auto filter = HeatObjectsImageFilter::New();
  filter->SetInput(heat);
  std::vector<float> shares;
  filter->AddObserver(itk::ProgressEvent(), [&](const itk::EventObject &) { shares.push_back(filter->GetProgress()); });
  filter->Update();
  EXPECT_EQ(filter->GetProgress(), 1.0F);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LT(*std::upper_bound(shares.begin(), shares.end(), 0.0F), 0.5F); // while the tree is built
  ASSERT_EQ(filter->GetObjects().size(), list.objects.size());
  EXPECT_EQ(basetest::BytesOf(list.labels), basetest::BytesOf(filter->GetOutput()));
  filter->SetLeastVoxels(2000); // the ball is the largest one
  filter->Update();
  ASSERT_EQ(filter->GetObjects().size(), 1U);
  EXPECT_GE(filter->GetObjects()[0].voxels, 2000U);
  filter->SetLeastVoxels(1);
  EXPECT_THROW(filter->Update(), ParameterError);
}

TEST(HeatObjects, WrongInputIsRefused)
{
  HeatObjectOptions options;
  options.leastProbability = 2.0;
  EXPECT_THROW(FindHeatObjects(MakeHeat(Scene), options), ParameterError);
  EXPECT_THROW(FindHeatObjects(MakeHeat([](double, double, double) { return 0.0F; })), InputError);
  EXPECT_THROW(FindHeatObjects(MakeHeat([](double x, double, double) { return x > 0 ? 1.0F : std::nanf(""); })),
               InputError);
  EXPECT_THROW(FindHeatObjects(itk::Image<float, 3>::New().GetPointer()), InputError);
  const auto heat = MakeHeat(Scene);
  EXPECT_THROW(FindHeatObjects(basetest::WithoutPixels<HeatImage>(heat)), InputError);
  EXPECT_THROW(HeatObjectTree(heat, options = {}, basetest::WithoutPixels<HeatObjectTree::MaskImage>(heat)),
               InputError);
  heat->GetBufferPointer()[0] = -1.0F;
  EXPECT_THROW(FindHeatObjects(heat), InputError);
  EXPECT_THROW(MaskOfObject({}, 1), ParameterError);
  EXPECT_THROW(ObjectOfClick({}, 1), ParameterError);
}
