#ifndef itkCarriedPacking_h
#define itkCarriedPacking_h

#include "GraphComparisonExport.h"
#include "itkPackedMap.h"

namespace itk
{
/** \brief The packed map of a graph that has changed, with the dummies of the step before where they can stay.
 *
 * Circles far from a change hardly move when the packed map changes in few places alone. Made anew, the dummies of a
 * long face all change with one of its edges, and two faces that an edge has parted become one that takes far more room
 * than both. So the dummies of faces that lose an edge stay, and hold nodes of edges that are gone in their places. A
 * new edge takes the place of the fewest dummies between its ends. Where the order around a node has become another one
 * all dummies of the faces there go. Faces in conflict are filled then as MakePackedMap() does it, which all of the map
 * is left to with loops or parallel edges.
 *
 * Nodes are the same by their names. \pre `packed` is a packed map of `before`, `map` a map of `after`. \ingroup
 * GraphComparison */
GraphComparison_EXPORT PackedMap
CarryPackedMap(const Graph & before, const PackedMap & packed, const Graph & after, const CombinatorialMap & map);
} // namespace itk

#endif
