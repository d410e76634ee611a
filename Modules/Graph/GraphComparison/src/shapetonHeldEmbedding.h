#ifndef shapetonHeldEmbedding_h
#define shapetonHeldEmbedding_h

#include "shapetonIncrementalMap.h"

namespace shapeton
{
/** The side of `fresh` whose orders agree with `carried` in more places. */
CombinatorialMap
TurnedTo(const IncrementalMap & carried, const CombinatorialMap & fresh);

/** Embeds all edges of a map of the sphere, some of which are not put in: near the ends of those parts turn over or
 * move to other faces, while the corners elsewhere are held. They are held by wheels, whose rims have a node for each;
 * the region without wheels grows until the graph has a planar embedding. False when no corner could be held. */
bool
EmbedHeld(const IncrementalMap & map, CombinatorialMap & embedded);
} // namespace shapeton

#endif
