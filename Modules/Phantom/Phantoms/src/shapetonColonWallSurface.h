#ifndef shapetonColonWallSurface_h
#define shapetonColonWallSurface_h

#include "shapetonColonField.h"
#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Extracts the zero level of the distance on a grid with this spacing (mm) in the box and projects its vertices onto
 * the wall. Processes slabs to limit memory. */
SurfaceMesh
ExtractColonWall(const ColonField & field, const Eigen::Vector3d & low, const Eigen::Vector3d & high, double spacing);
} // namespace shapeton

#endif
