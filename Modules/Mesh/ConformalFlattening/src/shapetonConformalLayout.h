#ifndef shapetonConformalLayout_h
#define shapetonConformalLayout_h

#include "shapetonConformalMap.h"

namespace shapeton
{
/** Faces with all three corners on one side of a quadrilateral. */
std::vector<int>
EarsOfSides(const FaceMatrix & F, const QuadrilateralMap & map);

/** Flat surfaces as documented in ConformalMap::flat. */
SurfaceMesh
LayOutRectangle(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const QuadrilateralMap & map);
SurfaceMesh
LayOutStrip(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SlitMap & map);
SurfaceMesh
LayOutAnnulus(const SurfaceMesh & mesh, const SurfaceConnectivity & connectivity, const SlitMap & map);

/** Adds the arrays slitMap1, slitMap2, ... */
void
AddSlitMaps(const std::vector<SlitMap> & maps, SurfaceMesh & flat);
} // namespace shapeton

#endif
