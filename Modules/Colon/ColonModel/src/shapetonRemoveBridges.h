#ifndef shapetonRemoveBridges_h
#define shapetonRemoveBridges_h

#include "shapetonSurfaceMesh.h"

namespace shapeton
{
/** Removes the faces with `bridged` = 1: each piece of the lumen becomes a component, open at the tubes. Fragments of
 * less than a thousandth of the faces are removed, too. `rectumLoop` and `cecumLoop` keep their points. */
SurfaceMesh
RemoveBridges(const SurfaceMesh & mesh);
} // namespace shapeton

#endif
