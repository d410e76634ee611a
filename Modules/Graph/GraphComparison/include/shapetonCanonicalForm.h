#ifndef shapetonCanonicalForm_h
#define shapetonCanonicalForm_h

#include "GraphComparisonExport.h"
#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** \brief A graph renumbered so that isomorphic graphs, and they alone, become the same.
 *
 * Labelled by Traces (McKay and Piperno 2014). Loops and multiple edges count: as many in the one graph as in the
 * other. \ingroup GraphComparison */
struct GraphComparison_EXPORT CanonicalForm
{
  explicit CanonicalForm(const Graph & original);

  /** The canonical number of each node. */
  std::vector<int> rank;
  /** With these numbers; each edge from the smaller to the greater one, in ascending order. The names are those of the
   * original nodes; all else is equal for isomorphic graphs. */
  Graph graph;
};

/** For each node of `a` that of `b`; empty when the graphs are not isomorphic. \ingroup GraphComparison */
GraphComparison_EXPORT std::vector<int>
                       Isomorphism(const CanonicalForm & a, const CanonicalForm & b);
} // namespace shapeton

#endif
