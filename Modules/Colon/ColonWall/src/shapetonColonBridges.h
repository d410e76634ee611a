#ifndef shapetonColonBridges_h
#define shapetonColonBridges_h

#include "shapetonColonWall.h"

namespace shapeton
{
/** For each face 1 where the tubes and not the given lumen make the wall. `lumen` is the field before the tubes came.
 */
SurfaceArray
BridgedFaces(const SurfaceMesh & mesh, const BridgedOccupancy & bridges, const OccupancyImage * lumen);
} // namespace shapeton

#endif
