#include "shapetonFluidBasins.h"

#include "shapetonDisjointSets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using Heights = std::vector<std::vector<float>>;

// Slices connected by fluid below `ceiling`, with two parts if divided by a ridge of that height.
struct Basin
{
  std::vector<int> slices;
  int              parts[2]{ -1, -1 };
  double           ridge{ 0.0 };
};

class BasinTree
{
public:
  BasinTree(const Heights & heights, std::vector<FluidPassage> passages, std::size_t smallest)
    : m_Heights(heights), m_Smallest(smallest), m_Sets(heights.size()), m_BasinOf(heights.size(), -1)
  {
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      if (!heights[i].empty())
      {
        m_BasinOf[i] = static_cast<int>(m_Basins.size());
        m_Basins.push_back({ { static_cast<int>(i) } });
      }
    }
    std::stable_sort(passages.begin(), passages.end(), [](const FluidPassage & a, const FluidPassage & b) {
      return a.height < b.height;
    });
    for (const auto & passage : passages)
    {
      this->Join(passage.a, passage.b, passage.height);
    }
    this->JoinPieces();
  }

  // The root basin of all slices.
  int
  Root() const
  {
    return m_Root;
  }
  const Basin &
  Get(int basin) const
  {
    return m_Basins[basin];
  }

private:
  // Parts below the minimum volume do not create a ridge.
  void
  Join(int sliceA, int sliceB, double height)
  {
    const int a = m_Sets.Find(sliceA);
    const int b = m_Sets.Find(sliceB);
    if (a == b)
    {
      return;
    }
    const int  basinA = m_BasinOf[a];
    const int  basinB = m_BasinOf[b];
    const bool divides = PointsBelow(m_Heights, m_Basins[basinA].slices, height) >= m_Smallest &&
                         PointsBelow(m_Heights, m_Basins[basinB].slices, height) >= m_Smallest;
    m_Sets.Absorb(a, b);
    if (divides)
    {
      Basin both;
      both.slices = m_Basins[basinA].slices;
      both.slices.insert(both.slices.end(), m_Basins[basinB].slices.begin(), m_Basins[basinB].slices.end());
      both.parts[0] = basinA;
      both.parts[1] = basinB;
      both.ridge = height;
      m_BasinOf[a] = static_cast<int>(m_Basins.size());
      m_Basins.push_back(std::move(both));
      return;
    }
    this->Absorb(a, basinA, basinB, height);
  }

  // The slices of the smaller basin are assigned to the larger one, at each level of its subdivision that they touch,
  // since only fluid above the larger basin's ridges reaches them.
  void
  Absorb(int representative, int basinA, int basinB, double height)
  {
    const bool aIsLarger = PointsBelow(m_Heights, m_Basins[basinA].slices, height) >=
                           PointsBelow(m_Heights, m_Basins[basinB].slices, height);
    const int larger = aIsLarger ? basinA : basinB;
    const int smaller = aIsLarger ? basinB : basinA;
    m_Basins[larger].slices.insert(
      m_Basins[larger].slices.end(), m_Basins[smaller].slices.begin(), m_Basins[smaller].slices.end());
    m_BasinOf[representative] = larger;
  }

  // Disconnected pieces, for example at a collapsed stretch.
  void
  JoinPieces()
  {
    int first = -1;
    for (std::size_t i = 0; i < m_Heights.size(); ++i)
    {
      if (!m_Heights[i].empty() && first < 0)
      {
        first = static_cast<int>(i);
      }
      else if (!m_Heights[i].empty())
      {
        this->Join(first, static_cast<int>(i), std::numeric_limits<float>::max());
      }
    }
    m_Root = first < 0 ? -1 : m_BasinOf[m_Sets.Find(first)];
  }

  const Heights &    m_Heights;
  std::size_t        m_Smallest;
  DisjointSets<>     m_Sets;
  std::vector<int>   m_BasinOf; // for representatives
  std::vector<Basin> m_Basins;
  int                m_Root{ -1 };
};

FluidPool
FillPool(const Heights & heights, const std::vector<int> & slices, std::size_t points)
{
  std::vector<float> all;
  for (const int slice : slices)
  {
    all.insert(all.end(), heights[slice].begin(), heights[slice].end());
  }
  const auto bottom = *std::min_element(all.begin(), all.end());
  const auto nth = all.begin() + static_cast<std::ptrdiff_t>(std::min(points, all.size() - 1));
  std::nth_element(all.begin(), nth, all.end());
  const double level = points >= all.size() ? *nth + 100.0 : *nth;
  return { slices, level, bottom, points };
}

// Distributes the fluid of a basin to its two parts, each up to the ridge.
void
Fill(const BasinTree &        tree,
     const Heights &          heights,
     int                      index,
     std::size_t              points,
     PhantomRandom &          random,
     std::vector<FluidPool> & pools)
{
  if (points == 0)
  {
    return;
  }
  const Basin &     basin = tree.Get(index);
  const bool        divided = basin.parts[0] >= 0;
  const std::size_t roomA = divided ? PointsBelow(heights, tree.Get(basin.parts[0]).slices, basin.ridge) : 0;
  const std::size_t roomB = divided ? PointsBelow(heights, tree.Get(basin.parts[1]).slices, basin.ridge) : 0;
  if (!divided || points > roomA + roomB)
  {
    pools.push_back(FillPool(heights, basin.slices, points));
    return;
  }
  const double odds = std::exp(random.Uniform(-0.9, 0.9)) * static_cast<double>(roomA) / static_cast<double>(roomB);
  const auto   wanted = static_cast<std::size_t>(static_cast<double>(points) * odds / (1.0 + odds));
  const auto   least = points > roomB ? points - roomB : 0;
  const auto   pointsA = std::clamp(wanted, least, std::min(points, roomA));
  Fill(tree, heights, basin.parts[0], pointsA, random, pools);
  Fill(tree, heights, basin.parts[1], points - pointsA, random, pools);
}
} // namespace

std::size_t
PointsBelow(const Heights & heights, const std::vector<int> & slices, double level)
{
  std::size_t points = 0;
  for (const int slice : slices)
  {
    const auto & sorted = heights[slice];
    points += std::lower_bound(sorted.begin(), sorted.end(), static_cast<float>(level)) - sorted.begin();
  }
  return points;
}

std::vector<FluidPool>
FillBasins(const Heights &           heights,
           std::vector<FluidPassage> passages,
           std::size_t               points,
           std::size_t               smallestBasin,
           PhantomRandom &           random)
{
  std::vector<FluidPool> pools;
  const BasinTree        tree(heights, std::move(passages), smallestBasin);
  if (tree.Root() >= 0)
  {
    Fill(tree, heights, tree.Root(), points, random, pools);
  }
  return pools;
}
} // namespace shapeton
