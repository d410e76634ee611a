#ifndef shapetonColonBridges_h
#define shapetonColonBridges_h

#include "shapetonColonWall.h"

namespace shapeton
{
/** Adds the same bridges to another field on the same grid. */
OccupancyImage::ConstPointer
DrawBridges(const OccupancyImage * occupancy, const BridgedOccupancy & bridges);

/** For each face 1 where a tube rather than the given lumen forms the wall. `lumen` is the field without tubes; it may
 * be null without tubes. */
SurfaceArray
BridgedFaces(const SurfaceMesh & mesh, const BridgedOccupancy & bridges, const OccupancyImage * lumen);
} // namespace shapeton

#endif
