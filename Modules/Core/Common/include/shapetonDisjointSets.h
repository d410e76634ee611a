#ifndef shapetonDisjointSets_h
#define shapetonDisjointSets_h

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace shapeton
{
/** \class DisjointSets
 * \brief Disjoint sets of the numbers 0, 1, ... (union-find).
 *
 * Each set is represented by one of its members. After Join() the representative is the smallest member, so labels
 * derived from it do not depend on the order of the joins. Uses path halving: logarithmic amortized time.
 *
 * \ingroup ShapetonCommon */
template <typename TIndex = int>
class DisjointSets
{
public:
  /** Each number is initially a separate set. */
  explicit DisjointSets(std::size_t number = 0) : m_Parents(number)
  {
    std::iota(m_Parents.begin(), m_Parents.end(), TIndex{ 0 });
  }

  /** Adds the next number as a separate set. */
  TIndex
  Add()
  {
    m_Parents.push_back(static_cast<TIndex>(m_Parents.size()));
    return m_Parents.back();
  }

  /** The representative of the set that contains `member`. */
  TIndex
  Find(TIndex member)
  {
    while (m_Parents[member] != member)
    {
      member = m_Parents[member] = m_Parents[m_Parents[member]];
    }
    return member;
  }

  /** Merges two sets; the smaller representative represents the union. Returns whether the sets were
   * distinct. */
  bool
  Join(TIndex a, TIndex b)
  {
    a = this->Find(a);
    b = this->Find(b);
    m_Parents[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  /** Merges two sets; the representative of `keeper` represents the union. Returns whether the sets were distinct. */
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
