#ifndef shapetonGraphPageData_h
#define shapetonGraphPageData_h

#include "shapetonGraphPictures.h"
#include "shapetonJson.h"

namespace shapeton
{
/** Data of a graph for the page scripts: positions and radii of nodes (dummies have positions only) and faces, half
 * edges from a node to the tangency point of its circle, the dual, tiles. Coordinates are stored consecutively. */
Json
PageDataOf(const GraphView & view);
} // namespace shapeton

#endif
