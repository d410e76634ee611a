#ifndef shapetonMapBuilder_h
#define shapetonMapBuilder_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** A map to which nodes and edges are added. \ingroup RicciFlowEmbedding */
class MapBuilder
{
public:
  explicit MapBuilder(const CombinatorialMap & map);

  int
  AddNode()
  {
    return m_Nodes++;
  }
  int
  Nodes() const
  {
    return m_Nodes;
  }
  int
  Node(int halfEdge) const
  {
    return m_Edges[halfEdge / 2][halfEdge % 2];
  }
  /** Adds an edge that is at no place around its nodes yet; returns the half-edge that leaves the first one. */
  int
  AddEdge(int from, int to);
  /** Puts a half-edge counter-clockwise after another one of the same node. */
  void
  InsertAfter(int halfEdge, int added);
  /** Makes these half-edges, counter-clockwise, all there are around their node. */
  void
  SetAround(const std::vector<int> & halfEdges);
  /** Divides an edge into so many: returns the half-edges of the path, the first of them 2 edge. */
  std::vector<int>
  Divide(int edge, int parts);
  CombinatorialMap
  Build() const;

private:
  void
  Replace(int halfEdge, int by);

  int                             m_Nodes;
  std::vector<std::array<int, 2>> m_Edges;
  std::vector<int>                m_Next;
  std::vector<int>                m_Previous;
};
} // namespace shapeton

#endif
