#ifndef shapetonGraphTiles_h
#define shapetonGraphTiles_h

#include "shapetonEmbeddedGraph.h"

namespace shapeton
{
/** Closed boundary of the fundamental domain formed by all kites of the lifts of nodes. Empty on the sphere. */
ShapetonGraphViews_EXPORT std::vector<Place>
                          DomainBoundary(const EmbeddedGraph & graph);

/** Deck transformations: the identity, then those with the smallest displacement, at most `count` in all. */
ShapetonGraphViews_EXPORT std::vector<Motion>
                          TilesAround(const EmbeddedGraph & graph, int count);

/** Corners of the fundamental polygon: images of the root of the tree, in the order of the word. Disk and torus
 * only. */
ShapetonGraphViews_EXPORT std::vector<Place>
                          PolygonCorners(const EmbeddedGraph & graph);
} // namespace shapeton

#endif
