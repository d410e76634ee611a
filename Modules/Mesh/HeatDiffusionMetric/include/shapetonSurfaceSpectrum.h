#ifndef shapetonSurfaceSpectrum_h
#define shapetonSurfaceSpectrum_h

#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** The smoothest eigenfunctions of a surface: L phi = lambda M phi. \ingroup HeatDiffusionMetric */
struct SurfaceSpectrum
{
  /** Ascending from 0 on; 1/mm^2. */
  Eigen::VectorXd eigenvalues;
  /** In columns, phi^T M phi = 1 (1/mm). Of one sign each: the component of largest magnitude is positive. */
  Eigen::MatrixXd eigenfunctions;
  /** Of each pair: the norm of M^-1/2 (L phi - lambda M phi), relative to the largest eigenvalue asked for. */
  Eigen::VectorXd residuals;

  int
  NumberOfPairs() const
  {
    return static_cast<int>(eigenvalues.size());
  }
};

/** When the iteration of ComputeSurfaceSpectrum() ends: residual of an eigenpair relative to the largest one, and
 * restarts. \ingroup HeatDiffusionMetric */
struct SurfaceSpectrumOptions
{
  double tolerance{ 1e-10 };
  int    restarts{ 300 };
  /** After each step of the iteration. It may throw in order to abort. */
  Progress progress;
};

/** The `pairs` smallest eigenpairs by shift and invert: implicitly restarted Lanczos (Spectra) on a sparse Cholesky
 * factorisation, or a dense decomposition where the surface has few vertices. It starts from a fixed vector, so the
 * same surface gives the same bytes. Eigenfunctions of a multiple eigenvalue are some basis of their space. Memory:
 * about 40 bytes for each vertex and pair while it runs. Throws InputError where `pairs` is not in [1, vertices], or it
 * does not converge. \ingroup HeatDiffusionMetric */
HeatDiffusionMetric_EXPORT SurfaceSpectrum
ComputeSurfaceSpectrum(const SurfaceLaplacian & laplacian, int pairs, const SurfaceSpectrumOptions & options = {});
} // namespace shapeton

#endif
