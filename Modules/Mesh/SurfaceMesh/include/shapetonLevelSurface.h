#ifndef shapetonLevelSurface_h
#define shapetonLevelSurface_h

#include "shapetonSurfaceMesh.h"

#include <array>

namespace shapeton
{
/** The surface on which values on a grid pass a level, by marching cubes (vtkFlyingEdges3D), in units of the grid.
 *
 * It is closed where the outermost layer of values lies on one side of the level. Keep values away from the level:
 * where several edges cross it at one grid point, faces have no area.
 *
 * \param size of the grid, at least 2 along each axis; the first axis runs fastest in `values`, which are only read.
 * \param first the coordinate of the first value along each axis.
 * Throws std::invalid_argument when the sizes disagree. \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceMesh
LevelSurface(std::vector<float> & values, const std::array<int, 3> & size, double level, double first = 0.0);

/** The component that encloses the greatest volume, with its faces outwards. \pre The surface has a face.
 * \ingroup SurfaceMesh */
SurfaceMesh_EXPORT SurfaceMesh
OuterShell(const SurfaceMesh & mesh);
} // namespace shapeton

#endif
