#ifndef shapetonCarriedPacking_h
#define shapetonCarriedPacking_h

#include "GraphComparisonExport.h"
#include "shapetonPackedMap.h"

namespace shapeton
{
/** Of the steps of a dynamic graph: faces with more than six half-edges are filled with dummies whether they need them
 * or not, so that later edges find a way there. \ingroup GraphComparison */
GraphComparison_EXPORT AugmentationOptions
FilledFaces();

/** \brief The packed map of a graph that has changed, with the dummies of the step before where they can stay.
 *
 * Circles far from a change hardly move when the packed map changes in few places alone. Made anew, the dummies of a
 * long face all change with one of its edges, and two faces that an edge has parted become one that takes far more room
 * than both. So, first, the dummies of faces that lose an edge stay, and hold nodes of edges that are gone in their
 * places; where a part of the graph has turned over or changed its face, those beside it go, and if the others do not
 * fit then, those beside these. Then new edges are added. One whose ends a single dummy parts takes its place. Another
 * one becomes a path along the fewest dummies (PackedMap::subdivided), and nothing moves: its ends, which would have to
 * come from far, do not touch, their circles and those of the dummies between them do. Each time faces in conflict and
 * long ones are filled as MakePackedMap() does it, which all of the map is left to with loops or parallel edges.
 *
 * Nodes are the same by their names. \pre `packed` is a packed map of `before`, `map` a map of `after`.
 * \ingroup GraphComparison */
GraphComparison_EXPORT PackedMap
CarryPackedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map);
} // namespace shapeton

#endif
