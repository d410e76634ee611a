#ifndef shapetonRadixQueue_h
#define shapetonRadixQueue_h

#include "shapetonInterruption.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace shapeton
{
/** A monotone priority queue (Ahuja, Mehlhorn, Orlin, Tarjan 1990): the bucket index of a key is the highest bit in
 * which it differs from the last key popped. Keys are non-negative doubles, compared by bit pattern. */
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
    m_Interruption.Check();
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
  static constexpr int KeyBits = 64; ///< of Entry::key

  static int
  BucketOf(std::uint64_t difference)
  {
    return difference == 0 ? 0 : KeyBits - __builtin_clzll(difference);
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
    // Reuse the memory for the next entries of this bucket.
    entries.clear();
    entries.swap(m_Buckets[full]);
  }

  std::array<std::vector<Entry>, KeyBits + 1> m_Buckets;
  std::uint64_t                               m_Last{ 0 };
  std::size_t                                 m_Size{ 0 };
  RareInterruption                            m_Interruption;
};
} // namespace shapeton

#endif
