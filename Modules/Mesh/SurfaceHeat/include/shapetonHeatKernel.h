#ifndef shapetonHeatKernel_h
#define shapetonHeatKernel_h

#include "shapetonSurfaceSpectrum.h"

namespace shapeton
{
/** \defgroup HeatKernel Heat kernel and derived quantities
 * Computed from all eigenpairs of a spectrum at a time t in mm^2: the solution of du/dt = -M^-1 L u. All functions
 * throw InputError if t is not positive and finite, or if a vertex does not exist. The truncation error decays like
 * exp(-lambda_K t): K pairs are sufficient for times well above 1 / lambda_K. \ingroup ShapetonSurfaceHeat */
///@{
/** K_t(p, q) = sum_i exp(-lambda_i t) phi_i(p) phi_i(q) (5.3): heat at q from a unit source at p (1/mm^2). */
ShapetonSurfaceHeat_EXPORT double
HeatKernel(const SurfaceSpectrum & spectrum, int p, int q, double t);

/** K_t(p, p) for each vertex p (1/mm^2; Sun, Ovsjanikov and Guibas, 2009). */
ShapetonSurfaceHeat_EXPORT Eigen::VectorXd
                           HeatKernelSignature(const SurfaceSpectrum & spectrum, double t);

/** Sample times for a heat kernel signature (mm^2): `number` of them, logarithmically spaced from 4 ln 10 / lambda_K,
 * below which truncation matters, to 4 ln 10 / lambda_1, where heat is uniform (lambda_1 is the first positive
 * eigenvalue; Sun, Ovsjanikov and Guibas, 2009). Throws InputError if the spectrum has fewer than two distinct
 * positive eigenvalues. */
ShapetonSurfaceHeat_EXPORT std::vector<double>
                           HeatKernelSignatureTimes(const SurfaceSpectrum & spectrum, int number);

/** Weight exp(-lambda_K t) of the last pair at time t; the truncation error is of this order. */
ShapetonSurfaceHeat_EXPORT double
ShareOfLastPair(const SurfaceSpectrum & spectrum, double t);

/** L2 distance between the heat distributions of p and q at time t; its square is sum_i exp(-2 lambda_i t) (phi_i(p) -
 * phi_i(q))^2 (5.5) (1/mm). */
ShapetonSurfaceHeat_EXPORT double
DiffusionDistance(const SurfaceSpectrum & spectrum, int p, int q, double t);

/** Distances from p to all vertices. */
ShapetonSurfaceHeat_EXPORT Eigen::VectorXd
                           DiffusionDistances(const SurfaceSpectrum & spectrum, int p, double t);
///@}
} // namespace shapeton

#endif
