#include "shapetonTopologyPreservingGrowth.h"

#include "shapetonLevelSurface.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonTestImages.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace
{
shapeton::LumenMaskImage::Pointer
NewMask(unsigned int nx, unsigned int ny, unsigned int nz)
{
  return basetest::NewImage<shapeton::LumenMaskImage>({ { nx, ny, nz } });
}

struct SurfaceNumbers
{
  long eulerNumber{ 0 };
  long components{ 0 };
};

/** The surface of a mask padded with background, found by VTK. */
SurfaceNumbers
SurfaceOfMask(const shapeton::LumenMaskImage * mask)
{
  std::array<int, 3> size;
  for (unsigned int a = 0; a < 3; ++a)
  {
    size[a] = static_cast<int>(mask->GetBufferedRegion().GetSize(a)) + 2;
  }
  std::vector<float> values(size[0] * size[1] * size[2], 0.0F);
  basetest::ForVoxels(mask, [&](const itk::Index<3> & i, const auto &) {
    values[((i[2] + 1) * size[1] + i[1] + 1) * size[0] + i[0] + 1] = mask->GetPixel(i) != 0 ? 1.0F : 0.0F;
  });
  const shapeton::SurfaceMesh         surface = shapeton::LevelSurface(values, size, 0.5);
  const shapeton::SurfaceConnectivity connectivity(surface);
  return { surface.NumberOfVertices() - connectivity.NumberOfEdges() + surface.NumberOfFaces(),
           static_cast<long>(connectivity.Components().size()) };
}

void
ExpectTopologyOfSurface(const shapeton::LumenMaskImage * mask)
{
  const SurfaceNumbers         surface = SurfaceOfMask(mask);
  const shapeton::MaskTopology topology = shapeton::TopologyOfMask(mask);
  ASSERT_EQ(surface.eulerNumber, 2 * topology.eulerNumber);
  ASSERT_EQ(surface.components, topology.components + topology.cavities);
}

void
FillAtRandom(shapeton::LumenMaskImage * mask, std::mt19937 & generator, double share)
{
  for (std::size_t i = 0; i < mask->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    mask->GetBufferPointer()[i] = generator() < share * 4294967296.0 ? 1 : 0;
  }
}
} // namespace

TEST(TopologyPreservingGrowth, EachCubeHasTheTopologyOfItsSurface)
{
  for (unsigned int cube = 0; cube < 256; ++cube)
  {
    const auto mask = NewMask(2, 2, 2);
    for (unsigned int i = 0; i < 8; ++i)
    {
      mask->GetBufferPointer()[i] = cube >> i & 1;
    }
    SCOPED_TRACE(cube);
    ExpectTopologyOfSurface(mask);
  }
}

TEST(TopologyPreservingGrowth, RandomMasksHaveTheTopologyOfTheirSurface)
{
  std::mt19937 generator(1);
  for (int i = 0; i < 600; ++i)
  {
    const auto mask = NewMask(3 + i % 4, 3 + i / 4 % 3, 3 + i / 12 % 5);
    FillAtRandom(mask, generator, 0.1 + 0.1 * (i % 9));
    SCOPED_TRACE(i);
    ExpectTopologyOfSurface(mask);
  }
}

TEST(TopologyPreservingGrowth, SimplePointsChangeNoNumberOfTheSurface)
{
  std::mt19937 generator(2);
  int          simple = 0;
  for (int i = 0; i < 1500; ++i)
  {
    const auto mask = NewMask(3, 3, 3);
    FillAtRandom(mask, generator, 0.1 + 0.1 * (i % 9));
    std::uint32_t bits = 0;
    for (int k = 0; k < 27; ++k)
    {
      bits |= static_cast<std::uint32_t>(mask->GetBufferPointer()[k]) << k;
    }
    ASSERT_EQ(shapeton::IsSimplePoint(bits), shapeton::IsSimplePoint(bits ^ 1U << 13)); // the center bit is ignored
    mask->GetBufferPointer()[13] = 0;
    const SurfaceNumbers without = SurfaceOfMask(mask);
    mask->GetBufferPointer()[13] = 1;
    const SurfaceNumbers with = SurfaceOfMask(mask);
    if (shapeton::IsSimplePoint(bits))
    {
      ++simple;
      EXPECT_EQ(without.eulerNumber, with.eulerNumber) << bits;
      EXPECT_EQ(without.components, with.components) << bits;
    }
  }
  EXPECT_GT(simple, 100);
}

TEST(TopologyPreservingGrowth, KnownPointsAreSimpleOrNot)
{
  const auto bit = [](int x, int y, int z) { return 1U << (x + 3 * y + 9 * z); };
  EXPECT_FALSE(shapeton::IsSimplePoint(0));                           // an isolated voxel: a new piece
  EXPECT_FALSE(shapeton::IsSimplePoint(0x7FFFFFF));                   // the last voxel of a cavity
  EXPECT_TRUE(shapeton::IsSimplePoint(bit(0, 1, 1)));                 // a tip
  EXPECT_FALSE(shapeton::IsSimplePoint(bit(0, 0, 1)));                // an edge does not connect the object
  EXPECT_FALSE(shapeton::IsSimplePoint(bit(0, 1, 1) | bit(2, 1, 1))); // a bridge
  EXPECT_TRUE(shapeton::IsSimplePoint(0x7FFFFFF & ~bit(0, 1, 1)));    // the bottom of a pit
  EXPECT_FALSE(shapeton::IsSimplePoint(0x7FFFFFF & ~bit(0, 0, 0)));   // a corner does not connect the background
  EXPECT_TRUE(shapeton::IsSimplePoint(0x7FFFFFF & ~bit(0, 0, 1)));    // an edge connects the background
  EXPECT_FALSE(shapeton::IsSimplePoint(0x7FFFFFF & ~bit(0, 1, 1) & ~bit(2, 1, 1))); // would close a tunnel
}

TEST(TopologyPreservingGrowth, GrowthKeepsTheTopologyOfItsSeed)
{
  std::mt19937 generator(3);
  for (int i = 0; i < 20; ++i)
  {
    const auto limit = NewMask(12, 14, 13);
    FillAtRandom(limit, generator, 0.75);
    const auto seed = NewMask(12, 14, 13);
    seed->GetBufferPointer()[700 + i] = 1;
    const auto ranks = shapeton::NewImageOn<shapeton::GrowthRankImage>(limit, true);
    for (std::size_t k = 0; k < limit->GetBufferedRegion().GetNumberOfPixels(); ++k)
    {
      ranks->GetBufferPointer()[k] = static_cast<std::uint16_t>(generator() % 5);
    }
    const auto added = shapeton::GrowByTopologyPreservingPoints(seed, limit, ranks);
    EXPECT_GT(added, 500);
    const auto topology = shapeton::TopologyOfMask(seed);
    EXPECT_EQ(added + 1, topology.voxels);
    EXPECT_EQ(1, topology.components);
    EXPECT_EQ(0, topology.cavities);
    EXPECT_EQ(0, topology.handles);
    EXPECT_EQ(2, SurfaceOfMask(seed).eulerNumber);
  }
}

TEST(TopologyPreservingGrowth, FillsAConvexLimitAndCutsARingWhereTheRankIsLowest)
{
  const auto limit = NewMask(9, 9, 3);
  const auto seed = NewMask(9, 9, 3);
  const auto ranks = shapeton::NewImageOn<shapeton::GrowthRankImage>(limit, true);
  ranks->FillBuffer(10);
  limit->FillBuffer(1);
  seed->SetPixel({ { 4, 1, 1 } }, 1);
  shapeton::GrowByTopologyPreservingPoints(seed, limit, ranks);
  EXPECT_EQ(9 * 9 * 3, shapeton::TopologyOfMask(seed).voxels);

  for (int z = 0; z < 3; ++z) // a hole that makes the limit a ring
  {
    for (int y = 3; y < 6; ++y)
    {
      for (int x = 3; x < 6; ++x)
      {
        limit->SetPixel({ { x, y, z } }, 0);
      }
      ranks->SetPixel({ { y, 7, z } }, 10); // equal ranks
    }
    for (int x = 0; x < 3; ++x)
    {
      ranks->SetPixel({ { x, 4, z } }, 1);
    }
  }
  EXPECT_EQ(1, shapeton::TopologyOfMask(limit).handles);
  seed->FillBuffer(0);
  seed->SetPixel({ { 4, 1, 1 } }, 1);
  shapeton::GrowByTopologyPreservingPoints(seed, limit, ranks);
  EXPECT_EQ(9 * 9 * 3 - 27 - 9, shapeton::TopologyOfMask(seed).voxels);
  for (int x = 0; x < 3; ++x)
  {
    EXPECT_EQ(0, seed->GetPixel({ { x, 4, 1 } }));
  }
}

TEST(TopologyPreservingGrowth, RefusesOtherSizes)
{
  auto ranks = basetest::NewImage<shapeton::GrowthRankImage>({ { 3, 3, 3 } });
  EXPECT_THROW(shapeton::GrowByTopologyPreservingPoints(NewMask(3, 3, 3), NewMask(3, 3, 4), ranks),
               std::invalid_argument);
}
