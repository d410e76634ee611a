#ifndef shapetonCanonicalMapOrder_h
#define shapetonCanonicalMapOrder_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

#include <vector>

namespace shapeton
{
/** \brief A node numbering of a connected map determined by its structure, up to symmetries, independent of the given
 * numbering.
 *
 * A breadth-first search from a half-edge, counter-clockwise around each node, numbers the nodes and defines a code of
 * the map; the half-edge with the smallest code is the start. Only half-edges with the rarest neighborhood are tried.
 * Neighborhoods are compared by hashes, refined until one is unique or for 32 rounds. Beyond a limit of 2e7 steps the
 * numbering may depend on the input. \ingroup ShapetonRicciFlowEmbedding */
struct ShapetonRicciFlowEmbedding_EXPORT CanonicalMapOrder
{
  /** With `mayMirror`, also tries clockwise walks. */
  CanonicalMapOrder(const CombinatorialMap & map, bool mayMirror);

  int              start{ -1 }; ///< half-edge
  bool             isMirrored{ false };
  std::vector<int> rank; ///< rank of each node
};
} // namespace shapeton

#endif
