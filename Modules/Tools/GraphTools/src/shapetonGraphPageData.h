#ifndef shapetonGraphPageData_h
#define shapetonGraphPageData_h

#include "shapetonGraphPictures.h"
#include "shapetonJson.h"

namespace shapeton
{
/** What the scripts of a page know of a graph: places and radii of nodes (dummies have places only) and faces, halves
 * of edges from a node to where circles touch, the dual, tiles. Coordinates stand one after the other. */
Json
PageDataOf(const GraphView & view);
} // namespace shapeton

#endif
