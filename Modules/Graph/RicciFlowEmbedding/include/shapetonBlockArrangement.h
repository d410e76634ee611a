#ifndef shapetonBlockArrangement_h
#define shapetonBlockArrangement_h

#include "RicciFlowEmbeddingExport.h"
#include "shapetonCombinatorialMap.h"

namespace shapeton
{
/** \brief The same graph on the same surface with its blocks side by side, not one within a small face of another.
 *
 * A circle within a face is small, one within a face of a block within a face smaller still. Each block keeps the order
 * of its own half-edges. The largest block turns its longest face to the others, each other one the longest face at the
 * node that leads to the largest, and where that does not come to a node its longest face there. Blocks that were mixed
 * up around a node are parted, which can only make the genus smaller. Maps of one block stay as they are.
 * \ingroup RicciFlowEmbedding */
RicciFlowEmbedding_EXPORT CombinatorialMap
ArrangeBlocks(const CombinatorialMap & map);
} // namespace shapeton

#endif
