#ifndef shapetonGraph_h
#define shapetonGraph_h

#include "GraphModelExport.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** An undirected graph. Loops and multiple edges are allowed; nodes and edges are named by their index.
 * \ingroup GraphModel */
struct Graph
{
  int nodes{ 0 };
  /** The two ends of each edge, in [0, nodes). */
  std::vector<std::array<int, 2>> edges;
  /** Empty, or one for each node. */
  std::vector<std::string> names;
};

/** Throws InputError that begins with `what` (a file name) when the graph has no node, an edge names a node that does
 * not exist, the names are not as many as the nodes, or it is larger than half-edges of type int can number.
 * \ingroup GraphModel */
GraphModel_EXPORT void
RequireSound(const Graph & graph, const std::string & what);

/** The name of a node, or its index as text where the graph has no names. \ingroup GraphModel */
GraphModel_EXPORT std::string
                  NameOfNode(const Graph & graph, int node);

/** The graph with node v renamed to `image[v]`, a permutation, and its edges in the same order. \ingroup GraphModel */
GraphModel_EXPORT Graph
RelabelledGraph(const Graph & graph, const std::vector<int> & image);
} // namespace shapeton

#endif
