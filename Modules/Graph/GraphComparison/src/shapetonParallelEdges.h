#ifndef shapetonParallelEdges_h
#define shapetonParallelEdges_h

#include "shapetonPackedMap.h"

namespace shapeton
{
/** A graph without parallel edges, and its packed map. */
struct PackedGraph
{
  Graph     graph;
  PackedMap packed;
};

/** Makes a graph without loops simple: each further edge between two nodes gets a node in its middle, whose name is the
 * same in each step. Middle nodes follow the nodes of the graph, and second halves of their edges follow its edges. */
class ParallelEdges
{
public:
  explicit ParallelEdges(const Graph & graph);

  const Graph &
  Simple() const
  {
    return m_Simple;
  }
  /** The map of the simple graph. */
  CombinatorialMap
  Simple(const CombinatorialMap & map) const;
  /** A packed map of the graph as one of the simple graph: the first dummy of each path is its middle node. */
  PackedMap
  Simple(const PackedMap & packed) const;
  /** A packed map of the simple graph as one of the graph. */
  PackedMap
  Restored(PackedMap packed) const;

private:
  int              m_Nodes;
  int              m_Edges;
  std::vector<int> m_Parallel; ///< edges with middle nodes, ascending
  Graph            m_Simple;
};
} // namespace shapeton

#endif
