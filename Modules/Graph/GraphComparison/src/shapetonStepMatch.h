#ifndef shapetonStepMatch_h
#define shapetonStepMatch_h

#include "shapetonPackedMap.h"

namespace shapeton
{
/** What the packed map of one step of a dynamic graph and the map of the next one share. A node without an edge that
 * both have counts as a new one, unless it has no edges at all: it comes to its new neighbours, not they to it. */
struct StepMatch
{
  StepMatch(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map);

  /** Numbers there of what is here, -1 for what is not there. */
  std::vector<int> nodeOf;      ///< of nodes of `before`
  std::vector<int> oldNode;     ///< of nodes of `after`
  std::vector<int> halfEdgeOf;  ///< of half-edges of `packed`
  std::vector<int> oldHalfEdge; ///< of half-edges of `map`
};
} // namespace shapeton

#endif
