#ifndef shapetonColonWallSurface_h
#define shapetonColonWallSurface_h

#include "shapetonColonField.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** The zero level of the distance, extracted on a grid of this spacing (mm) in the box, its vertices projected onto
 * the wall. Works in slabs, so that memory does not grow with the volume. */
SurfaceMesh
ExtractColonWall(const ColonField & field, const Eigen::Vector3d & low, const Eigen::Vector3d & high, double spacing);
} // namespace shapeton

#endif
