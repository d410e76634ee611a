#ifndef shapetonDiffusionTime_h
#define shapetonDiffusionTime_h

#include "shapetonSurfaceConnectivity.h"

#include "HeatDiffusionMetricExport.h"

namespace shapeton
{
/** The mean edge that a surface would have with 55,000 faces, the number of the dissertation; mm. \pre At least one
 * face. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT double
MeanEdgeAt55000Faces(const SurfaceConnectivity & connectivity, const Eigen::VectorXd & edgeLengths);

/** \name Mesh and time of diffusion for a tube, by its narrowest radius r in mm
 * With h the mean edge, noise of the mesh asks for t >= h^2, its shape for t <= 1.3 r^2 (measured on walls of
 * patients). Throw InputError for a radius that is not positive; infinity is allowed where there is no lumen.
 * \ingroup HeatDiffusionMetric */
///@{

/** min(8 min(h, 3 mm)^2, max(0.6 r^2, h^2)), mm^2. At 8 h^2 loops of about 8 edges, the handles, are diffused away
 * ('t = 8' of the dissertation, which gives no unit); beyond 0.6 r^2 the shape of the tube itself begins to go. */
HeatDiffusionMetric_EXPORT double
DefaultDiffusionTime(double meanEdge, double narrowestRadius);

/** h^2 > 1.3 r^2: no time serves the mesh and the shape. */
HeatDiffusionMetric_EXPORT bool
IsTooCoarseForDiffusion(double meanEdge, double narrowestRadius);

/** So many faces that h = min(2 mm, r): area / (0.42 h^2), from 55,000, the number of the dissertation, to 500,000.
 * \param area mm^2. */
HeatDiffusionMetric_EXPORT int
FacesForDiffusion(double area, double narrowestRadius);
///@}

/** Throws InputError unless t is positive and finite. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT void
RequireDiffusionTime(double t);
} // namespace shapeton

#endif
