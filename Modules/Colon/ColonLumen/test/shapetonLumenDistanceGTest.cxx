#include "shapetonLumenDistance.h"

#include "shapetonPhilox.h"
#include "shapetonTubeMask.h"

#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <array>
#include <limits>

namespace
{
using shapeton::LumenMask;

/** Random mask; each voxel is lumen with probability `share`. */
LumenMask::Pointer
RandomMask(const itk::Size<3> & size, const std::array<double, 3> & spacing, double share)
{
  const auto        mask = basetest::NewImage<LumenMask>(size, spacing);
  const std::size_t voxels = mask->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const auto word = shapeton::Philox4x32(7, { static_cast<std::uint32_t>(i), 0, 0, 0 }).a;
    mask->GetBufferPointer()[i] = word < share * 4294967296.0 ? 1 : 0;
  }
  return mask;
}

double
BruteForce(const LumenMask * mask, const itk::Index<3> & index)
{
  if (mask->GetPixel(index) == 0)
  {
    return 0.0;
  }
  const auto spacing = mask->GetSpacing();
  double     least = std::numeric_limits<double>::infinity();
  basetest::ForVoxels(mask, [&](const itk::Index<3> & i, const auto &) {
    if (mask->GetPixel(i) == 0)
    {
      double squared = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double step = spacing[a] * (i[a] - index[a]);
        squared += step * step;
      }
      least = std::min(least, squared);
    }
  });
  return std::sqrt(least) - 0.25 * std::min({ spacing[0], spacing[1], spacing[2] });
}

TEST(LumenDistance, IsThatOfBruteForceOnUnequalSpacing)
{
  for (const double share : { 0.5, 0.9, 0.995 })
  {
    const auto mask = RandomMask({ { 19, 13, 11 } }, { 0.7, 1.1, 2.3 }, share);
    const auto distance = shapeton::LumenDistance(mask, mask->GetBufferedRegion());
    basetest::ForVoxels(mask, [&](const itk::Index<3> & i, const auto &) {
      ASSERT_NEAR(distance->GetPixel(i), BruteForce(mask, i), 1e-5) << i << " of share " << share;
    });
  }
}

TEST(LumenDistance, OfATubeIsItsRadiusOnTheAxisOfAnObliqueImage)
{
  const shapeton::TubePoints axis = shapeton::CurveThrough({ { 0, 0, 0 }, { 20, 10, 30 }, { 40, 20, 60 } });
  shapeton::TubeMask         mask(axis, 20.0, { 0.7, 0.8, 1.2 }, shapeton::ObliqueFrame());
  mask.Paint(axis, 12.0);
  const auto distance = shapeton::LumenDistance(mask.Get(), shapeton::LumenRegion(mask.Get()));
  for (std::size_t k = axis.size() / 3; k < 2 * axis.size() / 3; ++k)
  {
    itk::Point<double, 3> point;
    itk::Index<3>         index;
    std::copy(axis[k].data(), axis[k].data() + 3, point.Begin());
    ASSERT_TRUE(distance->TransformPhysicalPointToIndex(point, index));
    EXPECT_NEAR(distance->GetPixel(index), 12.0, 0.9);
  }
}

TEST(LumenDistance, CountsWhatLiesBeyondTheImageAsLumen)
{
  // A slab, 5 voxels thick, that extends beyond all other borders.
  const auto mask = basetest::NewImage<LumenMask>({ { 9, 7, 6 } }, { 1.0, 2.0, 3.0 });
  for (std::size_t i = 0; i < mask->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    mask->GetBufferPointer()[i] = i % 9 >= 2 && i % 9 < 7;
  }
  const auto distance = shapeton::LumenDistance(mask, mask->GetBufferedRegion());
  for (std::size_t i = 0; i < mask->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    const float wanted[] = { 0, 0, 0.75F, 1.75F, 2.75F, 1.75F, 0.75F, 0, 0 };
    EXPECT_EQ(distance->GetBufferPointer()[i], wanted[i % 9]);
  }
}

TEST(LumenDistance, HasTheSameBytesForAnyNumberOfThreads)
{
  const auto mask = RandomMask({ { 40, 30, 20 } }, { 0.7, 0.8, 1.0 }, 0.97);
  basetest::ExpectSameWithAnyThreads(
    [&] { return basetest::BytesOf(shapeton::LumenDistance(mask, mask->GetBufferedRegion())); });
}

TEST(LumenDistance, RefusesMasksWithoutLumenOrWall)
{
  const auto empty = basetest::NewImage<LumenMask>({ { 4, 4, 4 } }, { 1, 1, 1 });
  EXPECT_THROW(shapeton::LumenRegion(empty), shapeton::InputError);
  empty->FillBuffer(1);
  EXPECT_THROW(shapeton::LumenDistance(empty, empty->GetBufferedRegion()), shapeton::InputError);
}

TEST(LumenRegion, IsTheBoxOfTheLumenWithinTheImage)
{
  const auto mask = basetest::NewImage<LumenMask>({ { 20, 20, 20 } }, { 1, 1, 1 });
  mask->SetPixel({ { 3, 9, 0 } }, 200);
  mask->SetPixel({ { 5, 7, 2 } }, 1);
  const auto region = shapeton::LumenRegion(mask, 2);
  EXPECT_EQ(region.GetIndex(), (itk::Index<3>{ { 1, 5, 0 } }));
  EXPECT_EQ(region.GetSize(), (itk::Size<3>{ { 7, 7, 5 } }));
}

TEST(LumenComponents, HangTogetherByFacesAlone)
{
  const auto mask = basetest::NewImage<LumenMask>({ { 8, 8, 8 } }, { 1.0, 2.0, 5.0 });
  // A ring around a column, and a voxel connected to it only by an edge.
  for (long x = 1; x < 6; ++x)
  {
    for (long y = 1; y < 6; ++y)
    {
      mask->SetPixel({ { x, y, 3 } }, x == 3 && y == 3 ? 0 : 1);
    }
  }
  mask->SetPixel({ { 6, 6, 3 } }, 1);
  const auto found = shapeton::FindLumenComponents(mask, mask->GetBufferedRegion());
  ASSERT_EQ(found.components.size(), 2u);
  EXPECT_EQ(found.components[0].voxels, 24);
  EXPECT_NEAR(found.components[0].volume, 0.24, 1e-12);
  EXPECT_EQ(found.components[0].first, (itk::Index<3>{ { 1, 1, 3 } }));
  EXPECT_EQ(found.components[0].last, (itk::Index<3>{ { 5, 5, 3 } }));
  EXPECT_EQ(found.labels->GetPixel({ { 6, 6, 3 } }), 2);
  EXPECT_EQ(found.labels->GetPixel({ { 3, 3, 3 } }), 0);
}

TEST(LumenComponents, LabelNeighborsAlikeAndCountAllVoxels)
{
  const auto   mask = RandomMask({ { 17, 15, 13 } }, { 1, 1, 1 }, 0.35);
  const auto   found = shapeton::FindLumenComponents(mask, mask->GetBufferedRegion());
  std::int64_t counted = 0;
  basetest::ForVoxels(mask, [&](const itk::Index<3> & i, const auto &) {
    ASSERT_EQ(found.labels->GetPixel(i) != 0, mask->GetPixel(i) != 0);
    counted += mask->GetPixel(i);
    for (int a = 0; a < 3; ++a)
    {
      itk::Index<3> next = i;
      if (++next[a] < static_cast<long>(mask->GetBufferedRegion().GetSize(a)) && mask->GetPixel(i) &&
          mask->GetPixel(next))
      {
        ASSERT_EQ(found.labels->GetPixel(i), found.labels->GetPixel(next));
      }
    }
  });
  for (std::size_t c = 0; c < found.components.size(); ++c)
  {
    counted -= found.components[c].voxels;
    EXPECT_TRUE(c == 0 || found.components[c].voxels <= found.components[c - 1].voxels);
  }
  EXPECT_EQ(counted, 0);
  EXPECT_GT(found.components.size(), 10u);
}
} // namespace
