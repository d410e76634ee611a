#ifndef shapetonHeldEmbedding_h
#define shapetonHeldEmbedding_h

#include "shapetonIncrementalMap.h"

namespace shapeton
{
/** `fresh` or its mirror image, whichever agrees with `carried` in more places. */
CombinatorialMap
TurnedTo(const IncrementalMap & carried, const CombinatorialMap & fresh);

/** Embeds all edges of a map of the sphere, including those not yet inserted. Near their ends parts may flip or move to
 * other faces; corners elsewhere are held by wheels with a rim node for each corner. The region without wheels grows
 * until the graph has a planar embedding. Returns false if no corner could be fixed. */
bool
EmbedHeld(const IncrementalMap & map, CombinatorialMap & embedded);
} // namespace shapeton

#endif
