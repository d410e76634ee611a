#include "shapetonKernelSets.h"
#include "shapetonParticleKernelsTestTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shapeton;
using namespace shapeton::test;
using namespace shapeton::ParticleKernels;

namespace
{
/** The position after reflection at 0 and `size`, always less than `size`. */
double
Folded(double place, double size)
{
  const double distance = std::abs(place);
  const double rest = distance - std::floor(distance / (2.0 * size)) * 2.0 * size;
  return std::min(std::min(rest, 2.0 * size - rest),
                  static_cast<double>(std::nextafter(static_cast<float>(size), 0.0F)));
}

struct MoveCase
{
  std::array<std::int32_t, 3> size;
  std::array<float, 3>        step;
};

/** Volumes with a width of one voxel, and steps much longer than the volume. */
const MoveCase moveCases[] = {
  { { 40, 30, 20 }, { 3.7F, 2.9F, 1.1F } },      { { 1, 1, 1 }, { 1.0F, 1.0F, 1.0F } },
  { { 1, 7, 300 }, { 300.0F, 300.0F, 300.0F } }, { { 2000, 1, 1 }, { 2000.0F, 700.0F, 1.0F } },
  { { 3, 5, 1 }, { 4000.0F, 0.01F, 90000.0F } }, { { 127, 129, 64 }, { 500.0F, 129.0F, 64.0F } }
};

/** Random positions and directions. */
Crowd
MakeCrowd(const MoveCase & moveCase, std::size_t number)
{
  Crowd        crowd(number, moveCase.size);
  std::mt19937 engine(17);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    crowd.surroundings.step[axis] = moveCase.step[axis];
    for (std::size_t i = 0; i < number; ++i)
    {
      const auto size = static_cast<float>(moveCase.size[axis]);
      const auto place = size * static_cast<float>(engine() >> 8) / 16777216.0F;
      crowd.places[axis][i] = std::min(place, std::nextafter(size, 0.0F));
      crowd.directions[axis][i] = static_cast<float>(engine() >> 8) / 8388608.0F - 1.0F;
    }
  }
  return crowd;
}
} // namespace

TEST(ParticleMove, EqualsFoldingInDoublePrecision)
{
  for (const MoveCase & moveCase : moveCases)
  {
    const Crowd before = MakeCrowd(moveCase, 20000);
    Crowd       after = before;
    BestKernels<Set>().move(after.GetSurroundings(), after.GetShapetons(), after.GetDirections());
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (std::size_t i = 0; i < before.number; ++i)
      {
        // The sum is rounded; folding it is exact.
        const volatile float way = moveCase.step[axis] * before.directions[axis][i];
        const float          sum = before.places[axis][i] + way;
        EXPECT_EQ(after.places[axis][i], Folded(sum, moveCase.size[axis]));
      }
    }
  }
}

TEST(ParticleMove, TheVoxelHoldsThePlaceAndLiesInside)
{
  for (const MoveCase & moveCase : moveCases)
  {
    Crowd crowd = MakeCrowd(moveCase, 20000);
    for (int step = 0; step < 5; ++step)
    {
      BestKernels<Set>().move(crowd.GetSurroundings(), crowd.GetShapetons(), crowd.GetDirections());
      for (std::size_t i = 0; i < crowd.number; ++i)
      {
        std::size_t voxel = 0;
        for (int axis = 2; axis >= 0; --axis)
        {
          const auto index = static_cast<std::int32_t>(std::floor(crowd.places[axis][i]));
          ASSERT_GE(index, 0);
          ASSERT_LT(index, moveCase.size[axis]);
          voxel = voxel * moveCase.size[axis] + index;
        }
        ASSERT_EQ(crowd.voxels[i], voxel);
      }
    }
  }
}

TEST(ParticleMove, TheUpperBorderBelongsToTheLastVoxel)
{
  for (std::int32_t size = 1; size <= 5000; ++size)
  {
    Crowd crowd(16, { size, 1, 1 });
    crowd.surroundings.step[0] = 1.0F;
    const auto  upper = static_cast<float>(size);
    const float directions[4] = { 0.0F, 1.0F, 0.5F, std::nextafter(1.0F, 0.0F) };
    const float places[4] = { std::nextafter(upper, 0.0F), upper - 1.0F, upper - 0.5F, upper - 1.0F };
    for (unsigned int i = 0; i < 4; ++i)
    {
      crowd.directions[0][i] = directions[i];
      crowd.places[0][i] = places[i];
    }
    BestKernels<Set>().move(crowd.GetSurroundings(), crowd.GetShapetons(), crowd.GetDirections());
    for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_LT(crowd.places[0][i], upper);
      EXPECT_EQ(crowd.voxels[i], static_cast<std::uint32_t>(size - 1));
    }
  }
}

TEST(ParticleMove, AllInstructionSetsGiveTheSamePlaces)
{
  const auto sets = KernelsOfThisCpu<Set>();
  if (sets.size() == 1)
  {
    GTEST_SKIP() << "this CPU runs the baseline alone";
  }
  for (const MoveCase & moveCase : moveCases)
  {
    Crowd reference = MakeCrowd(moveCase, 5003);
    sets[0]->move(reference.GetSurroundings(), reference.GetShapetons(), reference.GetDirections());
    for (const Set * const set : sets)
    {
      Crowd crowd = MakeCrowd(moveCase, 5003);
      set->move(crowd.GetSurroundings(), crowd.GetShapetons(), crowd.GetDirections());
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        EXPECT_TRUE(SameBytes(crowd.places[axis], reference.places[axis])) << set->name;
      }
      EXPECT_TRUE(SameBytes(crowd.voxels, reference.voxels)) << set->name;
    }
  }
}
