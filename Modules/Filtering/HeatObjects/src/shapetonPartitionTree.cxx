#include "shapetonPartitionTree.h"

#include "shapetonExceptions.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <queue>
#include <unordered_map>

namespace shapeton
{
namespace
{
using Index = PartitionTree::Index;
using Region = PartitionTree::Region;

/** A face between two voxels: 3 times the index of the lower voxel, plus the axis. */
using Face = std::uint32_t;

/** The steps across the faces of the voxels of a domain. */
class Steps
{
public:
  Steps(const float *                 values,
        const VoxelGrid &             grid,
        const std::array<double, 3> & spacing,
        const unsigned char *         domain)
    : m_Values(values), m_Grid(grid), m_Domain(domain)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      m_Area[axis] = spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
    }
  }

  std::size_t
  NumberOfVoxels() const
  {
    return m_Grid.NumberOfVoxels();
  }

  bool
  IsInDomain(std::size_t voxel) const
  {
    return !m_Domain || m_Domain[voxel] != 0;
  }

  /** Calls `inner(neighbor, axis)` for the neighbors of a voxel in the domain and `outer(axis)` for its faces on the
   * border of the domain. */
  template <typename TInner, typename TOuter>
  void
  ForEachFace(Index voxel, const TInner & inner, const TOuter & outer) const
  {
    const auto place = m_Grid.Voxel(voxel);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto stride = static_cast<Index>(m_Grid.stride[axis]);
      const bool isBelow = place[axis] > 0 && this->IsInDomain(voxel - stride);
      const bool isAbove = place[axis] + 1 < m_Grid.size[axis] && this->IsInDomain(voxel + stride);
      isBelow ? inner(voxel - stride, axis) : outer(axis);
      isAbove ? inner(voxel + stride, axis) : outer(axis);
    }
  }

  double
  AreaOf(unsigned int axis) const
  {
    return m_Area[axis];
  }

  float
  Between(Index a, Index b) const
  {
    return std::abs(m_Values[a] - m_Values[b]);
  }

  /** Steps in their order, ties by the face: the bits of a number that is not negative sort like the number. */
  std::uint64_t
  OrderOf(Index a, Index b, unsigned int axis) const
  {
    const float   step = this->Between(a, b);
    std::uint32_t bits;
    std::memcpy(&bits, &step, sizeof bits);
    return std::uint64_t{ bits } << 32U | (3 * std::min(a, b) + axis);
  }

  std::array<Index, 2>
  VoxelsOf(Face face) const
  {
    return { { face / 3, static_cast<Index>(face / 3 + m_Grid.stride[face % 3]) } };
  }

private:
  const float *         m_Values;
  const VoxelGrid &     m_Grid;
  const unsigned char * m_Domain; ///< null: all voxels
  std::array<double, 3> m_Area{};
};

/** The basins: a label for each voxel of the domain, and the voxels of each label. */
class Basins
{
public:
  explicit Basins(const Steps & steps) : m_Steps(steps), m_Labels(steps.NumberOfVoxels(), PartitionTree::NoBasin)
  {
    for (std::size_t voxel = 0; voxel < m_Labels.size(); ++voxel)
    {
      if (steps.IsInDomain(voxel))
      {
        m_Labels[voxel] = static_cast<Index>(m_Voxels.size());
        m_Voxels.push_back(static_cast<Index>(voxel));
      }
    }
    m_Sizes.assign(m_Voxels.size(), 1);
    for (std::size_t before = 0; before != m_Sizes.size();)
    {
      before = m_Sizes.size();
      this->JoinSmallOnes();
    }
    this->ListVoxels();
  }

  std::size_t
  Number() const
  {
    return m_Sizes.size();
  }

  const std::vector<Index> &
  GetLabels() const
  {
    return m_Labels;
  }

  Index
  SizeOf(std::size_t basin) const
  {
    return m_Sizes[basin];
  }

  /** The first of the voxels of a basin, which are ascending. */
  const Index *
  VoxelsOf(std::size_t basin) const
  {
    return m_Voxels.data() + m_First[basin];
  }

private:
  static constexpr auto none = std::numeric_limits<std::uint64_t>::max();

  /** Joins each basin that is too small to another one, across its smallest step. While basins are joined, m_Voxels are
   * the voxels of those that are too small. */
  void
  JoinSmallOnes()
  {
    std::vector<std::atomic<std::uint64_t>> smallest(m_Sizes.size());
    ParallelForBlocks(smallest.size(), [&](std::size_t basin) { smallest[basin].store(none, order); });
    ParallelForBlocks(m_Voxels.size(), [&](std::size_t i) {
      const Index   voxel = m_Voxels[i];
      std::uint64_t least = none;
      m_Steps.ForEachFace(
        voxel,
        [&](Index neighbor, unsigned int axis) {
          const bool isOther = m_Labels[neighbor] != m_Labels[voxel];
          least = isOther ? std::min(least, m_Steps.OrderOf(voxel, neighbor, axis)) : least;
        },
        [](unsigned int) {});
      std::uint64_t known = smallest[m_Labels[voxel]].load(order);
      while (least < known && !smallest[m_Labels[voxel]].compare_exchange_weak(known, least, order))
      {}
    });
    std::vector<std::atomic<Index>> to(m_Sizes.size());
    ParallelForBlocks(to.size(), [&](std::size_t basin) {
      to[basin].store(smallest[basin] == none ? static_cast<Index>(basin) : this->Across(smallest[basin], basin),
                      order);
    });
    this->Renumber(RootsOf(to));
    const auto isDone = [&](Index voxel) { return m_Sizes[m_Labels[voxel]] >= PartitionTree::BasinVoxels; };
    m_Voxels.erase(std::remove_if(m_Voxels.begin(), m_Voxels.end(), isDone), m_Voxels.end());
  }

  /** The basin on the other side of a face. */
  Index
  Across(std::uint64_t step, std::size_t basin) const
  {
    const auto [low, high] = m_Steps.VoxelsOf(static_cast<Face>(step));
    return m_Labels[low] == basin ? m_Labels[high] : m_Labels[low];
  }

  /** The end of the path from each basin. Two basins may point to each other, across the same face; no longer circle
   * exists. Shortens the paths meanwhile. */
  static std::vector<Index>
  RootsOf(std::vector<std::atomic<Index>> & to)
  {
    std::vector<Index> root(to.size());
    ParallelForBlocks(to.size(), [&](std::size_t basin) {
      const Index other = to[basin].load(order);
      root[basin] = basin < other && to[other].load(order) == basin ? 1 : 0;
    });
    ParallelForBlocks(to.size(), [&](std::size_t basin) {
      if (root[basin] == 1)
      {
        to[basin].store(static_cast<Index>(basin), order);
      }
    });
    ParallelForBlocks(to.size(), [&](std::size_t basin) {
      auto  here = static_cast<Index>(basin);
      Index next = to[here].load(order);
      while (next != here)
      {
        const Index further = to[next].load(order);
        to[here].store(further, order);
        here = further;
        next = to[here].load(order);
      }
      root[basin] = here;
    });
    return root;
  }

  void
  Renumber(const std::vector<Index> & root)
  {
    std::vector<Index> number(root.size());
    std::vector<Index> sizes;
    for (std::size_t basin = 0; basin < root.size(); ++basin)
    {
      if (root[basin] == basin)
      {
        number[basin] = static_cast<Index>(sizes.size());
        sizes.push_back(0);
      }
    }
    for (std::size_t basin = 0; basin < root.size(); ++basin)
    {
      sizes[number[root[basin]]] += m_Sizes[basin];
    }
    ParallelForBlocks(m_Labels.size(), [&](std::size_t voxel) {
      Index & label = m_Labels[voxel];
      label = label == PartitionTree::NoBasin ? label : number[root[label]];
    });
    m_Sizes = std::move(sizes);
  }

  void
  ListVoxels()
  {
    m_First.assign(m_Sizes.size() + 1, 0);
    std::partial_sum(m_Sizes.begin(), m_Sizes.end(), m_First.begin() + 1);
    std::vector<Index> next(m_First);
    m_Voxels.resize(m_First.back());
    for (std::size_t voxel = 0; voxel < m_Labels.size(); ++voxel)
    {
      if (m_Labels[voxel] != PartitionTree::NoBasin)
      {
        m_Voxels[next[m_Labels[voxel]]++] = static_cast<Index>(voxel);
      }
    }
  }

  static constexpr auto order = std::memory_order_relaxed;

  const Steps &      m_Steps;
  std::vector<Index> m_Labels;
  std::vector<Index> m_Voxels;
  std::vector<Index> m_Sizes;
  std::vector<Index> m_First;
};

/** The common border of two regions. */
struct Border
{
  Index  a, b;
  double steps; ///< sum of steps times area
  double area;  ///< mm^2; 0 if the regions have become one or the border a part of another
  float  strength{ 0.0F };
};

/** The borders of the basins. */
struct BordersOfBasins
{
  std::vector<Border> borders; ///< by the smaller and then the larger label
  std::vector<double> cut;     ///< area of each basin on the border of the volume
  std::vector<double> inside;  ///< mean step inside each basin
};

/** What one basin adds. */
struct BordersOfBasin
{
  std::vector<Border> borders; ///< with the basins of larger labels
  double              cut{ 0.0 };
  double              inside{ 0.0 };
};

/** `known` contains `none` for each basin, and does so again afterwards. */
BordersOfBasin
MeasureBasin(const Steps & steps, const Basins & basins, Index a, Index none, std::vector<Index> & known)
{
  BordersOfBasin own;
  double         areaInside = 0.0;
  for (const Index * voxel = basins.VoxelsOf(a); voxel < basins.VoxelsOf(a) + basins.SizeOf(a); ++voxel)
  {
    const auto measure = [&](Index neighbor, unsigned int axis) {
      const Index  b = basins.GetLabels()[neighbor];
      const double area = steps.AreaOf(axis);
      if (b == a)
      {
        own.inside += steps.Between(*voxel, neighbor) * area; // each face twice
        areaInside += area;
      }
      else if (b > a)
      {
        if (known[b] == none)
        {
          known[b] = static_cast<Index>(own.borders.size());
          own.borders.push_back({ a, b, 0.0, 0.0 });
        }
        own.borders[known[b]].steps += steps.Between(*voxel, neighbor) * area;
        own.borders[known[b]].area += area;
      }
    };
    steps.ForEachFace(*voxel, measure, [&](unsigned int axis) { own.cut += steps.AreaOf(axis); });
  }
  own.inside /= std::max(areaInside, std::numeric_limits<double>::min());
  for (const Border & border : own.borders)
  {
    known[border.b] = none;
  }
  std::sort(own.borders.begin(), own.borders.end(), [](const Border & x, const Border & y) { return x.b < y.b; });
  return own;
}

BordersOfBasins
FindBorders(const Steps & steps, const Basins & basins)
{
  constexpr auto                  none = std::numeric_limits<Index>::max();
  constexpr std::size_t           atOnce = 64; // basins, to make a call worth its time
  std::vector<BordersOfBasin>     ofBasin(basins.Number());
  std::vector<std::vector<Index>> ofWorker(NumberOfThreads()); // the border of a basin with each other one
  ParallelForWorkers((basins.Number() + atOnce - 1) / atOnce, [&](std::size_t block, unsigned int worker) {
    ofWorker[worker].resize(basins.Number(), none);
    for (std::size_t a = block * atOnce; a < std::min((block + 1) * atOnce, basins.Number()); ++a)
    {
      ofBasin[a] = MeasureBasin(steps, basins, static_cast<Index>(a), none, ofWorker[worker]);
    }
  });
  BordersOfBasins all;
  for (const BordersOfBasin & own : ofBasin)
  {
    all.borders.insert(all.borders.end(), own.borders.begin(), own.borders.end());
    all.cut.push_back(own.cut);
    all.inside.push_back(own.inside);
  }
  return all;
}
} // namespace

/** Merges the basins. A region is known by the label of one of its basins. */
class PartitionTreeBuilder
{
public:
  PartitionTreeBuilder(const Steps & steps, const Basins & basins)
    : m_Basins(basins), m_BordersOf(basins.Number()), m_RegionOf(basins.Number())
  {
    std::iota(m_RegionOf.begin(), m_RegionOf.end(), Index{ 0 });
    this->AddBasins(FindBorders(steps, basins));
  }

  PartitionTree
  Build(const Progress & progress)
  {
    this->MergeRegions(progress);
    this->JoinTrees();
    this->OrderVoxels();
    return std::move(m_Tree);
  }

private:
  struct Candidate
  {
    float strength;
    Index border;

    bool
    operator<(const Candidate & other) const // the greatest one is the weakest border
    {
      return strength != other.strength ? strength > other.strength : border > other.border;
    }
  };

  float
  StrengthOf(const Border & border) const
  {
    const Region & a = m_Tree.m_Regions[m_RegionOf[border.a]];
    const Region & b = m_Tree.m_Regions[m_RegionOf[border.b]];
    const Region & smaller =
      a.end != b.end ? (a.end < b.end ? a : b) : (m_RegionOf[border.a] < m_RegionOf[border.b] ? a : b);
    return static_cast<float>((border.steps + PartitionTree::NarrowShare * smaller.steps) /
                              (border.area + PartitionTree::NarrowShare * smaller.border));
  }

  void
  Update(Index border)
  {
    m_Borders[border].strength = this->StrengthOf(m_Borders[border]);
    m_Queue.push({ m_Borders[border].strength, border });
  }

  void
  AddBasins(BordersOfBasins && found)
  {
    m_Borders = std::move(found.borders);
    m_Tree.m_Regions.reserve(2 * m_Basins.Number());
    m_Tree.m_Regions.resize(m_Basins.Number());
    for (std::size_t basin = 0; basin < m_Basins.Number(); ++basin)
    {
      m_Tree.m_Regions[basin].end = m_Basins.SizeOf(basin); // the number of voxels, until they are ordered
      m_Tree.m_Regions[basin].parent = static_cast<Index>(basin);
      m_Tree.m_Regions[basin].cut = found.cut[basin];
      m_Tree.m_Regions[basin].strength = static_cast<float>(found.inside[basin]);
    }
    for (std::size_t border = 0; border < m_Borders.size(); ++border)
    {
      for (const Index basin : { m_Borders[border].a, m_Borders[border].b })
      {
        m_Tree.m_Regions[basin].steps += m_Borders[border].steps;
        m_Tree.m_Regions[basin].border += m_Borders[border].area;
        m_BordersOf[basin].push_back(static_cast<Index>(border));
      }
    }
  }

  void
  MergeRegions(const Progress & progress)
  {
    constexpr std::size_t atOnce = 1024; // regions, to make a report worth its time
    m_Between.reserve(m_Borders.size());
    for (Index border = 0; border < m_Borders.size(); ++border)
    {
      m_Between[Pair(m_Borders[border].a, m_Borders[border].b)] = border;
      this->Update(border);
    }
    while (!m_Queue.empty())
    {
      const auto [strength, border] = m_Queue.top();
      m_Queue.pop();
      if (m_Borders[border].area == 0.0 || m_Borders[border].strength != strength)
      {
        continue;
      }
      if (this->StrengthOf(m_Borders[border]) > strength)
      {
        this->Update(border);
      }
      else
      {
        this->Merge(border);
        const std::size_t merged = m_Tree.m_Regions.size() - m_Basins.Number();
        if (merged % atOnce == 0)
        {
          progress(static_cast<double>(merged) / m_Basins.Number());
        }
      }
    }
  }

  static std::uint64_t
  Pair(Index a, Index b)
  {
    return std::uint64_t{ std::min(a, b) } << 32U | std::max(a, b);
  }

  /** The region with more borders keeps its label; the other one hands over its borders. */
  void
  Merge(Index border)
  {
    Border & common = m_Borders[border];
    Index    kept = common.a, other = common.b;
    if (m_BordersOf[kept].size() < m_BordersOf[other].size())
    {
      std::swap(kept, other);
    }
    m_RegionOf[kept] = this->AddRegion(m_RegionOf[kept], m_RegionOf[other], common);
    m_Between.erase(Pair(kept, other));
    common.area = 0.0;
    for (const Index moved : m_BordersOf[other])
    {
      if (m_Borders[moved].area > 0.0)
      {
        this->Update(this->HandOver(moved, other, kept));
      }
    }
    m_BordersOf[other] = {};
  }

  /** Makes a border of a region a border of its new owner: adds it to the one with the same neighbor, if there is one.
   * Returns the border that is in use. */
  Index
  HandOver(Index border, Index from, Index to)
  {
    Border &    moved = m_Borders[border];
    Index &     end = moved.a == from ? moved.a : moved.b;
    const Index neighbor = moved.a == from ? moved.b : moved.a;
    m_Between.erase(Pair(from, neighbor));
    const auto [known, isNew] = m_Between.try_emplace(Pair(to, neighbor), border);
    if (isNew)
    {
      end = to;
      m_BordersOf[to].push_back(border);
      return border;
    }
    Border & joined = m_Borders[known->second];
    joined.steps += moved.steps;
    joined.area += moved.area;
    moved.area = 0.0;
    return known->second;
  }

  /** Returns the number of the new region. */
  Index
  AddRegion(Index first, Index second, const Border & common)
  {
    auto &     regions = m_Tree.m_Regions;
    const auto number = static_cast<Index>(regions.size());
    Region &   a = regions[first];
    Region &   b = regions[second];
    Region     both;
    both.end = a.end + b.end;
    both.parent = number;
    both.strength = std::max({ common.strength, a.strength, b.strength });
    both.steps = std::max(0.0, a.steps + b.steps - 2.0 * common.steps);
    both.border = std::max(0.0, a.border + b.border - 2.0 * common.area);
    both.cut = a.cut + b.cut;
    a.parent = b.parent = number;
    regions.push_back(both);
    return number;
  }

  /** Regions without a common border, in a domain of several parts, become one in the order of their numbers. */
  void
  JoinTrees()
  {
    Border nothing{ 0, 0, 0.0, 0.0 };
    nothing.strength = std::numeric_limits<float>::max();
    std::vector<Index> roots;
    for (Index region = 0; region < m_Tree.m_Regions.size(); ++region)
    {
      if (m_Tree.m_Regions[region].parent == region)
      {
        roots.push_back(region);
      }
    }
    std::accumulate(roots.begin() + 1, roots.end(), roots.front(), [&](Index all, Index next) {
      return this->AddRegion(all, next, nothing);
    });
  }

  /** Sets the range of each region, from the root down, and lists the voxels. */
  void
  OrderVoxels()
  {
    auto &             regions = m_Tree.m_Regions;
    std::vector<Index> next(regions.size()); // where the next part of a region begins
    for (std::size_t region = regions.size(); region-- > 0;)
    {
      Region &    here = regions[region];
      const Index voxels = here.end;
      if (here.parent != region)
      {
        here.first = next[here.parent];
        next[here.parent] += voxels;
      }
      here.end = here.first + voxels;
      next[region] = here.first;
    }
    m_Tree.m_BasinOfVoxel = m_Basins.GetLabels();
    m_Tree.m_Voxels.resize(regions.back().NumberOfVoxels());
    ParallelForBlocks(m_Basins.Number(), [&](std::size_t basin) {
      std::copy_n(m_Basins.VoxelsOf(basin), m_Basins.SizeOf(basin), m_Tree.m_Voxels.begin() + regions[basin].first);
    });
  }

  const Basins &                           m_Basins;
  std::vector<Border>                      m_Borders;
  std::vector<std::vector<Index>>          m_BordersOf; ///< of each label; some have become parts of others
  std::unordered_map<std::uint64_t, Index> m_Between;   ///< the border of two labels
  std::vector<Index>                       m_RegionOf;  ///< of each label that is still in use
  std::priority_queue<Candidate>           m_Queue;
  PartitionTree                            m_Tree;
};

PartitionTree
BuildPartitionTree(const float *                 values,
                   const VoxelGrid &             grid,
                   const std::array<double, 3> & spacing,
                   const unsigned char *         domain,
                   const Progress &              progress)
{
  constexpr double      shareOfBasins = 0.4; // of the time
  constexpr std::size_t mostVoxels = std::numeric_limits<Face>::max() / 3;
  const std::size_t     voxels = grid.NumberOfVoxels();
  RequireParameter(voxels > 0 && voxels <= mostVoxels,
                   "a partition tree needs 1 to " + std::to_string(mostVoxels) + " voxels, not " +
                     std::to_string(voxels));
  for (const double length : spacing)
  {
    if (!(length > 0.0) || !std::isfinite(length))
    {
      throw InputError("the voxel spacing must be positive");
    }
  }
  ParallelForBlocks(voxels, [values, domain](std::size_t voxel) {
    if (!std::isfinite(values[voxel]) && (!domain || domain[voxel] != 0))
    {
      throw InputError("voxel " + std::to_string(voxel) + " is not a finite number");
    }
  });
  const Steps  steps(values, grid, spacing, domain);
  const Basins basins(steps);
  if (basins.Number() == 0)
  {
    throw InputError("the domain of the objects has no voxel; use a mask with nonzero voxels");
  }
  progress(shareOfBasins);
  return PartitionTreeBuilder(steps, basins).Build(progress.Part("", shareOfBasins, 1.0));
}
} // namespace shapeton
