#ifndef shapetonUnionFind_h
#define shapetonUnionFind_h

#include <numeric>
#include <vector>

namespace shapeton
{
/** Disjoint sets; the least member stands for each, so results do not depend on the order of the unions. */
class UnionFind
{
public:
  explicit UnionFind(std::size_t number) : m_Parent(number) { std::iota(m_Parent.begin(), m_Parent.end(), 0U); }

  unsigned int
  Find(unsigned int i)
  {
    while (m_Parent[i] != i)
    {
      m_Parent[i] = m_Parent[m_Parent[i]];
      i = m_Parent[i];
    }
    return i;
  }
  void
  Unite(unsigned int i, unsigned int j)
  {
    i = this->Find(i);
    j = this->Find(j);
    (i < j ? m_Parent[j] : m_Parent[i]) = i < j ? i : j;
  }

private:
  std::vector<unsigned int> m_Parent;
};
} // namespace shapeton

#endif
