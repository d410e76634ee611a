#ifndef shapetonDisjointSets_h
#define shapetonDisjointSets_h

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shapeton
{
/** \class DisjointSets
 * \brief Sets of the numbers 0, 1, ... that are joined two by two (union-find).
 *
 * Each set is known by one of its members. After Join() it is the least one, whatever the order of the joins, so
 * numbers and labels that follow from it are the same for any order. Paths are halved: logarithmic amortised time.
 *
 * \ingroup Base */
template <typename TIndex = int>
class DisjointSets
{
public:
  /** Each number a set of its own. */
  explicit DisjointSets(std::size_t number = 0) : m_Parents(number)
  {
    std::iota(m_Parents.begin(), m_Parents.end(), TIndex{ 0 });
  }

  /** The next number as a set of its own. */
  TIndex
  Add()
  {
    m_Parents.push_back(static_cast<TIndex>(m_Parents.size()));
    return m_Parents.back();
  }

  /** The member that stands for the set of this one. */
  TIndex
  Find(TIndex member)
  {
    while (m_Parents[member] != member)
    {
      member = m_Parents[member] = m_Parents[m_Parents[member]];
    }
    return member;
  }

  /** The lesser one of the two members that stood for the sets stands for both. Whether they have been apart. */
  bool
  Join(TIndex a, TIndex b)
  {
    a = this->Find(a);
    b = this->Find(b);
    m_Parents[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  /** The member that stood for the set of `keeper` stands for both. Whether they have been apart. */
  bool
  Absorb(TIndex keeper, TIndex other)
  {
    keeper = this->Find(keeper);
    other = this->Find(other);
    m_Parents[other] = keeper;
    return keeper != other;
  }

private:
  std::vector<TIndex> m_Parents;
};
} // namespace shapeton

#endif
