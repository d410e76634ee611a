#ifndef shapetonHarmonicSolver_h
#define shapetonHarmonicSolver_h

#include "ShapetonConformalFlatteningExport.h"

#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonSymbolicFactorization.h"

#include <memory>

namespace shapeton
{
/** \class HarmonicSolver
 * \brief Functions on a surface with given values at some vertices and a given Laplacian at the others.
 *
 * Solves (L x)_i = source_i at the free vertices i, x = given at the fixed ones; boundaries without fixed vertices are
 * natural (Neumann). With source 0 this is the harmonic extension of the fixed values. L is factorized once by
 * SparseCholesky and reused for all right-hand sides. Results are bitwise reproducible.
 *
 * \ingroup ShapetonConformalFlattening
 */
class ShapetonConformalFlattening_EXPORT HarmonicSolver
{
public:
  /** Throws InputError if a fixed vertex does not exist or is repeated, a component of the surface has no fixed vertex
   * (the solution would not be unique), or the factorization fails. */
  HarmonicSolver(const SurfaceLaplacian & laplacian, std::vector<int> fixedVertices, const Progress & progress = {});
  /** \param symbolic Analyze() of the surface. It accounts for two thirds of the work and can be reused for any fixed
   * vertices and any metric. */
  HarmonicSolver(const SurfaceLaplacian &      laplacian,
                 std::vector<int>              fixedVertices,
                 const SymbolicFactorization & symbolic,
                 const Progress &              progress = {});
  ~HarmonicSolver();
  HarmonicSolver(HarmonicSolver &&) noexcept;
  HarmonicSolver &
  operator=(HarmonicSolver &&) noexcept;

  /** \param fixedValues one row for each fixed vertex, in the order given to the constructor; one column for each
   * function.
   * \param source one row for each vertex of the surface (rows of fixed vertices are ignored), one column for each
   * function; empty for 0. Same unit as the function, because L is dimensionless.
   * \return one row for each vertex, one column for each function. Throws InputError if sizes do not match or the
   * solution is not finite. */
  Eigen::MatrixXd
  Solve(const Eigen::MatrixXd & fixedValues, const Eigen::MatrixXd & source = {}) const;

  static SymbolicFactorization
  Analyze(const SurfaceConnectivity & connectivity);

private:
  struct Factor;

  std::vector<int>              m_Fixed;
  std::unique_ptr<const Factor> m_Factor;
};
} // namespace shapeton

#endif
