#ifndef shapetonColonBridges_h
#define shapetonColonBridges_h

#include "shapetonColonWall.h"

namespace shapeton
{
/** The same bridges in another field on the grid of the one that they were found for. */
OccupancyImage::ConstPointer
DrawBridges(const OccupancyImage * occupancy, const BridgedOccupancy & bridges);

/** For each face 1 where the tubes and not the given lumen make the wall. `lumen` is the field before the tubes came;
 * it may be null where there are none. */
SurfaceArray
BridgedFaces(const SurfaceMesh & mesh, const BridgedOccupancy & bridges, const OccupancyImage * lumen);
} // namespace shapeton

#endif
