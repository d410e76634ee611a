#ifndef shapetonCarriedRotation_h
#define shapetonCarriedRotation_h

#include "GraphComparisonExport.h"
#include "shapetonGraphGenus.h"

#include <vector>

namespace shapeton
{
/** For each node of `a` that of `b` with the same name, or -1. \ingroup GraphComparison */
GraphComparison_EXPORT std::vector<int>
                       NodesOfSameName(const Graph & a, const Graph & b);

/** For each edge of `a` an edge of `b` between the images of its ends, or -1; of parallel edges each has its own, in
 * order. `image` is -1 for nodes that `b` lacks. \ingroup GraphComparison */
GraphComparison_EXPORT std::vector<int>
                       EdgesOfSameEnds(const Graph & a, const Graph & b, const std::vector<int> & image);

/** A rotation system that was carried over to a changed graph. \ingroup GraphComparison */
struct CarriedRotation
{
  CombinatorialMap map;
  /** No part of the old rotation system was kept, for a new one has a smaller genus; it is turned to the side that
   * agrees with the old one in more places. */
  bool embeddedAnew{ false };
};

/** \brief The rotation system of a graph that has changed: nodes are the same by their names.
 *
 * Edges that are gone are taken out, orders of the others stay. A new edge is put into a face that has both of its ends
 * where there is one, a new node into the face that has most of its neighbours. Only when no edge can be put in that
 * way one costs a handle. When that made the genus rise, an embedding is sought anew, with its blocks arranged, and
 * taken if its genus is smaller; one that has handles gives them up when the graph is planar. \pre `map` is one of
 * `before`. \ingroup GraphComparison */
GraphComparison_EXPORT CarriedRotation
CarryRotation(const Graph &            before,
              const CombinatorialMap & map,
              const Graph &            after,
              const GenusOptions &     options = GenusOptions());
} // namespace shapeton

#endif
