#ifndef shapetonGraphStructure_h
#define shapetonGraphStructure_h

#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** Outgoing half-edges of each node, ascending, in one array: node v has the elements start[v] to
 * start[v + 1] - 1 of halfEdges. Half-edge 2e starts at edges[e][0], 2e + 1 at edges[e][1].
 * \ingroup ShapetonGraphModel */
struct ShapetonGraphModel_EXPORT Incidence
{
  /** Throws InputError if an edge has an invalid node. */
  explicit Incidence(const Graph & graph);

  int
  Degree(int node) const
  {
    return start[node + 1] - start[node];
  }

  std::vector<int> start;
  std::vector<int> halfEdges;
};

/** A subgraph with its node and edge indices in the whole graph. \ingroup ShapetonGraphModel */
struct Subgraph
{
  Graph graph;
  /** For each node and each edge of the part, its index in the whole graph; ascending. */
  std::vector<int> nodes;
  std::vector<int> edges;
};

/** Connected components, sorted by their lowest nodes. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::vector<Subgraph>
                          ConnectedComponents(const Graph & graph);

/** Blocks (maximal 2-connected parts, bridges, loops), as ascending lists of edges, sorted by their lowest edges. Each
 * edge is in one block; a node without edges is in none. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::vector<std::vector<int>>
                          BlocksOf(const Graph & graph);

/** The subgraph of these edges and their nodes. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT Subgraph
SubgraphOfEdges(const Graph & graph, const std::vector<int> & edges);

/** For each edge, the first edge with the same ends, in any order; -1 for a loop. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::vector<int>
                          FirstParallels(const Graph & graph);

/** Length of a shortest cycle: 1 with a loop, 2 with a multiple edge, 0 in a forest. Breadth-first searches from all
 * nodes, cut off at half the best length; stops at a cycle of length 3 in a simple graph.
 * \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT int
Girth(const Graph & graph);
} // namespace shapeton

#endif
