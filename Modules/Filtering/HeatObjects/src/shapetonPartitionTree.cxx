#include "shapetonPartitionTree.h"

#include "shapetonDisjointSets.h"
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

/** The faces of a volume and the steps across them. */
class Faces
{
public:
  Faces(const float * values, const VoxelGrid & grid, const std::array<double, 3> & spacing)
    : m_Values(values), m_Grid(grid)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      m_Area[axis] = spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
    }
  }

  const VoxelGrid &
  GetGrid() const
  {
    return m_Grid;
  }

  std::array<Index, 2>
  VoxelsOf(Face face) const
  {
    return { { face / 3, static_cast<Index>(face / 3 + m_Grid.stride[face % 3]) } };
  }

  double
  AreaOf(Face face) const
  {
    return m_Area[face % 3];
  }

  float
  StepAcross(Face face) const
  {
    const auto [low, high] = this->VoxelsOf(face);
    return std::abs(m_Values[high] - m_Values[low]);
  }

  /** Steps in their order, ties by the face: the bits of a number that is not negative sort like the number. */
  std::uint64_t
  OrderOf(Face face) const
  {
    const float   step = this->StepAcross(face);
    std::uint32_t bits;
    std::memcpy(&bits, &step, sizeof bits);
    return std::uint64_t{ bits } << 32U | face;
  }

  /** Calls `body(face)` for all faces between voxels, in parallel by slices. */
  template <typename TBody>
  void
  ForEachInParallel(const TBody & body) const
  {
    ParallelFor(static_cast<std::size_t>(m_Grid.size[2]), [&](std::size_t slice) {
      const int k = static_cast<int>(slice);
      for (int j = 0; j < m_Grid.size[1]; ++j)
      {
        Face face = static_cast<Face>(3 * m_Grid.Index(0, j, k));
        for (int i = 0; i < m_Grid.size[0]; ++i, face += 3)
        {
          if (i + 1 < m_Grid.size[0])
          {
            body(face);
          }
          if (j + 1 < m_Grid.size[1])
          {
            body(face + 1);
          }
          if (k + 1 < m_Grid.size[2])
          {
            body(face + 2);
          }
        }
      }
    });
  }

  /** Area of the faces of a voxel on the border of the volume. */
  double
  CutOf(std::size_t voxel) const
  {
    const auto place = m_Grid.Voxel(voxel);
    double     cut = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      cut += place[axis] == 0 ? m_Area[axis] : 0.0;
      cut += place[axis] + 1 == m_Grid.size[axis] ? m_Area[axis] : 0.0;
    }
    return cut;
  }

private:
  const float *         m_Values;
  const VoxelGrid &     m_Grid;
  std::array<double, 3> m_Area{};
};

/** Makes each number point to the end of its path; paths end in numbers that point to themselves. */
void
PointToEnds(std::vector<Index> & to)
{
  std::vector<Index> further(to.size());
  std::atomic<bool>  hasMoved{ true };
  while (hasMoved)
  {
    hasMoved = false;
    ParallelForBlocks(to.size(), [&](std::size_t i) {
      further[i] = to[to[i]];
      if (further[i] != to[i])
      {
        hasMoved.store(true, std::memory_order_relaxed);
      }
    });
    to.swap(further);
  }
}

/** The basins: a label for each voxel. */
class Basins
{
public:
  explicit Basins(const Faces & faces) : m_Faces(faces), m_Labels(faces.GetGrid().NumberOfVoxels())
  {
    std::iota(m_Labels.begin(), m_Labels.end(), Index{ 0 });
    m_Sizes.assign(m_Labels.size(), 1);
    for (Index before = 0; before != m_Sizes.size();)
    {
      before = static_cast<Index>(m_Sizes.size());
      this->JoinSmallOnes();
    }
  }

  const std::vector<Index> &
  GetLabels() const
  {
    return m_Labels;
  }

  const std::vector<Index> &
  GetSizes() const
  {
    return m_Sizes;
  }

private:
  /** Joins each basin that is too small to another one, across its smallest step. */
  void
  JoinSmallOnes()
  {
    constexpr auto                          none = std::numeric_limits<std::uint64_t>::max();
    std::vector<std::atomic<std::uint64_t>> smallest(m_Sizes.size());
    ParallelForBlocks(smallest.size(), [&](std::size_t basin) { smallest[basin].store(none); });
    m_Faces.ForEachInParallel([&](Face face) {
      const auto [low, high] = m_Faces.VoxelsOf(face);
      const auto a = m_Labels[low], b = m_Labels[high];
      if (a != b)
      {
        const std::uint64_t order = m_Faces.OrderOf(face);
        this->Lower(a, order, smallest);
        this->Lower(b, order, smallest);
      }
    });
    std::vector<Index> to(m_Sizes.size());
    ParallelForBlocks(to.size(), [&](std::size_t basin) {
      const std::uint64_t order = smallest[basin];
      to[basin] = order == none ? static_cast<Index>(basin) : this->Across(static_cast<Face>(order), basin);
    });
    this->Renumber(this->RootsOf(to));
  }

  void
  Lower(Index basin, std::uint64_t order, std::vector<std::atomic<std::uint64_t>> & smallest) const
  {
    if (m_Sizes[basin] >= PartitionTree::BasinVoxels)
    {
      return;
    }
    std::uint64_t known = smallest[basin].load(std::memory_order_relaxed);
    while (order < known && !smallest[basin].compare_exchange_weak(known, order, std::memory_order_relaxed))
    {}
  }

  Index
  Across(Face face, std::size_t basin) const
  {
    const auto [low, high] = m_Faces.VoxelsOf(face);
    return m_Labels[low] == basin ? m_Labels[high] : m_Labels[low];
  }

  /** Two basins may point to each other, across the same face; no longer circle exists. */
  static std::vector<Index>
  RootsOf(const std::vector<Index> & to)
  {
    std::vector<Index> root(to.size());
    ParallelForBlocks(to.size(), [&](std::size_t basin) {
      root[basin] = to[to[basin]] == basin && basin < to[basin] ? static_cast<Index>(basin) : to[basin];
    });
    PointToEnds(root);
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
    ParallelForBlocks(m_Labels.size(), [&](std::size_t voxel) { m_Labels[voxel] = number[root[m_Labels[voxel]]]; });
    m_Sizes = std::move(sizes);
  }

  const Faces &      m_Faces;
  std::vector<Index> m_Labels;
  std::vector<Index> m_Sizes;
};

/** The common border of two regions. */
struct Border
{
  Index  a, b;
  double steps; ///< sum of steps times area
  double area;  ///< mm^2; 0 if the regions have become one or the border a part of another
  float  strength{ 0.0F };
};

/** The borders of the basins, by the smaller and then the larger label. */
std::vector<Border>
FindBorders(const Faces & faces, const Basins & basins)
{
  const auto &                    labels = basins.GetLabels();
  const std::size_t               number = basins.GetSizes().size();
  std::vector<std::atomic<Index>> next(number);
  const auto                      forEachFace = [&](const auto & body) {
    faces.ForEachInParallel([&](Face face) {
      const auto [low, high] = faces.VoxelsOf(face);
      if (labels[low] != labels[high])
      {
        body(std::min(labels[low], labels[high]), std::max(labels[low], labels[high]), face);
      }
    });
  };
  forEachFace([&](Index a, Index, Face) { next[a].fetch_add(1, std::memory_order_relaxed); });
  std::vector<Index> first(number + 1, 0);
  for (std::size_t a = 0; a < number; ++a)
  {
    first[a + 1] = first[a] + next[a];
    next[a] = first[a];
  }
  std::vector<std::uint64_t> items(first.back()); // the larger label above, the face below
  forEachFace([&](Index a, Index b, Face face) {
    items[next[a].fetch_add(1, std::memory_order_relaxed)] = std::uint64_t{ b } << 32U | face;
  });
  std::vector<std::vector<Border>> ofBasin(number);
  ParallelForBlocks(number, [&](std::size_t a) {
    std::sort(items.begin() + first[a], items.begin() + first[a + 1]);
    for (Index i = first[a]; i < first[a + 1]; ++i)
    {
      const auto b = static_cast<Index>(items[i] >> 32U);
      const auto face = static_cast<Face>(items[i]);
      if (ofBasin[a].empty() || ofBasin[a].back().b != b)
      {
        ofBasin[a].push_back({ static_cast<Index>(a), b, 0.0, 0.0 });
      }
      ofBasin[a].back().steps += faces.StepAcross(face) * faces.AreaOf(face);
      ofBasin[a].back().area += faces.AreaOf(face);
    }
  });
  std::vector<Border> borders;
  for (const auto & some : ofBasin)
  {
    borders.insert(borders.end(), some.begin(), some.end());
  }
  return borders;
}
} // namespace

/** Merges the basins. A region is known by the label of one of its basins. */
class PartitionTreeBuilder
{
public:
  PartitionTreeBuilder(const Faces & faces, const Basins & basins)
    : m_Faces(faces)
    , m_Basins(basins)
    , m_Borders(FindBorders(faces, basins))
    , m_BordersOf(basins.GetSizes().size())
    , m_RegionOf(basins.GetSizes().size())
  {
    std::iota(m_RegionOf.begin(), m_RegionOf.end(), Index{ 0 });
  }

  PartitionTree
  Build()
  {
    this->AddBasins();
    this->MergeRegions();
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
  AddBasins()
  {
    const auto & sizes = m_Basins.GetSizes();
    m_Tree.m_Regions.reserve(2 * sizes.size());
    m_Tree.m_Regions.resize(sizes.size());
    for (std::size_t basin = 0; basin < sizes.size(); ++basin)
    {
      m_Tree.m_Regions[basin].end = sizes[basin]; // the number of voxels, until they are ordered
      m_Tree.m_Regions[basin].parent = static_cast<Index>(basin);
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
    const auto & labels = m_Basins.GetLabels();
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel)
    {
      m_Tree.m_Regions[labels[voxel]].cut += m_Faces.CutOf(voxel);
    }
  }

  void
  MergeRegions()
  {
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
    this->AddRegion(kept, other, common);
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

  void
  AddRegion(Index kept, Index other, const Border & common)
  {
    auto &     regions = m_Tree.m_Regions;
    const auto number = static_cast<Index>(regions.size());
    Region &   a = regions[m_RegionOf[kept]];
    Region &   b = regions[m_RegionOf[other]];
    Region     both;
    both.end = a.end + b.end;
    both.parent = number;
    both.strength = std::max({ common.strength, a.strength, b.strength });
    both.steps = std::max(0.0, a.steps + b.steps - 2.0 * common.steps);
    both.border = std::max(0.0, a.border + b.border - 2.0 * common.area);
    both.cut = a.cut + b.cut;
    a.parent = b.parent = number;
    m_RegionOf[kept] = number;
    regions.push_back(both);
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
    m_Tree.m_Voxels.resize(m_Tree.m_BasinOfVoxel.size());
    for (std::size_t voxel = 0; voxel < m_Tree.m_Voxels.size(); ++voxel)
    {
      m_Tree.m_Voxels[next[m_Tree.m_BasinOfVoxel[voxel]]++] = static_cast<Index>(voxel);
    }
  }

  const Faces &                            m_Faces;
  const Basins &                           m_Basins;
  std::vector<Border>                      m_Borders;
  std::vector<std::vector<Index>>          m_BordersOf; ///< of each label; some have become parts of others
  std::unordered_map<std::uint64_t, Index> m_Between;   ///< the border of two labels
  std::vector<Index>                       m_RegionOf;  ///< of each label that is still in use
  std::priority_queue<Candidate>           m_Queue;
  PartitionTree                            m_Tree;
};

PartitionTree
BuildPartitionTree(const float * values, const VoxelGrid & grid, const std::array<double, 3> & spacing)
{
  constexpr std::size_t mostVoxels = std::numeric_limits<Face>::max() / 3;
  const std::size_t     voxels = grid.NumberOfVoxels();
  RequireParameter(voxels > 0 && voxels <= mostVoxels,
                   "a partition tree needs 1 to " + std::to_string(mostVoxels) + " voxels, not " +
                     std::to_string(voxels));
  for (const double length : spacing)
  {
    RequireParameter(length > 0.0 && std::isfinite(length), "the spacing of a partition tree must be positive");
  }
  ParallelForBlocks(voxels, [values](std::size_t voxel) {
    if (!std::isfinite(values[voxel]))
    {
      throw InputError("voxel " + std::to_string(voxel) + " is not a finite number");
    }
  });
  const Faces  faces(values, grid, spacing);
  const Basins basins(faces);
  return PartitionTreeBuilder(faces, basins).Build();
}
} // namespace shapeton
