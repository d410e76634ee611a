#ifndef shapetonSplitArrangement_h
#define shapetonSplitArrangement_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \brief The same graph on the same surface with the parts between two nodes reordered: larger parts closer to the
 * middle.
 *
 * If at least three faces share two nodes of a block, the two nodes split the block into as many components (an edge
 * between them counts as one). Any order of the components is an embedding. If the circles of the two nodes touch, the
 * components are side by side as between two parallel lines, and circle sizes decrease as 1 / x^2 with the position x
 * from the middle. Therefore the component with the most nodes is placed in the middle, the next ones on both sides of
 * it, and edges at the end. This order or its reverse is used, whichever has less uniform face lengths: one long face
 * is better than many nested ones.
 *
 * Nonplanar blocks and maps without such nodes are unchanged. Worst-case time is quadratic: for each pair of nodes all
 * others are counted. \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT CombinatorialMap
ArrangeSplitComponents(const CombinatorialMap & map);
} // namespace shapeton

#endif
