#ifndef shapetonCarriedRotation_h
#define shapetonCarriedRotation_h

#include "ShapetonGraphComparisonExport.h"
#include "shapetonGraphGenus.h"

#include <vector>

namespace shapeton
{
/** For each node of `a`, the node of `b` with the same name, or -1. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::vector<int>
                               NodesOfSameName(const Graph & a, const Graph & b);

/** For each edge of `a`, an edge of `b` between the images of its ends, or -1; parallel edges are matched in order.
 * `image` is -1 for nodes missing in `b`. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT std::vector<int>
                               EdgesOfSameEnds(const Graph & a, const Graph & b, const std::vector<int> & image);

/** A rotation system transferred to a changed graph. \ingroup ShapetonGraphComparison */
struct CarriedRotation
{
  CombinatorialMap map;
  /** Whether the rotation system was recomputed for a smaller genus; it is then mirrored if the mirror image agrees
   * with the old one in more places. */
  bool embeddedAnew{ false };
};

/** \brief The rotation system of a changed graph; nodes are identified by name.
 *
 * Deleted edges are removed; the order of the other edges is kept. A new edge is inserted into a face with both of its
 * ends if possible, a new node into the face with most of its neighbors. A handle is added only if no edge can be
 * inserted otherwise. If the genus rises, a new embedding with arranged blocks is computed and used if its genus is
 * smaller; an embedding with handles is replaced if the graph is planar. \pre `map` is a map of `before`.
 * \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT CarriedRotation
CarryRotation(const Graph &            before,
              const CombinatorialMap & map,
              const Graph &            after,
              const GenusSettings &    options = GenusSettings());
} // namespace shapeton

#endif
