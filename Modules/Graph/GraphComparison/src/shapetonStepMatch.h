#ifndef shapetonStepMatch_h
#define shapetonStepMatch_h

#include "shapetonPackedMap.h"

namespace shapeton
{
/** Common elements of the packed map of one step of a dynamic graph and the map of the next one. A node without common
 * edges counts as new, so that it moves to its new neighbors; isolated nodes do not count as new. */
struct StepMatch
{
  StepMatch(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map);

  /** Indices in the other step, or -1 if missing there. */
  std::vector<int> nodeOf;      ///< indexed by nodes of `before`
  std::vector<int> oldNode;     ///< indexed by nodes of `after`
  std::vector<int> halfEdgeOf;  ///< indexed by half-edges of `packed`
  std::vector<int> oldHalfEdge; ///< indexed by half-edges of `map`
};
} // namespace shapeton

#endif
