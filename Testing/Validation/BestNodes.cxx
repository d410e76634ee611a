#include "BestNodes.h"

#include "shapetonDisjointSets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>

using namespace shapeton;

namespace
{
/** Disjoint sets of voxels, their counts by label, and the best Dice of each part with any of them. */
class SetsOfVoxels
{
public:
  explicit SetsOfVoxels(const ReferenceParts & parts)
    : m_Parts(parts)
    , m_Sets(parts.GetGrid().NumberOfVoxels())
    , m_Sizes(parts.GetGrid().NumberOfVoxels(), 1)
    , m_Rows(parts.GetGrid().NumberOfVoxels(), none)
    , m_Best(parts.GetLabels().size(), 0.0)
    , m_Single(parts.GetTotals().size(), 0.0)
  {}

  void
  Join(std::uint32_t a, std::uint32_t b)
  {
    a = m_Sets.Find(a);
    b = m_Sets.Find(b);
    if (!m_Sets.Join(a, b))
    {
      return;
    }
    const std::uint32_t merged = std::min(a, b);
    const std::uint32_t other = std::max(a, b);
    if (m_Rows[a] != none || m_Rows[b] != none || m_Parts.LabelOf(a) != m_Parts.LabelOf(b))
    {
      this->AddCounts(merged, other);
    }
    m_Sizes[merged] += m_Sizes[other];
    if (m_Sizes[merged] >= PartitionTree::BasinVoxels)
    {
      this->Compare(merged);
    }
  }

  const std::vector<double> &
  GetBest() const
  {
    return m_Best;
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /** The counts of a set; without a row, all its voxels have one label. */
  ReferenceParts::Counts &
  RowOf(std::uint32_t set)
  {
    if (m_Rows[set] == none)
    {
      if (m_Free.empty())
      {
        m_Free.push_back(static_cast<std::uint32_t>(m_Counts.size()));
        m_Counts.emplace_back();
      }
      m_Rows[set] = m_Free.back();
      m_Free.pop_back();
      m_Counts[m_Rows[set]].assign(m_Parts.GetTotals().size(), 0.0);
      m_Counts[m_Rows[set]][m_Parts.LabelOf(set)] = m_Sizes[set];
    }
    return m_Counts[m_Rows[set]];
  }

  void
  AddCounts(std::uint32_t to, std::uint32_t from)
  {
    ReferenceParts::Counts & sums = this->RowOf(to);
    if (m_Rows[from] == none)
    {
      sums[m_Parts.LabelOf(from)] += m_Sizes[from];
      return;
    }
    const ReferenceParts::Counts & counts = m_Counts[m_Rows[from]];
    std::transform(sums.begin(), sums.end(), counts.begin(), sums.begin(), std::plus<>());
    m_Free.push_back(m_Rows[from]);
  }

  void
  Compare(std::uint32_t set)
  {
    const bool     isSingle = m_Rows[set] == none;
    double &       single = m_Single[m_Parts.LabelOf(set)];
    const double * counts = isSingle ? m_Single.data() : m_Counts[m_Rows[set]].data();
    single = isSingle ? m_Sizes[set] : 0.0;
    for (std::size_t i = 0; i < m_Best.size(); ++i)
    {
      m_Best[i] = std::max(m_Best[i], m_Parts.Dice(m_Parts.GetLabels()[i], counts, m_Sizes[set]));
    }
    single = 0.0;
  }

  const ReferenceParts &              m_Parts;
  DisjointSets<std::uint32_t>         m_Sets;
  std::vector<std::uint32_t>          m_Sizes;  ///< by representative
  std::vector<std::uint32_t>          m_Rows;   ///< of m_Counts, by representative
  std::vector<ReferenceParts::Counts> m_Counts; ///< of the sets with several labels
  std::vector<std::uint32_t>          m_Free;   ///< unused rows
  std::vector<double>                 m_Best;   ///< by part
  ReferenceParts::Counts              m_Single; ///< of a set without a row, during Compare()
};

/** Edge from a voxel to the next one along an axis. */
struct Edge
{
  std::uint32_t key;    ///< in the order of the weights
  std::uint32_t number; ///< 3 voxel + axis
};

/** The bits of a number, as an unsigned integer in the same order. */
std::uint32_t
KeyOf(float weight)
{
  constexpr std::uint32_t sign = 0x80000000U;
  std::uint32_t           bits = 0;
  std::memcpy(&bits, &weight, sizeof bits);
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

/** Sorts by key, stable, in two passes of 16 bits. */
void
Sort(std::vector<Edge> & edges)
{
  constexpr std::size_t values = 65536;
  std::vector<Edge>     sorted(edges.size());
  for (const unsigned int shift : { 0U, 16U })
  {
    std::vector<std::size_t> next(values + 1, 0);
    for (const Edge & edge : edges)
    {
      ++next[(edge.key >> shift) % values + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const Edge & edge : edges)
    {
      sorted[next[(edge.key >> shift) % values]++] = edge;
    }
    edges.swap(sorted);
  }
}

std::vector<Edge>
SortedEdges(const float * values, EdgeWeight weight, const VoxelGrid & grid)
{
  std::vector<Edge> edges;
  edges.reserve(3 * grid.NumberOfVoxels());
  for (std::size_t voxel = 0; voxel < grid.NumberOfVoxels(); ++voxel)
  {
    const auto place = grid.Voxel(voxel);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (place[axis] + 1 < grid.size[axis])
      {
        const float a = values[voxel];
        const float b = values[voxel + grid.stride[axis]];
        edges.push_back({ KeyOf(weight == EdgeWeight::Difference ? std::abs(a - b)
                                : weight == EdgeWeight::Maximum  ? std::max(a, b)
                                                                 : -std::min(a, b)),
                          static_cast<std::uint32_t>(3 * voxel + axis) });
      }
    }
  }
  Sort(edges);
  return edges;
}
} // namespace

std::vector<double>
BestNodes(const float * values, EdgeWeight weight, const ReferenceParts & parts)
{
  const VoxelGrid & grid = parts.GetGrid();
  SetsOfVoxels      sets(parts);
  for (const Edge & edge : SortedEdges(values, weight, grid))
  {
    const std::uint32_t voxel = edge.number / 3;
    sets.Join(voxel, voxel + static_cast<std::uint32_t>(grid.stride[edge.number % 3]));
  }
  return sets.GetBest();
}
