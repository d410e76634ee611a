#include "shapetonFilledStretch.h"

#include <algorithm>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double aboveCeiling = 2.0; // mm; the points of a slice are below its ceiling
constexpr double gasAbove = 1.5;     // mm
constexpr int    toGas = 5;          // slices between the filled ones and gas, at most
constexpr double mostAdded = 0.15;   // of the lumen
constexpr int    mostBeyond = 14;    // slices that are filled in addition
constexpr int    shorterBy = 3;      // slices

/** A stretch below one level. */
struct FilledDip
{
  std::array<int, 2> filled{ { 0, 0 } }; ///< slices
  std::vector<int>   reached;            ///< slices with fluid
  double             level{ 0.0 };
  std::size_t        added{ std::numeric_limits<std::size_t>::max() }; ///< points
};

class DipFinder
{
public:
  DipFinder(const std::vector<std::vector<float>> & heights,
            const std::vector<FluidPassage> &       passages,
            const std::vector<bool> &               allowed,
            const std::vector<FluidPool> &          pools)
    : m_Heights(heights), m_Allowed(allowed), m_Passages(heights.size()), m_Levels(heights.size(), dry)
  {
    std::size_t all = 0;
    for (const auto & slice : heights)
    {
      all += slice.size();
    }
    m_MostAdded = static_cast<std::size_t>(mostAdded * static_cast<double>(all));
    for (const FluidPassage & passage : passages)
    {
      m_Passages[passage.a].push_back({ passage.a, passage.b, passage.height });
      m_Passages[passage.b].push_back({ passage.b, passage.a, passage.height });
    }
    for (const FluidPool & pool : pools)
    {
      for (const int slice : pool.slices)
      {
        m_Levels[slice] = pool.level;
      }
    }
  }

  FilledDip
  Best(int length) const
  {
    FilledDip best;
    best.added = m_MostAdded;
    for (int first = 1; first + length < static_cast<int>(m_Heights.size()); ++first)
    {
      FilledDip dip = this->DipOver(first, first + length);
      if (dip.added < best.added && this->IsBetweenGas(dip, length))
      {
        best = std::move(dip);
      }
    }
    return best;
  }

private:
  static constexpr double dry = -1e9; // mm, a level

  bool
  IsFilled(int slice, double level) const
  {
    return !m_Heights[slice].empty() && m_Heights[slice].back() + aboveCeiling <= level;
  }

  // Whether one of the slices has gas at its ceiling.
  bool
  HasGas(int first, int end, double level) const
  {
    const int last = std::min(end, static_cast<int>(m_Heights.size()));
    for (int slice = std::max(first, 0); slice < last; ++slice)
    {
      if (!m_Heights[slice].empty() && m_Heights[slice].back() > level + gasAbove)
      {
        return true;
      }
    }
    return false;
  }

  bool
  IsBetweenGas(const FilledDip & dip, int length) const
  {
    const auto [first, end] = dip.filled;
    const auto begin = m_Allowed.begin();
    return end - first <= length + mostBeyond && std::find(begin + first, begin + end, false) == begin + end &&
           this->HasGas(first - toGas, first, dip.level) && this->HasGas(end, end + toGas, dip.level);
  }

  FilledDip
  DipOver(int first, int end) const
  {
    FilledDip dip;
    dip.level = dry;
    for (int slice = first; slice < end; ++slice)
    {
      if (!m_Allowed[slice] || m_Heights[slice].empty())
      {
        return dip;
      }
      dip.level = std::max({ dip.level, m_Heights[slice].back() + aboveCeiling, m_Levels[slice] });
    }
    while (first > 0 && this->IsFilled(first - 1, dip.level))
    {
      --first;
    }
    while (end < static_cast<int>(m_Heights.size()) && this->IsFilled(end, dip.level))
    {
      ++end;
    }
    dip.filled = { { first, end } };
    dip.reached = this->Reached(first, dip.level);
    dip.added = 0;
    for (const int slice : dip.reached)
    {
      const std::size_t present = PointsBelow(m_Heights, { slice }, m_Levels[slice]);
      dip.added += std::max(present, PointsBelow(m_Heights, { slice }, dip.level)) - present;
    }
    return dip;
  }

  std::vector<int>
  Reached(int start, double level) const
  {
    std::vector<bool> isReached(m_Heights.size(), false);
    std::vector<int>  reached{ start };
    isReached[start] = true;
    for (std::size_t i = 0; i < reached.size(); ++i)
    {
      for (const FluidPassage & passage : m_Passages[reached[i]])
      {
        if (passage.height < level && !isReached[passage.b])
        {
          isReached[passage.b] = true;
          reached.push_back(passage.b);
        }
      }
    }
    std::sort(reached.begin(), reached.end());
    return reached;
  }

  const std::vector<std::vector<float>> & m_Heights;
  const std::vector<bool> &               m_Allowed;
  std::vector<std::vector<FluidPassage>>  m_Passages; // from each slice
  std::vector<double>                     m_Levels;
  std::size_t                             m_MostAdded; // points
};
// Takes the slices of the dip from their pools, and returns the pool that had most of them, or pools.end() if none had
// any.
std::vector<FluidPool>::iterator
TakeSlices(const std::vector<int> & reached, std::vector<FluidPool> & pools)
{
  const auto isReached = [&](int slice) { return std::binary_search(reached.begin(), reached.end(), slice); };
  auto       owner = pools.end();
  long       most = 0;
  for (auto pool = pools.begin(); pool != pools.end(); ++pool)
  {
    const auto taken = std::remove_if(pool->slices.begin(), pool->slices.end(), isReached);
    const long count = pool->slices.end() - taken;
    pool->slices.erase(taken, pool->slices.end());
    owner = count > most ? pool : owner;
    most = std::max(most, count);
  }
  return owner;
}
} // namespace

std::array<int, 2>
FillStretch(const std::vector<std::vector<float>> & heights,
            const std::vector<FluidPassage> &       passages,
            const std::vector<bool> &               allowed,
            const std::array<int, 2> &              lengths,
            std::vector<FluidPool> &                pools)
{
  const DipFinder finder(heights, passages, allowed, pools);
  FilledDip       dip;
  for (int length = lengths[1]; dip.reached.empty() && length >= lengths[0]; length -= shorterBy)
  {
    dip = finder.Best(length);
  }
  if (dip.reached.empty())
  {
    return dip.filled;
  }
  auto owner = TakeSlices(dip.reached, pools);
  owner = owner == pools.end() ? pools.insert(owner, FluidPool{}) : owner;
  owner->slices = dip.reached;
  owner->level = dip.level;
  for (FluidPool & pool : pools)
  {
    pool.points = PointsBelow(heights, pool.slices, pool.level);
  }
  owner->bottom = heights[dip.reached.front()].front();
  for (const int slice : dip.reached)
  {
    owner->bottom = std::min(owner->bottom, static_cast<double>(heights[slice].front()));
  }
  return dip.filled;
}
} // namespace shapeton
