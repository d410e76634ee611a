#include "itkMinimalPath.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace itk
{
namespace
{
/** A monotone priority queue (Ahuja, Mehlhorn, Orlin, Tarjan 1990): an entry lies in the bucket of the highest bit in
 * which its key differs from the last key taken. Non-negative doubles are ordered as their bits are. */
class RadixQueue
{
public:
  struct Entry
  {
    std::uint64_t key;
    int           node;
  };

  void
  Push(double cost, int node)
  {
    std::uint64_t key = 0;
    std::memcpy(&key, &cost, sizeof(key));
    m_Buckets[BucketOf(key ^ m_Last)].push_back({ key, node });
    ++m_Size;
  }

  bool
  IsEmpty() const
  {
    return m_Size == 0;
  }

  std::pair<double, int>
  Pop()
  {
    if (m_Buckets[0].empty())
    {
      this->Refill();
    }
    const Entry entry = m_Buckets[0].back();
    m_Buckets[0].pop_back();
    --m_Size;
    double cost = 0.0;
    std::memcpy(&cost, &entry.key, sizeof(cost));
    return { cost, entry.node };
  }

private:
  static int
  BucketOf(std::uint64_t difference)
  {
    return difference == 0 ? 0 : 64 - __builtin_clzll(difference);
  }

  void
  Refill()
  {
    int full = 1;
    while (m_Buckets[full].empty())
    {
      ++full;
    }
    std::vector<Entry> entries;
    entries.swap(m_Buckets[full]);
    m_Last = entries.front().key;
    for (const Entry & entry : entries)
    {
      m_Last = std::min(m_Last, entry.key);
    }
    for (const Entry & entry : entries)
    {
      m_Buckets[BucketOf(entry.key ^ m_Last)].push_back(entry);
    }
    // The memory serves the next entries of this bucket.
    entries.clear();
    entries.swap(m_Buckets[full]);
  }

  std::array<std::vector<Entry>, 65> m_Buckets;
  std::uint64_t                      m_Last{ 0 };
  std::size_t                        m_Size{ 0 };
};

/** What a step looks at, side by side in memory. */
struct Record
{
  double reached;
  /** Of half a mm. */
  float cost;
  int   cell;
};

std::vector<Record>
MakeRecords(const LumenGrid & grid, const LumenCells & cells, int exponent)
{
  std::vector<Record> records(grid.NumberOfNodes());
  for (int node = 0; node < grid.NumberOfNodes(); ++node)
  {
    const double base = 1.0 / (grid.Distance(node) + 0.1);
    // Not std::pow, whose last bit depends on the processor.
    double cost = 0.5 * base;
    for (int i = 1; i < exponent; ++i)
    {
      cost *= base;
    }
    records[node] = { std::numeric_limits<double>::infinity(), static_cast<float>(cost), cells.cellOf[node] };
  }
  return records;
}
} // namespace

std::vector<int>
PathTree::PathTo(int node) const
{
  std::vector<int> path;
  for (; node >= 0; node = parents[node])
  {
    path.push_back(node);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

PathTree
GrowPathTree(const LumenGrid & grid, const LumenCells & cells, const CellTree & tree, int start, int exponent)
{
  std::vector<Record> records = MakeRecords(grid, cells, exponent);
  PathTree            paths;
  paths.parents.assign(grid.NumberOfNodes(), -1);
  paths.lengths.assign(grid.NumberOfNodes(), -1.0F);
  RadixQueue queue;
  queue.Push(0.0, start);
  records[start].reached = 0.0;
  paths.lengths[start] = 0.0F;
  while (!queue.IsEmpty())
  {
    const auto [cost, node] = queue.Pop();
    const Record here = records[node];
    if (cost > here.reached)
    {
      continue;
    }
    paths.order.push_back(node);
    for (const auto & step : grid.Steps())
    {
      const int next = grid.Neighbour(node, step.offset);
      if (next < 0)
      {
        continue;
      }
      Record &     there = records[next];
      const double through = cost + step.length * (static_cast<double>(here.cost) + there.cost);
      if (through < there.reached && (here.cell == there.cell || tree.IsOpen(here.cell, there.cell)))
      {
        there.reached = through;
        paths.parents[next] = node;
        paths.lengths[next] = paths.lengths[node] + static_cast<float>(step.length);
        queue.Push(through, next);
      }
    }
  }
  return paths;
}
} // namespace itk
