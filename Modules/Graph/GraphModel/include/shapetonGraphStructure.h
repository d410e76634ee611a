#ifndef shapetonGraphStructure_h
#define shapetonGraphStructure_h

#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** The half-edges that leave each node, in ascending order, in one array: those of node v are
 * halfEdges[start[v]] ... halfEdges[start[v + 1] - 1]. Half-edge 2e leaves edges[e][0], 2e + 1 edges[e][1].
 * \ingroup GraphModel */
struct GraphModel_EXPORT Incidence
{
  explicit Incidence(const Graph & graph);

  int
  Degree(int node) const
  {
    return start[node + 1] - start[node];
  }

  std::vector<int> start;
  std::vector<int> halfEdges;
};

/** A part of a graph as a graph of its own. \ingroup GraphModel */
struct Subgraph
{
  Graph graph;
  /** Of the whole graph: each node and each edge of the part, ascending. */
  std::vector<int> nodes;
  std::vector<int> edges;
};

/** The connected components, in the order of their smallest nodes. \ingroup GraphModel */
GraphModel_EXPORT std::vector<Subgraph>
                  ConnectedComponents(const Graph & graph);

/** The blocks (maximal 2-connected parts, bridges, loops), as the edges of each one in ascending order. Each edge is in
 * one block; a node without edges in none. Of the order of the smallest edges. \ingroup GraphModel */
GraphModel_EXPORT std::vector<std::vector<int>>
                  BlocksOf(const Graph & graph);

/** The graph of these edges and of their nodes alone. \ingroup GraphModel */
GraphModel_EXPORT Subgraph
SubgraphOfEdges(const Graph & graph, const std::vector<int> & edges);

/** For each edge the first one with the same ends, in whichever order; -1 for a loop. \ingroup GraphModel */
GraphModel_EXPORT std::vector<int>
                  FirstParallels(const Graph & graph);

/** Length of a shortest cycle: 1 with a loop, 2 with a multiple edge, 0 in a forest. Breadth-first searches from all
 * nodes, cut off at half the best length; none after a cycle of 3 in a simple graph. \ingroup GraphModel */
GraphModel_EXPORT int
Girth(const Graph & graph);
} // namespace shapeton

#endif
