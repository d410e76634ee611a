#ifndef shapetonBlockArrangement_h
#define shapetonBlockArrangement_h

#include "ShapetonRicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \brief Rearranges the blocks of a map side by side on the same surface, instead of nesting them in small faces.
 *
 * A circle within a face is small, and shrinks further with each level of nesting. Each block keeps the order of its
 * half-edges. The outer face of the largest block is its longest face. The outer face of any other block is the longest
 * face at the node that connects it to the largest block; at nodes not on that face, the longest face at the node is
 * used. Blocks interleaved around a node are separated, which can only reduce the genus. Maps with a single block are
 * unchanged.
 * \ingroup ShapetonRicciFlowEmbedding */
ShapetonRicciFlowEmbedding_EXPORT CombinatorialMap
ArrangeBlocks(const CombinatorialMap & map);
} // namespace shapeton

#endif
