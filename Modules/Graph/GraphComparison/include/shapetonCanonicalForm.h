#ifndef shapetonCanonicalForm_h
#define shapetonCanonicalForm_h

#include "ShapetonGraphComparisonExport.h"
#include "shapetonGraph.h"

#include <vector>

namespace shapeton
{
/** \brief A canonical renumbering of a graph: equal for two graphs if and only if they are isomorphic.
 *
 * Computed by Traces (McKay and Piperno 2014). Loops and multiple edges count with their multiplicity.
 * \ingroup ShapetonGraphComparison */
struct ShapetonGraphComparison_EXPORT CanonicalForm
{
  explicit CanonicalForm(const Graph & original);

  /** Canonical number of each node. */
  std::vector<int> rank;
  /** The renumbered graph; each edge from the lower to the higher node, in ascending order. Names are copied from the
   * original nodes; all other data are equal for isomorphic graphs. */
  Graph graph;
};

/** For each node of `a`, its image in `b`; empty if the graphs are not isomorphic. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::vector<int>
                               Isomorphism(const CanonicalForm & a, const CanonicalForm & b);
} // namespace shapeton

#endif
