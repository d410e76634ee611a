#ifndef shapetonSurfaceDiffusion_h
#define shapetonSurfaceDiffusion_h

#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** Lets heat flow over a surface for `time` mm^2, from 0: each column of `values` (a row for each vertex) is smoothed
 * in two implicit steps, (M + time/2 L) x' = M x, by one factorisation: a smoothing, by which an eigenfunction of the
 * eigenvalue k loses the factor (1 + k time/2)^2, where the heat equation has exp(k time). Equal input gives equal
 * bytes for any number of threads. Throws InputError where the matrix cannot be factorised, std::invalid_argument for a
 * wrong number of rows or a negative time. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT void
DiffuseOverSurface(const SurfaceLaplacian & laplacian,
                   double                   time,
                   Eigen::MatrixXd &        values,
                   const Progress &         progress = {});
} // namespace shapeton

#endif
