#ifndef shapetonGraph_h
#define shapetonGraph_h

#include "ShapetonGraphModelExport.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace shapeton
{
/** An undirected graph. Loops and multiple edges are allowed; nodes and edges are identified by index.
 * \ingroup ShapetonGraphModel */
struct Graph
{
  int nodes{ 0 };
  /** The two ends of each edge, in [0, nodes). */
  std::vector<std::array<int, 2>> edges;
  /** Empty, or one name per node. */
  std::vector<std::string> names;
};

/** Throws InputError with the prefix `what` (a file name) if the graph has no nodes, an edge has an invalid node, the
 * numbers of names and nodes differ, or there are more half-edges than int can count. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT void
RequireSound(const Graph & graph, const std::string & what);

/** Throws InputError with the prefix `what` if an edge has an invalid node. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT void
RequireEnds(const Graph & graph, const std::string & what);

/** Maximum number of bytes of a node name quoted in a message. \ingroup ShapetonGraphModel */
constexpr std::size_t LongestName = 60;

/** Name of a node, or its index as text if the graph has no names. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::string
                          NameOfNode(const Graph & graph, int node);

/** The graph with node v renumbered to `image[v]`, a permutation; the edge order is kept. \ingroup ShapetonGraphModel
 */
ShapetonGraphModel_EXPORT Graph
RelabeledGraph(const Graph & graph, const std::vector<int> & image);
} // namespace shapeton

#endif
