#ifndef shapetonRemoveBridges_h
#define shapetonRemoveBridges_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** The surface without its faces with `bridged` = 1: each piece of the lumen is a component, open where the tubes were.
 * Crumbs of less than a thousandth of the faces go, too. `rectumLoop` and `caecumLoop` name the same points as before.
 */
SurfaceMesh
RemoveBridges(const SurfaceMesh & mesh);
} // namespace shapeton

#endif
