#include "shapetonComponentTree.h"

#include "shapetonDisjointSets.h"
#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>

namespace shapeton
{
namespace
{
using Index = ComponentTree::Index;

/** Consecutive voxels that one thread processes. */
struct Slab
{
  std::size_t begin, end;
};

/** Slabs of whole slices. Their number does not affect results. */
std::vector<Slab>
SlabsOf(const VoxelGrid & grid)
{
  constexpr int     mostSlabs = 64; // enough for the cores of a workstation; boundaries between slabs cost time
  const int         slices = grid.size[2];
  const int         number = std::min(slices, mostSlabs);
  std::vector<Slab> slabs;
  for (int s = 0; s < number; ++s)
  {
    slabs.push_back({ grid.stride[2] * (static_cast<std::size_t>(slices) * s / number),
                      grid.stride[2] * (static_cast<std::size_t>(slices) * (s + 1) / number) });
  }
  return slabs;
}

/** Unsigned integers that sort like the numbers; both zeros are equal. */
std::uint32_t
OrderedBits(float value)
{
  value += 0.0F; // -0 becomes 0
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  constexpr std::uint32_t sign = 0x80000000U;
  return bits & sign ? ~bits : bits | sign;
}

/** Voxel indices from the greatest to the smallest value; equal values by index. */
std::vector<Index>
SortVoxels(const float * values, const std::vector<Slab> & slabs)
{
  constexpr int                           shift = 16; // buckets by sign, exponent and 7 bits of the mantissa
  constexpr std::size_t                   numberOfBuckets = std::size_t{ 1 } << shift;
  std::vector<std::vector<std::uint32_t>> positions(slabs.size(), std::vector<std::uint32_t>(numberOfBuckets, 0));
  const auto bucketOf = [values](std::size_t v) { return ~OrderedBits(values[v]) >> shift; };
  ParallelFor(slabs.size(), [&](std::size_t s) {
    for (std::size_t v = slabs[s].begin; v < slabs[s].end; ++v)
    {
      if (std::isnan(values[v]))
      {
        throw InputError("voxel " + std::to_string(v) + " is not a number");
      }
      ++positions[s][bucketOf(v)];
    }
  });
  std::vector<std::size_t> firstOfBucket(numberOfBuckets + 1, 0);
  std::size_t              before = 0;
  for (std::size_t bucket = 0; bucket < numberOfBuckets; ++bucket)
  {
    firstOfBucket[bucket] = before;
    for (auto & ofSlab : positions)
    {
      const auto count = ofSlab[bucket];
      ofSlab[bucket] = static_cast<std::uint32_t>(before);
      before += count;
    }
  }
  firstOfBucket[numberOfBuckets] = before;
  std::vector<std::uint64_t> items(before); // inverted bits above, index below
  ParallelFor(slabs.size(), [&](std::size_t s) {
    for (std::size_t v = slabs[s].begin; v < slabs[s].end; ++v)
    {
      const std::uint32_t bits = ~OrderedBits(values[v]);
      items[positions[s][bits >> shift]++] = std::uint64_t{ bits } << 32U | v;
    }
  });
  std::vector<Index> sorted(before);
  ParallelFor(numberOfBuckets, [&](std::size_t bucket) {
    const auto begin = items.begin() + static_cast<std::ptrdiff_t>(firstOfBucket[bucket]);
    const auto end = items.begin() + static_cast<std::ptrdiff_t>(firstOfBucket[bucket + 1]);
    if (!std::is_sorted(begin, end)) // equal values are
    {
      std::sort(begin, end);
    }
    for (std::size_t i = firstOfBucket[bucket]; i < firstOfBucket[bucket + 1]; ++i)
    {
      sorted[i] = static_cast<Index>(items[i]);
    }
  });
  return sorted;
}
} // namespace

/** Builds one tree from the voxels in the order in which they join, and their ranks: larger ranks join first. */
class ComponentTreeBuilder
{
public:
  ComponentTreeBuilder(const VoxelGrid &          grid,
                       const std::vector<Slab> &  slabs,
                       const std::vector<Index> & rank,
                       const std::vector<Index> & descending)
    : m_Grid(grid), m_Slabs(slabs), m_Rank(rank), m_Descending(descending), m_Joins(slabs.size())
  {
    for (std::size_t d = 0; d < directions; ++d)
    {
      const auto stride = static_cast<std::ptrdiff_t>(grid.stride[d / 2]);
      m_Offsets[d] = d % 2 == 0 ? -stride : stride;
    }
  }

  ComponentTree
  Build()
  {
    this->Climb();
    this->FollowClimbs();
    this->NumberPeaks();
    this->JoinRegions();
    this->FindJumps();
    this->AssignArcs();
    return this->OrderRegions();
  }

private:
  static constexpr std::size_t directions = 6; ///< -x, +x, -y, +y, -z, +z
  using Neighbors = unsigned int;              ///< a bit per direction

  /** The face neighbors inside the volume that join before the voxel. */
  Neighbors
  HigherNeighbors(std::size_t voxel, Neighbors inside) const
  {
    Neighbors higher = 0;
    for (std::size_t d = 0; d < directions; ++d)
    {
      if ((inside >> d & 1U) != 0 && m_Rank[voxel + m_Offsets[d]] > m_Rank[voxel])
      {
        higher |= 1U << d;
      }
    }
    return higher;
  }

  /** One direction for each group of higher neighbors; a group is connected above the voxel through voxels of the 3 x 3
   * x 3 neighborhood that share an edge with the voxel. */
  Neighbors
  GroupsAbove(std::size_t voxel, Neighbors higher) const
  {
    std::array<std::size_t, directions> group;
    for (std::size_t d = 0; d < directions; ++d)
    {
      group[d] = d;
    }
    for (std::size_t a = 0; a < directions; ++a)
    {
      for (std::size_t b = 2 * (a / 2 + 1); b < directions; ++b) // directions of later axes
      {
        const bool areHigher = (higher >> a & 1U) != 0 && (higher >> b & 1U) != 0;
        if (areHigher && group[a] != group[b] && m_Rank[voxel + m_Offsets[a] + m_Offsets[b]] > m_Rank[voxel])
        {
          const auto [kept, merged] = std::minmax(group[a], group[b]);
          std::replace(group.begin(), group.end(), std::size_t{ merged }, std::size_t{ kept });
        }
      }
    }
    Neighbors groups = 0;
    for (std::size_t d = 0; d < directions; ++d)
    {
      groups |= (higher >> d & 1U) != 0 && group[d] == d ? 1U << d : 0U;
    }
    return groups;
  }

  static bool
  IsSingle(Neighbors neighbors)
  {
    return (neighbors & (neighbors - 1)) == 0;
  }

  /** Calls `body(voxel, neighbors inside the volume)` for the voxels of a slab. */
  template <typename TBody>
  void
  ForEachVoxel(const Slab & slab, const TBody & body) const
  {
    const auto & size = m_Grid.size;
    for (std::size_t row = slab.begin; row < slab.end; row += m_Grid.stride[1])
    {
      const auto [i0, j, k] = m_Grid.Voxel(row);
      const auto inRow = Neighbors{ (j > 0 ? 4U : 0U) | (j + 1 < size[1] ? 8U : 0U) | (k > 0 ? 16U : 0U) |
                                    (k + 1 < size[2] ? 32U : 0U) };
      for (int i = i0; i < size[0]; ++i)
      {
        body(row + i, inRow | (i > 0 ? 1U : 0U) | (i + 1 < size[0] ? 2U : 0U));
      }
    }
  }

  /** Sets m_Up to the highest neighbor, or to the voxel itself at a peak, and collects the voxels that may join
   * regions. */
  void
  Climb()
  {
    m_Up.resize(m_Rank.size());
    ParallelFor(m_Slabs.size(), [this](std::size_t s) {
      this->ForEachVoxel(m_Slabs[s], [&](std::size_t voxel, Neighbors inside) {
        const Neighbors higher = this->HigherNeighbors(voxel, inside);
        std::size_t     up = voxel;
        for (std::size_t d = 0; d < directions; ++d)
        {
          if ((higher >> d & 1U) != 0 && m_Rank[voxel + m_Offsets[d]] > m_Rank[up])
          {
            up = voxel + m_Offsets[d];
          }
        }
        m_Up[voxel] = static_cast<Index>(up);
        if (!IsSingle(higher) && !IsSingle(this->GroupsAbove(voxel, higher)))
        {
          m_Joins[s].push_back(m_Rank[voxel]);
        }
      });
    });
  }

  /** Sets m_Up to the peak reached by climbing: within each slab, then between slabs. */
  void
  FollowClimbs()
  {
    const auto holds = [](const Slab & slab, std::size_t voxel) { return slab.begin <= voxel && voxel < slab.end; };
    ParallelFor(m_Slabs.size(), [&](std::size_t s) {
      for (std::size_t voxel = m_Slabs[s].begin; voxel < m_Slabs[s].end; ++voxel)
      {
        this->Follow(voxel, [&](Index up) { return !holds(m_Slabs[s], up); });
      }
    });
    const std::size_t slice = m_Grid.stride[2];
    for (const Slab & slab : m_Slabs) // a climb enters a slab through its first or its last slice
    {
      for (std::size_t i = 0; i < slice; ++i)
      {
        this->Follow(slab.begin + i, [](Index) { return false; });
        this->Follow(slab.end - slice + i, [](Index) { return false; });
      }
    }
    ParallelFor(m_Slabs.size(), [&](std::size_t s) {
      for (std::size_t voxel = m_Slabs[s].begin + slice; voxel + slice < m_Slabs[s].end; ++voxel)
      {
        if (!holds(m_Slabs[s], m_Up[voxel]))
        {
          m_Up[voxel] = m_Up[m_Up[voxel]];
        }
      }
    });
  }

  /** Makes all voxels of a climb point to its peak, or to the first voxel for which `ends` returns true. */
  template <typename TEnds>
  void
  Follow(std::size_t voxel, const TEnds & ends)
  {
    Index target = m_Up[voxel];
    while (!ends(target) && m_Up[target] != target)
    {
      target = m_Up[target];
    }
    while (m_Up[voxel] != target)
    {
      const Index next = m_Up[voxel];
      m_Up[voxel] = target;
      voxel = next;
    }
  }

  /** Creates an arc for each peak, and sets m_ArcOfVoxel to the arc of the peak above each voxel. */
  void
  NumberPeaks()
  {
    m_ArcOfVoxel.resize(m_Rank.size());
    for (std::size_t voxel = 0; voxel < m_Rank.size(); ++voxel)
    {
      if (m_Up[voxel] == voxel)
      {
        m_ArcOfVoxel[voxel] = this->AddArc(m_Rank[voxel]);
      }
    }
    ParallelForBlocks(m_Rank.size(), [this](std::size_t voxel) {
      if (m_Up[voxel] != voxel)
      {
        m_ArcOfVoxel[voxel] = m_ArcOfVoxel[m_Up[voxel]];
      }
    });
  }

  Index
  AddArc(Index start)
  {
    const auto arc = static_cast<Index>(m_Start.size());
    m_Start.push_back(start);
    m_Parent.push_back(arc);
    return arc;
  }

  /** Visits the collected voxels from the highest to the lowest and joins the regions above each with a new arc. */
  void
  JoinRegions()
  {
    std::vector<Index> joins;
    for (const auto & ofSlab : m_Joins)
    {
      joins.insert(joins.end(), ofSlab.begin(), ofSlab.end());
    }
    std::sort(joins.begin(), joins.end(), std::greater<>());
    m_ArcOfSet.resize(m_Start.size());
    std::iota(m_ArcOfSet.begin(), m_ArcOfSet.end(), Index{ 0 });
    m_Sets = DisjointSets<Index>(m_Start.size());
    for (const Index rank : joins)
    {
      this->JoinAbove(m_Descending[m_Descending.size() - 1 - rank]);
    }
  }

  void
  JoinAbove(Index voxel)
  {
    const Neighbors groups = this->GroupsAbove(voxel, this->HigherNeighbors(voxel, this->InsideOf(voxel)));
    Index           joined = m_Sets.Find(m_ArcOfVoxel[voxel]); // the region of its highest neighbor
    bool            isNew = true;
    for (std::size_t d = 0; d < directions; ++d)
    {
      const Index set = (groups >> d & 1U) != 0 ? m_Sets.Find(m_ArcOfVoxel[voxel + m_Offsets[d]]) : joined;
      if (set != joined)
      {
        if (isNew)
        {
          const Index arc = this->AddArc(m_Rank[voxel]);
          m_Parent[m_ArcOfSet[joined]] = arc;
          m_ArcOfSet[joined] = arc;
          isNew = false;
        }
        const Index arc = m_ArcOfSet[joined];
        m_Parent[m_ArcOfSet[set]] = arc;
        m_Sets.Join(joined, set);
        joined = m_Sets.Find(set);
        m_ArcOfSet[joined] = arc;
      }
    }
  }

  Neighbors
  InsideOf(std::size_t voxel) const
  {
    Neighbors  inside = 0;
    const auto index = m_Grid.Voxel(voxel);
    for (std::size_t axis = 0; axis < index.size(); ++axis)
    {
      inside |= (index[axis] > 0 ? 1U : 0U) << (2 * axis);
      inside |= (index[axis] + 1 < m_Grid.size[axis] ? 2U : 0U) << (2 * axis);
    }
    return inside;
  }

  /** Sets a jump from each arc to an ancestor that may be far away, so that any ancestor is found in logarithmic time
   * (Myers 1983). */
  void
  FindJumps()
  {
    std::vector<Index> depth(m_Parent.size(), 0);
    m_Jump.resize(m_Parent.size());
    for (std::size_t arc = m_Parent.size(); arc-- > 0;)
    {
      const Index parent = m_Parent[arc];
      if (parent == arc) // the root
      {
        m_Jump[arc] = parent;
        continue;
      }
      const Index jump = m_Jump[parent];
      const bool  areEqual = depth[parent] - depth[jump] == depth[jump] - depth[m_Jump[jump]];
      depth[arc] = depth[parent] + 1;
      m_Jump[arc] = areEqual ? m_Jump[jump] : parent;
    }
  }

  /** Sets m_ArcOfVoxel to the last arc on the path from its peak to the root that starts at or above the voxel. */
  void
  AssignArcs()
  {
    ParallelForBlocks(m_Rank.size(), [this](std::size_t voxel) {
      const Index rank = m_Rank[voxel];
      Index       arc = m_ArcOfVoxel[voxel];
      while (m_Parent[arc] != arc && m_Start[m_Parent[arc]] >= rank)
      {
        arc = m_Start[m_Jump[arc]] >= rank ? m_Jump[arc] : m_Parent[arc];
      }
      m_ArcOfVoxel[voxel] = arc;
    });
  }

  /** Numbers the arcs so that each region is contiguous, and lists the voxels in this order. */
  ComponentTree
  OrderRegions()
  {
    const std::size_t  number = m_Parent.size();
    std::vector<Index> voxels(number, 0); // of the arc and the arcs below, later the next position
    std::vector<Index> arcs(number, 1);   // arcs below, with itself, later the next number
    for (const Index arc : m_ArcOfVoxel)
    {
      ++voxels[arc];
    }
    std::vector<Index> own = voxels;
    for (std::size_t arc = 0; arc + 1 < number; ++arc)
    {
      voxels[m_Parent[arc]] += voxels[arc];
      arcs[m_Parent[arc]] += arcs[arc];
    }
    ComponentTree tree;
    tree.m_Arcs.resize(number);
    std::vector<Index> numberOf(number), position(number);
    Index              firstVoxel = 0, firstArc = 0;
    for (std::size_t arc = number; arc-- > 0;)
    {
      const Index parent = m_Parent[arc];
      if (parent != arc)
      {
        firstVoxel = voxels[parent]; // next position within the parent
        firstArc = arcs[parent];
        voxels[parent] += voxels[arc];
        arcs[parent] += arcs[arc];
      }
      const Index end = firstVoxel + voxels[arc];
      numberOf[arc] = firstArc + arcs[arc] - 1;
      position[arc] = end - own[arc];
      tree.m_Arcs[numberOf[arc]] = { firstVoxel, position[arc], end, numberOf[parent] };
      voxels[arc] = firstVoxel;
      arcs[arc] = firstArc;
    }
    tree.m_Voxels = std::move(m_Up);
    for (const Index voxel : m_Descending)
    {
      tree.m_Voxels[position[m_ArcOfVoxel[voxel]]++] = voxel;
    }
    ParallelForBlocks(m_Rank.size(), [&](std::size_t voxel) { m_ArcOfVoxel[voxel] = numberOf[m_ArcOfVoxel[voxel]]; });
    tree.m_ArcOfVoxel = std::move(m_ArcOfVoxel);
    return tree;
  }

  const VoxelGrid &                      m_Grid;
  const std::vector<Slab> &              m_Slabs;
  const std::vector<Index> &             m_Rank;
  const std::vector<Index> &             m_Descending;
  std::array<std::ptrdiff_t, directions> m_Offsets{};
  std::vector<Index>                     m_Up;
  std::vector<std::vector<Index>>        m_Joins; // ranks, of each slab
  std::vector<Index>                     m_ArcOfVoxel;
  std::vector<Index>                     m_Start; // rank of the first voxel of each arc; parents after children
  std::vector<Index>                     m_Parent;
  std::vector<Index>                     m_Jump;
  DisjointSets<Index>                    m_Sets;
  std::vector<Index>                     m_ArcOfSet;
};

ComponentTrees
BuildComponentTrees(const float * values, const VoxelGrid & grid)
{
  const std::size_t voxels = grid.NumberOfVoxels();
  if (voxels == 0 || voxels > std::numeric_limits<Index>::max())
  {
    throw ParameterError("a component tree needs 1 to 2^32 - 1 voxels, not " + std::to_string(voxels));
  }
  const std::vector<Slab>  slabs = SlabsOf(grid);
  const std::vector<Index> descending = SortVoxels(values, slabs);
  ComponentTrees           trees;
  const auto               build = [&](const std::vector<Index> & order) {
    std::vector<Index> rank(voxels);
    ParallelForBlocks(voxels, [&](std::size_t i) { rank[order[i]] = static_cast<Index>(voxels - 1 - i); });
    return ComponentTreeBuilder(grid, slabs, rank, order).Build();
  };
  ParallelInvoke([&] { trees.maxTree = build(descending); },
                 [&] {
                   trees.minTree = build({ descending.rbegin(), descending.rend() });
                 });
  return trees;
}
} // namespace shapeton
