#ifndef shapetonRemoveBridges_h
#define shapetonRemoveBridges_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Removes the faces with `bridged` = 1, so that each piece of the lumen becomes a component, open at the tubes. Also
 * removes fragments that contain less than a thousandth of the faces. `rectumLoop` and `cecumLoop` are preserved. */
SurfaceMesh
RemoveBridges(const SurfaceMesh & mesh);
} // namespace shapeton

#endif
