#ifndef shapetonFaceDummies_h
#define shapetonFaceDummies_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** The dummies of a packed map: which of them stay in the next step. */
class FaceDummies
{
public:
  /** Nodes from `first` on are dummies. */
  FaceDummies(const CombinatorialMap & packed, int first)
    : m_Packed(packed), m_First(first), m_IsGone(packed.Nodes(), 0), m_IsTaken(packed.Nodes(), 0)
  {}

  bool
  IsDummy(int node) const
  {
    return node >= m_First;
  }
  /** Where a half-edge of the packed map leads. */
  int
  Head(int halfEdge) const
  {
    return m_Packed.Node(CombinatorialMap::Twin(halfEdge));
  }
  bool
  Stays(int dummy) const
  {
    return !m_IsGone[dummy];
  }
  /** Stays, and is on no edge's way. */
  bool
  IsFree(int dummy) const
  {
    return this->Stays(dummy) && !m_IsTaken[dummy];
  }
  void
  Drop(int dummy)
  {
    m_IsGone[dummy] = 1;
  }
  /** For the way of an edge. */
  void
  Take(int dummy)
  {
    m_IsTaken[dummy] = 1;
  }
  /** Those that half-edges lead to, but for what is on an edge's way. */
  void
  DropHeads(const std::vector<int> & halfEdges)
  {
    for (const int h : halfEdges)
    {
      if (!m_IsTaken[this->Head(h)])
      {
        this->Drop(this->Head(h));
      }
    }
  }
  /** All that are beside one that has gone. */
  void
  DropNeighbours();

private:
  const CombinatorialMap & m_Packed;
  int                      m_First;
  std::vector<char>        m_IsGone;
  std::vector<char>        m_IsTaken;
};
} // namespace shapeton

#endif
