#ifndef shapetonSurfaceSpectrum_h
#define shapetonSurfaceSpectrum_h

#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"

namespace shapeton
{
/** The lowest eigenpairs of a surface: L phi = lambda M phi. \ingroup ShapetonSurfaceHeat */
struct SurfaceSpectrum
{
  /** Eigenvalues, ascending from 0 (1/mm^2). */
  Eigen::VectorXd eigenvalues;
  /** Eigenfunctions in columns, phi^T M phi = 1 (1/mm). Sign convention: the component of largest magnitude is
   * positive. */
  Eigen::MatrixXd eigenfunctions;
  /** Residual of each pair: the norm of M^-1/2 (L phi - lambda M phi), relative to the largest requested eigenvalue. */
  Eigen::VectorXd residuals;

  int
  NumberOfPairs() const
  {
    return static_cast<int>(eigenvalues.size());
  }
};

/** Stopping criteria of ComputeSurfaceSpectrum(): residual relative to the largest eigenvalue, and number of restarts.
 * \ingroup ShapetonSurfaceHeat */
struct SurfaceSpectrumOptions
{
  double tolerance{ 1e-10 };
  int    restarts{ 300 };
  /** Called after each iteration step. May throw to abort. */
  Progress progress;
};

/** Computes the `pairs` smallest eigenpairs by shift-and-invert: implicitly restarted Lanczos (Spectra) with a sparse
 * Cholesky factorization, or a dense decomposition for small surfaces. The start vector is fixed, so results are
 * bitwise reproducible. Eigenfunctions of a multiple eigenvalue are an arbitrary basis of their eigenspace. Peak
 * memory: about 40 bytes per vertex and pair. Throws InputError if `pairs` is not in [1, vertices], or if the
 * iteration does not converge. \ingroup ShapetonSurfaceHeat */
ShapetonSurfaceHeat_EXPORT SurfaceSpectrum
ComputeSurfaceSpectrum(const SurfaceLaplacian & laplacian, int pairs, const SurfaceSpectrumOptions & options = {});
} // namespace shapeton

#endif
