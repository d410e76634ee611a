#ifndef shapetonColonBridges_h
#define shapetonColonBridges_h

#include "shapetonColonWall.h"

namespace shapeton
{
/** Adds the same bridges to another field on the same grid. */
OccupancyImage::ConstPointer
DrawBridges(const OccupancyImage * occupancy, const BridgedOccupancy & bridges);

/** 1 for each face on a tube rather than on the given lumen. `lumen` is the field before tubes were added; it may be
 * null if there are no tubes. */
SurfaceArray
BridgedFaces(const SurfaceMesh & mesh, const BridgedOccupancy & bridges, const OccupancyImage * lumen);
} // namespace shapeton

#endif
