#ifndef shapetonCanonicalMapOrder_h
#define shapetonCanonicalMapOrder_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <vector>

namespace shapeton
{
/** \brief A numbering of the nodes of a connected map that its structure determines, but for its symmetries, and not
 * the numbers they came with.
 *
 * A walk in breadth from a half-edge, counter-clockwise around each node, numbers the nodes and writes the map down as
 * a code; the half-edge with the smallest code starts it. Only half-edges of the rarest neighbourhood, by hashes that
 * are refined until one is unique or for 32 rounds, are tried, as many as 2e7 steps allow: a map that has more of them,
 * of several kinds that differ only further away, gets a numbering that may depend on its numbers.
 * \ingroup RicciFlowEmbedding */
struct RicciFlowEmbedding_EXPORT CanonicalMapOrder
{
  /** With `mayMirror` the walks clockwise are tried, too. */
  CanonicalMapOrder(const CombinatorialMap & map, bool mayMirror);

  int              start{ -1 }; ///< half-edge
  bool             isMirrored{ false };
  std::vector<int> rank; ///< of each node
};
} // namespace shapeton

#endif
