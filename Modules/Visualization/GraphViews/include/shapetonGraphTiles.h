#ifndef shapetonGraphTiles_h
#define shapetonGraphTiles_h

#include "shapetonEmbeddedGraph.h"

namespace shapeton
{
/** The boundary of the fundamental domain that is made of all kites of the lifts of nodes; closed. Empty on the sphere.
 */
GraphViews_EXPORT std::vector<Place>
                  DomainBoundary(const EmbeddedGraph & graph);

/** Deck transformations: the identity, then those that move the domain least, at most `count` in all. */
GraphViews_EXPORT std::vector<Motion>
                  TilesAround(const EmbeddedGraph & graph, int count);

/** The corners of the fundamental polygon: images of the root of the tree, side by side along the word. Disk and torus.
 */
GraphViews_EXPORT std::vector<Place>
                  PolygonCorners(const EmbeddedGraph & graph);
} // namespace shapeton

#endif
