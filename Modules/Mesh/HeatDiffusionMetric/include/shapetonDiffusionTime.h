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

/** The time of diffusion for a tube, min(8 h^2, 0.6 r^2) mm^2, with h = MeanEdgeAt55000Faces() and r the narrowest
 * radius of the lumen in mm. At 8 h^2 loops of about 8 edges, the handles, are diffused away ('t = 8' of the
 * dissertation, which gives no unit); beyond 0.6 r^2 the shape of the tube itself goes. It does not depend on how
 * finely the surface is meshed. Throws InputError for a radius that is not positive; infinity is allowed where there is
 * no lumen. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT double
DefaultDiffusionTime(const SurfaceConnectivity & connectivity,
                     const Eigen::VectorXd &     edgeLengths,
                     double                      narrowestRadius);

/** Throws InputError unless t is positive and finite. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT void
RequireDiffusionTime(double t);
} // namespace shapeton

#endif
