#ifndef shapetonDiffusionTime_h
#define shapetonDiffusionTime_h

#include "shapetonSurfaceConnectivity.h"

#include "ShapetonSurfaceHeatExport.h"

namespace shapeton
{
/** Mean edge length (mm) that the surface would have with 55,000 faces, the number used in the dissertation. \pre At
 * least one face.
 * \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT double
MeanEdgeAt55000Faces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths);

/** \name Mesh and diffusion time for a tube with the smallest radius r in mm
 * With mean edge length h, mesh noise requires t >= h^2 and shape preservation t <= 1.3 r^2 (measured on patient
 * walls). Throw InputError if the radius is not positive; infinity is allowed if there is no lumen.
 * \ingroup ShapetonSurfaceHeat */
///@{

/** min(8 min(h, 3 mm)^2, max(0.6 r^2, h^2)), mm^2. At 8 h^2, loops of about 8 edges (the handles) are smoothed away ('t
 * = 8' of the dissertation, given without a unit). Beyond 0.6 r^2 the shape of the tube itself degrades. */
ShapetonSurfaceHeat_EXPORT double
DefaultDiffusionTime(double meanEdge, double narrowestRadius);

/** h^2 > 1.3 r^2: no time satisfies both conditions. */
ShapetonSurfaceHeat_EXPORT bool
IsTooCoarseForDiffusion(double meanEdge, double narrowestRadius);

/** Number of faces for h = min(2 mm, r): area / (0.42 h^2), limited to the range from 55,000 (the number used in the
 * dissertation) to 500,000.
 * \param area mm^2. */
ShapetonSurfaceHeat_EXPORT int
FacesForDiffusion(double area, double narrowestRadius);
///@}

/** Throws InputError unless t is positive and finite. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT void
RequireDiffusionTime(double t);
} // namespace shapeton

#endif
