#ifndef shapetonSurfaceDiffusion_h
#define shapetonSurfaceDiffusion_h

#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** Lets heat flow over a surface for `time` mm^2, from 0: each column of `values` (a row for each vertex) is smoothed
 * in two implicit steps, (M + time/2 L) x' = M x, by conjugate gradients down to a residual of `tolerance` times the
 * right hand side. The system is near diagonal, and a factorisation would take as much memory as the surface many times
 * over. Columns are solved by the threads of ITK's global default; equal input gives equal bytes for any number. Throws
 * InputError where the solver fails, std::invalid_argument for a wrong number of rows or a negative time.
 * \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT void
DiffuseOverSurface(const SurfaceLaplacian & laplacian, double time, Eigen::MatrixXd & values, double tolerance = 1e-10);
} // namespace shapeton

#endif
