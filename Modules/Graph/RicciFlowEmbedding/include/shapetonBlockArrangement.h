#ifndef shapetonBlockArrangement_h
#define shapetonBlockArrangement_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \brief Rearranges the blocks of a map side by side on the same surface, instead of nesting them in small faces.
 *
 * A circle within a face is small, and shrinks further with each level of nesting. Each block keeps the order of its
 * own half-edges. The largest block turns its longest face to the others. Each other block turns the longest face at
 * the node that leads to the largest, and where that face does not meet a node, its longest face there. Blocks
 * interleaved around a node are separated, which can only reduce the genus. Maps with a single block are unchanged.
 * \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT CombinatorialMap
ArrangeBlocks(const CombinatorialMap & map);
} // namespace shapeton

#endif
