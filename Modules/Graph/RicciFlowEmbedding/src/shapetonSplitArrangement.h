#ifndef shapetonSplitArrangement_h
#define shapetonSplitArrangement_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \brief The same graph on the same surface with the parts between two nodes in another order: the larger a part, the
 * nearer to the middle.
 *
 * Where three faces or more share two nodes of a block, these divide it into as many split components (an edge between
 * the two is one), and any order of them is an embedding. If the circles of the two nodes touch, the others lie side by
 * side between them as between two parallel lines, and the one at place x from the middle has circles as 1 / x^2. So
 * the largest, in nodes, comes into the middle, the next ones to both sides of it, and edges to the end. Of this order
 * and its reverse the one with the more uneven lengths of faces is taken: one long face is better than many within each
 * other.
 *
 * Blocks that are not planar, and maps without such nodes, stay as they are. Time is quadratic at worst: for each pair
 * of nodes all others are counted. \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT CombinatorialMap
ArrangeSplitComponents(const CombinatorialMap & map);
} // namespace shapeton

#endif
