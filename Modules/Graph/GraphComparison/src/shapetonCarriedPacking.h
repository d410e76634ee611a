#ifndef shapetonCarriedPacking_h
#define shapetonCarriedPacking_h

#include "ShapetonGraphComparisonExport.h"
#include "shapetonPackedMap.h"

namespace shapeton
{
/** Options for dynamic graphs: faces with more than six half-edges are always filled with dummies, through which later
 * edges can be routed. \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT AugmentationOptions
FilledFaces();

/** \brief The packed map of a changed graph that reuses dummies of the previous step where possible.
 *
 * Circles far from a change hardly move if the packed map changes only locally. With new dummies, a single new edge
 * changes all dummies of a long face, and two faces merged by a deleted edge need far more room than before. Therefore
 * dummies of faces with a deleted edge are kept at first, which fixes the positions of the edge's nodes. Where a part
 * of the graph flipped or moved to another face, adjacent dummies are removed, and then their neighbors until the rest
 * fits. Then new edges are added. An edge whose ends are separated by a single dummy replaces it. Any other edge
 * becomes a path along the fewest dummies (PackedMap::subdivided). No circle moves: the end circles do not touch, but
 * the circles along the path do. Faces in conflict and long faces are then filled as in MakePackedMap(), which handles
 * the whole map if it has loops. If few edges are deleted, each one between remaining nodes is replaced by a column of
 * small dummies, which keeps its ends close.
 *
 * Nodes are identified by name. \pre `packed` is a packed map of `before`, `map` a map of `after`.
 * \ingroup ShapetonGraphComparison */
ShapetonGraphComparison_EXPORT PackedMap
CarryPackedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map);
} // namespace shapeton

#endif
