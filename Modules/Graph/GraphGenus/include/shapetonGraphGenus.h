#ifndef shapetonGraphGenus_h
#define shapetonGraphGenus_h

#include "GraphGenusExport.h"

#include "shapetonCombinatorialMap.h"
#include "shapetonProgress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shapeton
{
/** Effort and target for FindEmbedding(). \ingroup GraphGenus */
struct GenusOptions
{
  /** The genus of the surface, summed over the components; -1 asks for the smallest that is found. */
  int           genus{ -1 };
  std::uint64_t seed{ 1 };
  /** Independent searches for each block, of which the best is taken; at least 1. */
  int restarts{ 12 };
  /** Multiplies the number of steps of a search; > 0. There is no limit in time: equal options give equal results. */
  double effort{ 1.0 };
  /** It may throw in order to abort. */
  Progress progress;
};

/** A rotation system of small genus and a lower bound of the genus. See FindEmbedding(). \ingroup GraphGenus */
struct SurfaceEmbedding
{
  CombinatorialMap map;
  /** No embedding has a smaller genus: planarity, and Euler's formula with the lengths of short cycles, for each block.
   * Genera of blocks add up (Battle, Harary, Kodama and Youngs 1962). */
  int lowerBound{ 0 };
  /** The genus of the map is the lower bound. */
  bool minimal{ false };
};

/** Embeds a graph, whatever it is: disconnected, a tree, one node, with loops and multiple edges. Planarity is tested
 * first (left-right test, Brandes 2009); then each block that is not planar is searched, without nodes of degree two
 * and multiple edges, by annealed re-insertion of its edges. Throws InputError
 * when the graph is unsound, or when no embedding of the genus that was asked for is found, with the smallest and
 * greatest genus that were. ParameterError for a wrong option. Same bytes for any number of threads.
 * \ingroup GraphGenus */
GraphGenus_EXPORT SurfaceEmbedding
FindEmbedding(const Graph & graph, const GenusOptions & options = GenusOptions());

/** A planar embedding; false when the graph is not planar. Time and memory are linear but for a sort of the edges: a
 * million nodes take a few seconds. \ingroup GraphGenus */
GraphGenus_EXPORT bool
FindPlanarEmbedding(const Graph & graph, CombinatorialMap & map);

/** A lower bound of the genus by Euler's formula V - E + F = 2 - 2g of a connected simple graph whose nodes have three
 * neighbours or more: a cycle bounds one face at most, and there are only so many of the lengths 3, 4 and 5.
 * \ingroup GraphGenus */
GraphGenus_EXPORT int
GenusLowerBound(const Graph & graph);
} // namespace shapeton

#endif
