#ifndef shapetonFaceDummies_h
#define shapetonFaceDummies_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** Dummies of a packed map, and which of them are kept in the next step. */
class FaceDummies
{
public:
  /** Nodes from index `first` are dummies. */
  FaceDummies(const CombinatorialMap & packed, int first)
    : m_Packed(packed), m_First(first), m_IsGone(packed.Nodes(), 0), m_IsTaken(packed.Nodes(), 0)
  {}

  bool
  IsDummy(int node) const
  {
    return node >= m_First;
  }
  /** Node at the end of a half-edge of the packed map. */
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
  /** Whether the dummy is kept and not on the path of an edge. */
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
  /** Reserves the dummy for the path of an edge. */
  void
  Take(int dummy)
  {
    m_IsTaken[dummy] = 1;
  }
  /** Removes the dummies at the ends of half-edges, except those on the path of an edge. */
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
  /** All neighbors of removed dummies. */
  void
  DropNeighbors();

private:
  const CombinatorialMap & m_Packed;
  int                      m_First;
  std::vector<char>        m_IsGone;
  std::vector<char>        m_IsTaken;
};
} // namespace shapeton

#endif
