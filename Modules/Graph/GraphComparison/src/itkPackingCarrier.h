#ifndef itkPackingCarrier_h
#define itkPackingCarrier_h

#include "itkPackedMap.h"

namespace itk
{
/** What lies between two half-edges that both steps have, one after the other around a node; or all around a node that
 * has none. */
struct Stretch
{
  std::vector<int> dummies;     ///< half-edges of the old packed map that lead to dummies
  std::vector<int> added;       ///< half-edges of the new graph
  int              place{ -1 }; ///< in the list of dummies: of the one that makes room for the added half-edge
};

/** Carries dummies over, see CarryPackedMap(). `packed` has no divided edges, `after` neither loops nor parallel edges.
 */
class PackingCarrier
{
public:
  PackingCarrier(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map);

  /** The new graph, and the dummies that stay, as a map. */
  CombinatorialMap
  Build() const;

private:
  bool
  IsDummy(int oldNode) const
  {
    return oldNode >= m_OldNodes;
  }
  /** Whether a dummy stays. */
  bool
  Stays(int dummy) const
  {
    return !m_IsGone[dummy] && !m_IsGone[m_Region[dummy]];
  }
  int
  OldHead(int oldHalfEdge) const
  {
    return m_Old.Node(CombinatorialMap::Twin(oldHalfEdge));
  }
  void
  MatchHalfEdges(const Graph & before);
  void
  FindRegions();
  void
  FindStretches();
  void
  AddLoneNode(int node);
  int
  AddStretch(int start, int oldStart, int node);
  void
  PlaceAddedEdges();
  bool
  HasDummies(int stretch) const;
  bool
  MakeRoom(int halfEdge);
  bool
  MakeRoomForLeaf(Stretch & stretch);
  bool
  MakeRoomBetween(Stretch & from, Stretch & to);
  std::vector<int>
  ShortestPath(const Stretch & from, const Stretch & to) const;
  void
  DropRegionsOf(const Stretch & stretch);
  void
  NumberDummies();
  void
  Append(int stretch, std::vector<int> & order) const;
  std::vector<int>
  OrderOfNode(int node) const;
  std::vector<int>
  OrderOfDummy(int dummy) const;

  const CombinatorialMap & m_Old;
  int                      m_OldNodes;
  const Graph &            m_After;
  const CombinatorialMap & m_Map;
  std::vector<int>         m_NodeOf;      ///< new numbers of old nodes, in the end of dummies, too; -1: gone
  std::vector<int>         m_HalfEdgeOf;  ///< the same of half-edges
  std::vector<int>         m_OldHalfEdge; ///< of those of m_Map; -1 for new ones
  std::vector<int>         m_OldNode;
  std::vector<Stretch>     m_Stretches;   ///< those that are not empty
  std::vector<int>         m_StretchOf;   ///< the one after an old half-edge of m_Map, or around a new one; -1: none
  std::vector<int>         m_LoneStretch; ///< of nodes whose half-edges are all new
  std::vector<int>         m_Region;      ///< of dummies that hang together: the first of them
  std::vector<char>        m_IsGone;      ///< single dummies, and regions by their first ones
  Graph                    m_Graph;       ///< the new graph, then the dummies that stay
};
} // namespace itk

#endif
