#ifndef shapetonSurfaceDiffusion_h
#define shapetonSurfaceDiffusion_h

#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** Smooths each column of `values` (one row per vertex) by heat flow over the surface for `time` (mm^2), from 0. Uses
 * two implicit steps, (M + time/2 L) x' = M x, with one factorization. An eigenfunction with eigenvalue k is damped by
 * (1 + k time/2)^2, compared to exp(k time) for the heat equation. Results are bitwise reproducible for any number of
 * threads. Throws InputError for values that are not finite or if the factorization fails, and ParameterError for a
 * wrong number of rows or a negative time. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT void
DiffuseOverSurface(const SurfaceLaplacian & laplacian,
                   double                   time,
                   Eigen::MatrixXd &        values,
                   const Progress &         progress = {});
} // namespace shapeton

#endif
