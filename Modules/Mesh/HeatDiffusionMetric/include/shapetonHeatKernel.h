#ifndef shapetonHeatKernel_h
#define shapetonHeatKernel_h

#include "shapetonSurfaceSpectrum.h"

namespace shapeton
{
/** \defgroup HeatKernel Heat kernel and what is derived from it
 * From the eigenpairs of a spectrum, all of them, at a time t in mm^2: the solution of du/dt = -M^-1 L u. Each throws
 * InputError for a t that is not positive and finite and for a vertex that there is not. What the missing pairs would
 * contribute decays like exp(-lambda_K t): a spectrum of K pairs serves times well above 1 / lambda_K.
 * \ingroup HeatDiffusionMetric */
///@{
/** K_t(p, q) = sum_i exp(-lambda_i t) phi_i(p) phi_i(q) (5.3): heat at q of a unit source at p; 1/mm^2. */
HeatDiffusionMetric_EXPORT double
HeatKernel(const SurfaceSpectrum & spectrum, int p, int q, double t);

/** K_t(p, p) for each vertex p; 1/mm^2 (Sun, Ovsjanikov and Guibas, 2009). */
HeatDiffusionMetric_EXPORT Eigen::VectorXd
                           HeatKernelSignature(const SurfaceSpectrum & spectrum, double t);

/** Times that a heat kernel signature is worth to be looked at, mm^2: `number` of them, even in the logarithm, from 4
 * ln 10 / lambda_K, below which the missing pairs count, to 4 ln 10 / lambda_1, where all is even (lambda_1 the first
 * one above 0; Sun, Ovsjanikov and Guibas, 2009). Throws InputError where the spectrum has fewer than two distinct
 * eigenvalues above 0. */
HeatDiffusionMetric_EXPORT std::vector<double>
                           HeatKernelSignatureTimes(const SurfaceSpectrum & spectrum, int number);

/** The share that the last pair has still at the time t, exp(-lambda_K t): what a sum over the pairs leaves out is of
 * this order. */
HeatDiffusionMetric_EXPORT double
ShareOfLastPair(const SurfaceSpectrum & spectrum, double t);

/** The L2 distance of the heats that p and q have sent out by the time t; its square is sum_i exp(-2 lambda_i t)
 * (phi_i(p) - phi_i(q))^2 (5.5); 1/mm. */
HeatDiffusionMetric_EXPORT double
DiffusionDistance(const SurfaceSpectrum & spectrum, int p, int q, double t);

/** The distances from p to all vertices. */
HeatDiffusionMetric_EXPORT Eigen::VectorXd
                           DiffusionDistances(const SurfaceSpectrum & spectrum, int p, double t);
///@}
} // namespace shapeton

#endif
