#ifndef shapetonColonWallSurface_h
#define shapetonColonWallSurface_h

#include "shapetonColonField.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** The surface where the distance is 0, found on a grid of this spacing (mm) in the box, its vertices moved onto the
 * wall. Works in slabs, so that memory does not grow with the volume. */
SurfaceMesh
ExtractColonWall(const ColonField & field, const Eigen::Vector3d & low, const Eigen::Vector3d & high, double spacing);
} // namespace shapeton

#endif
