#ifndef shapetonMapBuilder_h
#define shapetonMapBuilder_h

#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** Builds a map by adding nodes and edges. \ingroup ShapetonRicciFlowEmbedding */
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
  /** Adds an edge without inserting it into the node orders; returns the half-edge from the first node. */
  int
  AddEdge(int from, int to);
  /** Inserts a half-edge counter-clockwise after another one of the same node. */
  void
  InsertAfter(int halfEdge, int added);
  /** Sets these half-edges, counter-clockwise, as the complete order around their node. */
  void
  SetAround(const std::vector<int> & halfEdges);
  /** Subdivides an edge into the given number of edges. Returns the half-edges of the path; the first is 2 edge. */
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
