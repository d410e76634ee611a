#ifndef shapetonHarmonicSolver_h
#define shapetonHarmonicSolver_h

#include "ConformalFlatteningExport.h"

#include "shapetonProgress.h"
#include "shapetonSurfaceLaplacian.h"
#include "shapetonSymbolicFactorisation.h"

#include <memory>

namespace shapeton
{
/** \class HarmonicSolver
 * \brief Functions on a surface with given values at some vertices and a given Laplacian at the others.
 *
 * Solves (L x)_i = source_i at the free vertices i, x = given at the fixed ones; boundaries without fixed vertices are
 * natural (Neumann). With source 0 this is the harmonic function of the fixed values. L is factorised once by
 * SparseCholesky, any number of right-hand sides follow. The same input gives the same bytes.
 *
 * \ingroup ConformalFlattening
 */
class ConformalFlattening_EXPORT HarmonicSolver
{
public:
  /** Throws InputError where a fixed vertex does not exist or is named twice, a component of the surface has no fixed
   * vertex (the solution would not be unique), or the factorisation breaks down. */
  HarmonicSolver(const SurfaceLaplacian & laplacian, std::vector<int> fixedVertices, const Progress & progress = {});
  /** \param symbolic Analyse() of the surface: finding it is two thirds of the work, and it serves any fixed vertices
   * and any metric. */
  HarmonicSolver(const SurfaceLaplacian &      laplacian,
                 std::vector<int>              fixedVertices,
                 const SymbolicFactorisation & symbolic,
                 const Progress &              progress = {});
  ~HarmonicSolver();
  HarmonicSolver(HarmonicSolver &&) noexcept;
  HarmonicSolver &
  operator=(HarmonicSolver &&) noexcept;

  /** \param fixedValues a row for each fixed vertex, in the order given to the constructor, a column for each function.
   * \param source a row for each vertex of the surface, of which those of fixed vertices count for nothing, and a
   * column for each function; empty for 0. Unit: that of the function, as L has none.
   * \return a row for each vertex, a column for each function. Throws InputError where sizes do not fit or the solution
   * is not finite. */
  Eigen::MatrixXd
  Solve(const Eigen::MatrixXd & fixedValues, const Eigen::MatrixXd & source = {}) const;

  static SymbolicFactorisation
  Analyse(const SurfaceConnectivity & connectivity);

private:
  struct Factor;

  std::vector<int>              m_Fixed;
  std::unique_ptr<const Factor> m_Factor;
};
} // namespace shapeton

#endif
