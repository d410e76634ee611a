#include "shapetonDiffusionTestVolumes.h"
#include "shapetonParticleKernels.h"
#include "shapetonParticleRecords.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace shapeton;
using namespace shapeton::test;
using namespace shapeton::ParticleKernels;

namespace
{
constexpr std::array<double, 3> spacing = { { 1.0, 1.25, 2.0 } };

/** The weight of the edge between two voxels, directly from (2.5); 1 if the neighbor is outside. */
double
WeightOf(const Volume &                volume,
         const std::array<double, 2> & window,
         double                        p,
         std::array<std::ptrdiff_t, 3> place,
         unsigned int                  edge)
{
  const auto at = [&](const std::array<std::ptrdiff_t, 3> & v) {
    const double value = volume.values[(v[2] * volume.size[1] + v[1]) * volume.size[0] + v[0]];
    return std::clamp((value - window[0]) / (window[1] - window[0]), 0.0, 1.0);
  };
  const unsigned int axis = edge / 2;
  const double       own = at(place);
  place[axis] += edge % 2 ? 1 : -1;
  if (place[axis] < 0 || place[axis] >= static_cast<std::ptrdiff_t>(volume.size[axis]))
  {
    return 1.0;
  }
  const double smallest = *std::min_element(volume.spacing.begin(), volume.spacing.end());
  const double resolution = volume.spacing[axis] / smallest;
  return std::clamp(1.0 - p * std::abs(own - at(place)) / resolution, 0.0, 1.0);
}

ParticleRecords
RecordsOf(const Volume & volume, double p, const unsigned char * mask = nullptr)
{
  return ParticleRecords(EdgeVolume(volume, OptionsWith(p)), mask, [] {});
}

/** Calls `body(voxel, place)` for every voxel of slices. */
template <typename TBody>
void
ForVoxels(const Volume & volume, std::size_t firstSlice, std::size_t endSlice, const TBody & body)
{
  for (std::size_t voxel = firstSlice * volume.size[0] * volume.size[1];
       voxel < endSlice * volume.size[0] * volume.size[1];
       ++voxel)
  {
    body(voxel,
         std::array<std::ptrdiff_t, 3>{ static_cast<std::ptrdiff_t>(voxel % volume.size[0]),
                                        static_cast<std::ptrdiff_t>(voxel / volume.size[0] % volume.size[1]),
                                        static_cast<std::ptrdiff_t>(voxel / volume.size[0] / volume.size[1]) });
  }
}

void
ExpectWeights(const Volume & volume, double p, std::size_t first, std::size_t end)
{
  const ParticleRecords records = RecordsOf(volume, p);
  const auto            window = volume.Window();
  double                largest = 0.0;
  std::size_t           wrongZeros = 0;
  ForVoxels(volume, first, end, [&](std::size_t voxel, const std::array<std::ptrdiff_t, 3> & place) {
    for (unsigned int edge = 0; edge < 6; ++edge)
    {
      const double        weight = WeightOf(volume, window, p, place, edge);
      const std::uint16_t stored = records.GetRecord(voxel)[edge];
      largest = std::max(largest, std::abs(stored / 65535.0 - weight));
      wrongZeros += stored == 0 ? weight > 1e-6 : weight < 1e-9;
    }
  });
  EXPECT_LT(largest, 1.0 / 65535.0);
  EXPECT_EQ(wrongZeros, 0U);
}
} // namespace

TEST(ParticleRecords, HoldTheWeightsOfTheVolume)
{
  const Volume volume = MakeScene({ 21, 18, 15 }, 0.3, spacing);
  ExpectWeights(volume, 3.0, 0, volume.size[2]);
}

TEST(ParticleRecords, HoldTheWeightsWhereTheVolumeIsCutIntoSlabs)
{
  // 2^20 voxels are 16 slices: borders of slabs at 16 and 32.
  const Volume volume = MakeScene({ 256, 256, 35 }, 0.3, spacing);
  for (const std::size_t border : { 16, 32 })
  {
    ExpectWeights(volume, 3.0, border - 2, border + 2);
  }
}

TEST(ParticleRecords, ASliceLargerThanASlabIsNoSpecialCase)
{
  const Volume volume = MakeScene({ 1100, 1000, 2 }, 0.3, spacing);
  ExpectWeights(volume, 3.0, 0, 2);
}

TEST(ParticleRecords, AnEdgeHasOneWeightFromBothSides)
{
  const Volume          volume = MakeScene({ 13, 12, 11 }, 0.4, spacing);
  const ParticleRecords records = RecordsOf(volume, 3.0);
  const std::size_t     strides[3] = { 1, volume.size[0], volume.size[0] * volume.size[1] };
  ForVoxels(volume, 0, volume.size[2], [&](std::size_t voxel, const std::array<std::ptrdiff_t, 3> & place) {
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      if (place[axis] + 1 < static_cast<std::ptrdiff_t>(volume.size[axis]))
      {
        EXPECT_EQ(records.GetRecord(voxel)[2 * axis + 1], records.GetRecord(voxel + strides[axis])[2 * axis]);
      }
    }
  });
}

TEST(ParticleRecords, MarksAndInitialHeatFollowTheWeights)
{
  const Volume               volume = MakeScene({ 14, 13, 12 }, 1.0, spacing);
  std::vector<unsigned char> mask(volume.values.size());
  for (std::size_t voxel = 0; voxel < mask.size(); ++voxel)
  {
    mask[voxel] = voxel % 3 ? 255 : 0;
  }
  const double  lower = volume.Window()[0];
  std::size_t   traps = 0;
  std::uint32_t greatest = 0;
  for (const bool masked : { false, true })
  {
    const unsigned char * const given = masked ? mask.data() : nullptr;
    const ParticleRecords       records = RecordsOf(volume, 20.0, given);
    const auto                  sumOf = [&](std::size_t voxel) {
      return std::accumulate(records.GetRecord(voxel), records.GetRecord(voxel) + MarksOfRecord, 0U);
    };
    std::uint64_t objects = 0;
    for (std::size_t voxel = 0; voxel < mask.size(); ++voxel)
    {
      greatest = std::max(greatest, sumOf(voxel));
    }
    for (std::size_t voxel = 0; voxel < mask.size(); ++voxel)
    {
      const std::uint16_t marks = records.GetRecord(voxel)[MarksOfRecord];
      const bool          object = given ? given[voxel] != 0 : volume.values[voxel] > lower;
      EXPECT_EQ((marks & ObjectMark) != 0, object);
      EXPECT_EQ((marks & TrapMark) != 0, sumOf(voxel) == 0);
      EXPECT_EQ(records.GetInitialHeat(voxel), greatest - sumOf(voxel));
      objects += object;
      traps += sumOf(voxel) == 0;
    }
    EXPECT_EQ(records.GetNumberOfObjectVoxels(), objects);
  }
  EXPECT_GT(traps, 10U);
}

TEST(ParticleRecords, InAConstantVolumeAllVoxelsCount)
{
  const Volume          volume({ 4, 5, 6 }, 7.0F);
  const ParticleRecords records = RecordsOf(volume, 7.0);
  EXPECT_EQ(records.GetNumberOfObjectVoxels(), 120U);
  EXPECT_EQ(records.GetRecord(119)[MarksOfRecord], ObjectMark);
}

TEST(ParticleRecords, TheChecksumSeesWeightsAndMask)
{
  Volume                     volume = MakeScene({ 9, 8, 7 }, 0.3, spacing);
  std::vector<unsigned char> mask(volume.values.size(), 1);
  const auto checksumOf = [&](const unsigned char * given) { return RecordsOf(volume, 3.0, given).GetChecksum(); };
  const std::uint64_t own = checksumOf(mask.data());
  EXPECT_EQ(checksumOf(mask.data()), own);
  mask[77] = 0;
  EXPECT_NE(checksumOf(mask.data()), own);
  mask[77] = 1;
  volume.At(4, 4, 4) += 0.001F;
  EXPECT_NE(checksumOf(mask.data()), own);
}
