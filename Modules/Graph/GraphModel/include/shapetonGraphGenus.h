#ifndef shapetonGraphGenus_h
#define shapetonGraphGenus_h

#include "ShapetonGraphModelExport.h"

#include "shapetonCombinatorialMap.h"
#include "shapetonGenusOptions.h"
#include "shapetonProgress.h"

#include <vector>

namespace shapeton
{
/** Options of FindEmbedding() and its progress callback. \ingroup ShapetonGraphModel */
struct GenusSettings : GenusOptions
{
  /** May throw to abort. */
  Progress progress;
};

/** Result of FindEmbedding(): a rotation system of small genus and a lower bound. \ingroup ShapetonGraphModel */
struct SurfaceEmbedding
{
  CombinatorialMap map;
  /** Lower bound on the genus of any embedding, for each block from planarity and Euler's formula with the lengths of
   * short cycles. The genera of the blocks add up (Battle, Harary, Kodama and Youngs 1962). */
  int lowerBound{ 0 };
  /** Whether the genus of the map equals the lower bound. */
  bool minimal{ false };
};

/** Embeds any graph: disconnected, a tree, a single node, with loops and multiple edges. Planarity is tested first
 * (left-right test, Brandes 2009). Nonplanar blocks, reduced by their nodes of degree two and multiple edges, are then
 * searched by annealed re-insertion of edges. Throws InputError if the graph is invalid, or if no embedding of the
 * requested genus is found; the message states the smallest and largest genus found. Throws ParameterError for an
 * invalid option. Results are bitwise identical for any number of threads. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT SurfaceEmbedding
FindEmbedding(const Graph & graph, const GenusSettings & options = GenusSettings());

/** Computes a planar embedding; returns false if the graph is not planar. Linear time and memory except for sorting the
 * edges: a million nodes take a few seconds. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT bool
FindPlanarEmbedding(const Graph & graph, CombinatorialMap & map);

/** Edges of a maximal planar subgraph, ascending: an edge is kept if it forms a planar graph with the edges kept before
 * it. The subgraph has all nodes and the same components as the graph, but not always the largest possible number of
 * edges. If k of m edges are left out, about k log m planarity tests are needed. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::vector<int>
                          PlanarEdges(const Graph & graph);

/** The graph with only these edges; nodes and names are kept. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT Graph
GraphWithEdges(const Graph & graph, const std::vector<int> & edges);

/** Lower bound on the genus by Euler's formula V - E + F = 2 - 2g for a connected simple graph of minimum degree three:
 * each cycle bounds at most one face, and the numbers of cycles of length 3, 4 and 5 are limited.
 * \ingroup ShapetonGraphModel
 */
ShapetonGraphModel_EXPORT int
GenusLowerBound(const Graph & graph);
} // namespace shapeton

#endif
