#ifndef itkFaceDummies_h
#define itkFaceDummies_h

#include "itkCombinatorialMap.h"

namespace itk
{
/** The dummies of a packed map: which of them stay in the next step. */
class FaceDummies
{
public:
  /** Nodes from `first` on are dummies. */
  FaceDummies(const CombinatorialMap & packed, int first);

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
    return !m_IsGone[dummy] && !m_IsFaceGone[m_Face[dummy]];
  }
  void
  Drop(int dummy)
  {
    m_IsGone[dummy] = 1;
  }
  /** All in the faces of those that half-edges lead to. */
  void
  DropFacesOf(const std::vector<int> & halfEdges)
  {
    for (const int h : halfEdges)
    {
      m_IsFaceGone[m_Face[this->Head(h)]] = 1;
    }
  }

private:
  const CombinatorialMap & m_Packed;
  int                      m_First;
  std::vector<int>         m_Face; ///< of dummies that hang together: the first of them
  std::vector<char>        m_IsGone;
  std::vector<char>        m_IsFaceGone;
};
} // namespace itk

#endif
