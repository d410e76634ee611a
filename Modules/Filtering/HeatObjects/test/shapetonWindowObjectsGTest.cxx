#include "shapetonExceptions.h"
#include "shapetonTestImages.h"
#include "shapetonVoxelGrid.h"
#include "shapetonWindowObjects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace shapeton;

namespace
{
using HeatImage = itk::Image<float, 3>;

constexpr int windowSide = 40;

struct Box
{
  std::array<int, 3> begin, end;
  float              heat;
};

/** Uniform heat in boxes, the later ones drawn over the earlier ones, and almost none elsewhere. */
HeatImage::Pointer
HeatOf(const std::vector<Box> & boxes)
{
  const auto      image = basetest::NewImage<HeatImage>(HeatImage::SizeType::Filled(windowSide));
  const VoxelGrid grid(windowSide, windowSide, windowSide);
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    const auto place = grid.Voxel(voxel);
    float      heat = 0.001F;
    for (const Box & box : boxes)
    {
      const auto isIn = [&](int axis) { return place[axis] >= box.begin[axis] && place[axis] < box.end[axis]; };
      heat = isIn(0) && isIn(1) && isIn(2) ? box.heat : heat;
    }
    image->GetBufferPointer()[voxel] = heat;
  }
  return image;
}

HeatObjectList
FindAll(const std::vector<HeatImage::Pointer> & heats)
{
  HeatObjectOptions options;
  options.leastProbability = 0.0;
  return FindWindowObjects({ heats.begin(), heats.end() }, options);
}

std::uint64_t
VoxelsOfMask(const HeatObjectList & list, int object)
{
  const auto                  mask = MaskOfObject(list, object);
  const unsigned char * const begin = mask->GetBufferPointer();
  return std::count(begin, begin + mask->GetBufferedRegion().GetNumberOfPixels(), 1);
}

const Box foot{ { { 5, 5, 5 } }, { { 31, 25, 25 } }, 0.5F };
const Box bone{ { { 7, 8, 8 } }, { { 17, 20, 20 } }, 0.3F }; // 14 % of the foot
const Box other{ { { 19, 8, 8 } }, { { 29, 20, 20 } }, 0.4F };
} // namespace

TEST(WindowObjects, ObjectsOfAWindowThatDivideAnObjectAreItsChildren)
{
  const auto list = FindAll({ HeatOf({ foot }), HeatOf({ bone, other }) });
  ASSERT_EQ(list.objects.size(), 3U);
  EXPECT_EQ(list.objects[0].voxels, 26U * 20U * 20U);
  for (const int child : { 1, 2 })
  {
    EXPECT_EQ(list.objects[child].parent, 1);
    EXPECT_EQ(list.objects[child].time, 1);
    EXPECT_EQ(list.objects[child].heatCurve.size(), 1U);
    EXPECT_EQ(VoxelsOfMask(list, child + 1), 10U * 12U * 12U);
  }
  EXPECT_NE(list.labels->GetPixel({ { 10, 10, 10 } }), list.labels->GetPixel({ { 25, 10, 10 } }));
  EXPECT_EQ(list.labels->GetPixel({ { 6, 6, 6 } }), 1);
}

TEST(WindowObjects, ALaterObjectMayContainEarlierOnes)
{
  const auto list = FindAll({ HeatOf({ bone, other }), HeatOf({ foot }) });
  ASSERT_EQ(list.objects.size(), 3U);
  EXPECT_EQ(list.objects[0].time, 1);
  EXPECT_EQ(list.objects[0].parent, 0);
  EXPECT_EQ(list.objects[1].parent, 1);
  EXPECT_EQ(list.objects[2].parent, 1);
  EXPECT_EQ(VoxelsOfMask(list, 1), 26U * 20U * 20U);
  EXPECT_EQ(list.labels->GetPixel({ { 6, 6, 6 } }), 1);
  EXPECT_GT(list.labels->GetPixel({ { 10, 10, 10 } }), 1);
}

TEST(WindowObjects, TheOnlyLargePartIsACoreAndASmallPartIsNot)
{
  EXPECT_EQ(FindAll({ HeatOf({ foot }), HeatOf({ bone }) }).objects.size(), 1U);
  const Box  lesion{ { { 20, 10, 10 } }, { { 26, 16, 16 } }, 0.4F }; // 2 % of the foot
  const auto list = FindAll({ HeatOf({ foot }), HeatOf({ bone, lesion }) });
  ASSERT_EQ(list.objects.size(), 2U);
  EXPECT_EQ(list.objects[1].voxels, 6U * 6U * 6U);
  EXPECT_EQ(list.objects[1].parent, 1);
}

TEST(WindowObjects, AnObjectOfTwoWindowsIsListedOnce)
{
  const Box  larger{ { { 6, 7, 7 } }, { { 18, 21, 21 } }, 0.5F };
  const auto list = FindAll({ HeatOf({ bone, other }), HeatOf({ larger }) });
  ASSERT_EQ(list.objects.size(), 2U);
  EXPECT_EQ(list.objects[0].time, 0);
  EXPECT_EQ(list.objects[1].time, 0);
  EXPECT_EQ(FindAll({ HeatOf({ larger }), HeatOf({ bone }) }).objects[0].voxels, 12U * 14U * 14U);
}

TEST(WindowObjects, AnObjectAcrossABorderIsNotListed)
{
  const Box  across{ { { 12, 8, 8 } }, { { 22, 20, 20 } }, 0.5F }; // half of it in the bone
  const auto list = FindAll({ HeatOf({ bone }), HeatOf({ across }) });
  ASSERT_EQ(list.objects.size(), 1U);
  EXPECT_EQ(list.objects[0].time, 0);
}

TEST(WindowObjects, WrongInputIsRefused)
{
  const auto moved = HeatOf({ bone });
  moved->SetSpacing(itk::Vector<double, 3>(2.0));
  EXPECT_THROW(FindWindowObjects({}), ParameterError);
  EXPECT_THROW(FindAll({ HeatOf({ bone }), moved }), InputError);
}
