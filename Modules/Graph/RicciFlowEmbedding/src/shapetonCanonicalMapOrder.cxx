#include "shapetonCanonicalMapOrder.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cstdint>

namespace shapeton
{
namespace
{
constexpr int          roundsAtOnce = 4;             // of refinement between two counts; chosen
constexpr int          mostRounds = 32;              // of refinement; chosen
constexpr std::int64_t mostStepsOfSearch = 20000000; // chosen; bounds the time

std::uint64_t
Mix(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/** A half-edge and a direction of rotation. */
struct Start
{
  int  halfEdge;
  bool isMirrored;
};

/** Hashes of the neighborhoods of half-edges. */
class Neighborhoods
{
public:
  Neighborhoods(const CombinatorialMap & map, bool isMirrored)
    : m_Map(map), m_IsMirrored(isMirrored), m_Hash(map.HalfEdges())
  {
    const std::vector<int> degrees = map.Degrees();
    const std::vector<int> lengths = map.FaceLengths();
    for (int h = 0; h < map.HalfEdges(); ++h)
    {
      const int left = isMirrored ? CombinatorialMap::Twin(h) : h;
      m_Hash[h] = Mix((static_cast<std::uint64_t>(degrees[map.Node(h)]) << 32) + lengths[map.Face(left)]);
    }
  }
  void
  Refine()
  {
    std::vector<std::uint64_t> next(m_Hash.size());
    ParallelForBlocks(m_Hash.size(), [&](std::size_t i) {
      constexpr std::uint64_t ofTwin = 7;
      const int               h = static_cast<int>(i);
      const int               turned = m_IsMirrored ? m_Map.PreviousAround(h) : m_Map.NextAround(h);
      next[i] = Mix(m_Hash[i] + 3 * Mix(m_Hash[turned] + 1) + ofTwin * Mix(m_Hash[CombinatorialMap::Twin(h)] + 2));
    });
    m_Hash.swap(next);
  }
  const std::vector<std::uint64_t> &
  Hashes() const
  {
    return m_Hash;
  }

private:
  const CombinatorialMap &   m_Map;
  bool                       m_IsMirrored;
  std::vector<std::uint64_t> m_Hash;
};

/** The least frequent hash; ties go to the smallest one. */
std::uint64_t
RarestHash(const std::vector<Neighborhoods> & senses, std::size_t & occurrences)
{
  std::vector<std::uint64_t> all;
  for (const Neighborhoods & sense : senses)
  {
    all.insert(all.end(), sense.Hashes().begin(), sense.Hashes().end());
  }
  std::sort(all.begin(), all.end());
  std::uint64_t rarest = 0;
  occurrences = all.size() + 1;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end)
  {
    while (end < all.size() && all[end] == all[begin])
    {
      ++end;
    }
    if (end - begin < occurrences)
    {
      occurrences = end - begin;
      rarest = all[begin];
    }
  }
  return rarest;
}

std::vector<Start>
RarestStarts(const CombinatorialMap & map, bool mayMirror)
{
  std::vector<Neighborhoods> senses{ Neighborhoods(map, false) };
  if (mayMirror)
  {
    senses.emplace_back(map, true);
  }
  std::size_t   occurrences = 0;
  std::uint64_t rarest = 0;
  for (int round = 0; round < mostRounds && occurrences != 1; round += roundsAtOnce)
  {
    for (int i = 0; i < roundsAtOnce; ++i)
    {
      for (Neighborhoods & sense : senses)
      {
        sense.Refine();
      }
    }
    rarest = RarestHash(senses, occurrences);
  }
  std::vector<Start> starts;
  for (int h = 0; h < map.HalfEdges(); ++h)
  {
    for (std::size_t sense = 0; sense < senses.size(); ++sense)
    {
      if (senses[sense].Hashes()[h] == rarest)
      {
        starts.push_back({ h, sense == 1 });
      }
    }
  }
  return starts;
}

/** Computes the code of a map from one start. */
class Coder
{
public:
  explicit Coder(const CombinatorialMap & map) : m_Map(map), m_Rank(map.Nodes()), m_Arrival(map.Nodes()) {}

  /** Replaces `code` if it is empty or the code from this start is smaller. */
  bool
  Improve(const Start & start, std::vector<int> & code)
  {
    std::fill(m_Rank.begin(), m_Rank.end(), -1);
    m_Known = 0;
    std::vector<int> own;
    bool             isSmaller = code.empty();
    this->Meet(start.halfEdge);
    for (int i = 0; i < m_Known; ++i)
    {
      int h = m_Arrival[i];
      do
      {
        const int twin = CombinatorialMap::Twin(h);
        this->Meet(twin);
        own.push_back(m_Rank[m_Map.Node(twin)]);
        if (!isSmaller)
        {
          const int other = code[own.size() - 1];
          if (own.back() > other)
          {
            return false;
          }
          isSmaller = own.back() < other;
        }
        h = start.isMirrored ? m_Map.PreviousAround(h) : m_Map.NextAround(h);
      } while (h != m_Arrival[i]);
      own.push_back(-1); // end of the node
      if (!isSmaller && code[own.size() - 1] != -1)
      {
        isSmaller = true;
      }
    }
    if (isSmaller)
    {
      code.swap(own);
    }
    return isSmaller;
  }
  const std::vector<int> &
  Ranks() const
  {
    return m_Rank;
  }

private:
  /** Numbers the node of a half-edge; the traversal of the node starts at that half-edge. */
  void
  Meet(int halfEdge)
  {
    int & rank = m_Rank[m_Map.Node(halfEdge)];
    if (rank < 0)
    {
      rank = m_Known++;
      m_Arrival[rank] = halfEdge;
    }
  }

  const CombinatorialMap & m_Map;
  std::vector<int>         m_Rank;
  std::vector<int>         m_Arrival; ///< arrival half-edge of the node of each rank
  int                      m_Known{ 0 };
};
} // namespace

CanonicalMapOrder::CanonicalMapOrder(const CombinatorialMap & map, bool mayMirror) : rank(map.Nodes(), 0)
{
  Coder            coder(map);
  std::vector<int> code;
  std::int64_t     steps = 0;
  for (const Start & candidate : RarestStarts(map, mayMirror))
  {
    if (steps > mostStepsOfSearch)
    {
      break;
    }
    steps += map.HalfEdges();
    if (coder.Improve(candidate, code))
    {
      start = candidate.halfEdge;
      isMirrored = candidate.isMirrored;
      rank = coder.Ranks();
    }
  }
}
} // namespace shapeton
