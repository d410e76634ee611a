#include "shapetonTopologyPreservingGrowth.h"

#include "shapetonInterruption.h"
#include "shapetonPaddedVoxels.h"

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace shapeton
{
namespace
{
// Subsets of the 27 voxels, bit x + 3 y + 9 z.
using Bits = std::uint32_t;
constexpr Bits All = 0x7FFFFFF;
constexpr Bits LowX = 0x1249249;  // x = 0
constexpr Bits HighX = LowX << 2; // x = 2
constexpr Bits LowY = 0x01C0E07;  // y = 0
constexpr Bits HighY = LowY << 6; // y = 2
constexpr Bits Faces = 1U << 4 | 1U << 10 | 1U << 12 | 1U << 14 | 1U << 16 | 1U << 22;
constexpr Bits Corners = 1U << 0 | 1U << 2 | 1U << 6 | 1U << 8 | 1U << 18 | 1U << 20 | 1U << 24 | 1U << 26;
constexpr Bits Center = 1U << 13;
constexpr Bits Edges = All & ~Faces & ~Corners & ~Center;

Bits
SpreadX(Bits bits)
{
  return bits | (bits & ~HighX) << 1 | (bits & ~LowX) >> 1;
}

Bits
SpreadY(Bits bits)
{
  return bits | (bits & ~HighY) << 3 | (bits & ~LowY) >> 3;
}

Bits
SpreadZ(Bits bits)
{
  return (bits | bits << 9 | bits >> 9) & All;
}

/** Adds the face neighbors. */
Bits
Spread6(Bits bits)
{
  return SpreadX(bits) | SpreadY(bits) | SpreadZ(bits);
}

/** Adds the face and edge neighbors. */
Bits
Spread18(Bits bits)
{
  const Bits x = SpreadX(bits);
  return SpreadY(x) | SpreadZ(x) | SpreadZ(SpreadY(bits));
}

/** Whether all voxels of `wanted` are in one component of `set`; false if `wanted` is empty. */
template <typename TSpread>
bool
IsOneComponent(Bits wanted, Bits set, const TSpread & spread)
{
  Bits reached = wanted & (~wanted + 1); // the lowest bit
  for (Bits last = 0; reached != last;)
  {
    last = reached;
    reached = spread(reached) & set;
  }
  return wanted != 0 && (wanted & ~reached) == 0;
}

/** Voxels ordered by rank; first in, first out at equal ranks. */
class RankQueue
{
public:
  void
  Push(std::uint16_t rank, std::uint32_t voxel)
  {
    m_Buckets[rank].voxels.push_back(voxel);
    m_Top = std::max<int>(m_Top, rank);
  }

  /** False if the queue is empty. */
  bool
  Pop(std::uint32_t & voxel)
  {
    m_Interruption.Check();
    while (m_Top >= 0 && m_Buckets[m_Top].next == m_Buckets[m_Top].voxels.size())
    {
      m_Buckets[m_Top] = Bucket();
      --m_Top;
    }
    if (m_Top < 0)
    {
      return false;
    }
    voxel = m_Buckets[m_Top].voxels[m_Buckets[m_Top].next++];
    return true;
  }

private:
  struct Bucket
  {
    std::vector<std::uint32_t> voxels;
    std::size_t                next{ 0 };
  };
  std::vector<Bucket> m_Buckets = std::vector<Bucket>(65536);
  int                 m_Top{ -1 };
  RareInterruption    m_Interruption;
};

class Growth
{
public:
  /** Flags of a voxel. */
  static constexpr unsigned char Object = 1;
  static constexpr unsigned char Allowed = 2;
  static constexpr unsigned char Queued = 4;

  Growth(PaddedVoxels & voxels, const GrowthRankImage * ranks)
    : m_Voxels(voxels)
    , m_Flags(voxels.flags)
    , m_Inner(voxels.grid.size[0] - 2, voxels.grid.size[1] - 2, voxels.grid.size[2] - 2)
    , m_Ranks(ranks->GetBufferPointer())
  {
    for (int i = 0; i < 27; ++i)
    {
      m_Offsets[i] = voxels.grid.Offset(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
  }

  std::int64_t
  Run()
  {
    for (std::size_t voxel = 0; voxel < m_Flags.size(); ++voxel) // the padding is never a candidate
    {
      if ((m_Flags[voxel] & Object) != 0)
      {
        this->PushNeighbors(static_cast<std::int64_t>(voxel));
      }
    }
    std::int64_t added = 0;
    for (std::uint32_t voxel = 0; m_Queue.Pop(voxel);)
    {
      m_Flags[voxel] = static_cast<unsigned char>(m_Flags[voxel] & ~Queued);
      if (IsSimplePoint(this->NeighborhoodOf(voxel)))
      {
        m_Flags[voxel] |= Object;
        this->PushNeighbors(voxel);
        ++added;
      }
    }
    return added;
  }

private:
  Bits
  NeighborhoodOf(std::int64_t voxel) const
  {
    Bits bits = 0;
    for (int i = 0; i < 27; ++i)
    {
      bits |= static_cast<Bits>(m_Flags[voxel + m_Offsets[i]] & Object) << i;
    }
    return bits;
  }

  /** Adds candidates around an object voxel, including corner neighbors, whose topological numbers may have changed. */
  void
  PushNeighbors(std::int64_t voxel)
  {
    for (const std::int64_t offset : m_Offsets)
    {
      unsigned char & flags = m_Flags[voxel + offset];
      if ((flags & (Object | Allowed | Queued)) == Allowed)
      {
        flags |= Queued;
        m_Queue.Push(this->RankOf(voxel + offset), static_cast<std::uint32_t>(voxel + offset));
      }
    }
  }

  std::uint16_t
  RankOf(std::int64_t voxel) const
  {
    const auto v = m_Voxels.grid.Voxel(voxel);
    return m_Ranks[m_Inner.Index(v[0] - 1, v[1] - 1, v[2] - 1)];
  }

  PaddedVoxels &               m_Voxels;
  std::vector<unsigned char> & m_Flags;
  VoxelGrid                    m_Inner; ///< without the padding
  const std::uint16_t *        m_Ranks;
  std::array<std::int64_t, 27> m_Offsets;
  RankQueue                    m_Queue;
};
} // namespace

bool
IsSimplePoint(std::uint32_t neighborhood)
{
  // Geodesic neighborhoods: an edge neighbor requires an adjacent face neighbor, a corner neighbor an adjacent edge
  // neighbor.
  const Bits object = neighborhood & All & ~Center;
  const Bits faces = object & Faces;
  const Bits edges = object & Edges & Spread6(faces);
  const Bits corners = object & Corners & Spread6(edges);
  if (!IsOneComponent(faces, faces | edges | corners, Spread6))
  {
    return false;
  }
  const Bits background = ~neighborhood & All & ~Center;
  const Bits near = background & ~Corners;
  return IsOneComponent(near, near | (background & Corners & Spread18(near)), Spread18);
}

std::int64_t
GrowByTopologyPreservingPoints(LumenMaskImage * grown, const LumenMaskImage * limit, const GrowthRankImage * ranks)
{
  const auto size = grown->GetBufferedRegion().GetSize();
  if (size != limit->GetBufferedRegion().GetSize() || size != ranks->GetBufferedRegion().GetSize())
  {
    throw std::invalid_argument("The seed, the limit and the ranks have different sizes");
  }
  PaddedVoxels voxels(grown->GetBufferedRegion());
  if (voxels.flags.size() > std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument("More than 2^32 voxels; crop to the object");
  }
  voxels.SetFlag(grown, Growth::Object);
  voxels.SetFlag(limit, Growth::Allowed);
  const std::int64_t added = Growth(voxels, ranks).Run();
  unsigned char *    values = grown->GetBufferPointer();
  voxels.ForEachVoxel([&](std::int64_t padded, std::int64_t inner) {
    values[inner] = (voxels.flags[padded] & Growth::Object) != 0 ? 1 : 0;
  });
  return added;
}
} // namespace shapeton
