#ifndef shapetonLevelSurface_h
#define shapetonLevelSurface_h

#include "shapetonSurfaceMesh.h"

#include <array>

namespace shapeton
{
/** Isosurface of values on a grid, by marching cubes (vtkFlyingEdges3D), in grid units.
 *
 * The surface is closed if the outermost layer of values is on one side of the level. Avoid values equal or close to
 * the level: if several edges cross it at one grid point, faces have zero area.
 *
 * \param size of the grid, at least 2 along each axis; the first axis runs fastest in `values`, which are not modified.
 * \param first coordinate of the first value along each axis.
 * Throws std::invalid_argument if the sizes disagree. \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
LevelSurface(std::vector<float> & values, const std::array<int, 3> & size, double level, double first = 0.0);

/** The component with the largest enclosed volume, faces oriented outward. \pre The surface has a face.
 * \ingroup ShapetonSurfaceMesh */
ShapetonSurfaceMesh_EXPORT SurfaceMesh
OuterShell(const SurfaceMesh & mesh);
} // namespace shapeton

#endif
