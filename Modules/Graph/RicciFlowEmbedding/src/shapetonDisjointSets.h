#ifndef shapetonDisjointSets_h
#define shapetonDisjointSets_h

#include <numeric>
#include <vector>

namespace shapeton
{
/** Sets of numbers that are joined. */
class DisjointSets
{
public:
  explicit DisjointSets(int number) : m_Parent(number) { std::iota(m_Parent.begin(), m_Parent.end(), 0); }

  /** Whether they have been apart. */
  bool
  Join(int a, int b)
  {
    a = this->Find(a);
    b = this->Find(b);
    m_Parent[a] = b;
    return a != b;
  }

private:
  int
  Find(int i)
  {
    while (m_Parent[i] != i)
    {
      i = m_Parent[i] = m_Parent[m_Parent[i]];
    }
    return i;
  }
  std::vector<int> m_Parent;
};
} // namespace shapeton

#endif
