#ifndef shapetonSparseCholesky_h
#define shapetonSparseCholesky_h

#include "shapetonSymbolicFactorisation.h"

namespace shapeton
{
/** \class SparseCholesky
 * \brief Solves A x = b for real symmetric positive definite matrices A.
 *
 * A = L L^T, front by front (multifrontal, supernodes), with dense kernels for the instruction set of the CPU at hand
 * and all of ITK's threads. The same bytes come out for any number of threads and on any CPU.
 *
 * \ingroup SparseFactorisation
 */
class SparseFactorisation_EXPORT SparseCholesky
{
public:
  explicit SparseCholesky(SymbolicFactorisation symbolic);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky &&) noexcept;
  SparseCholesky &
  operator=(SparseCholesky &&) noexcept;

  /** Factorises the matrix with this diagonal and these elements at the edges. False where a pivot is not positive: the
   * matrix is not positive definite, or not to working accuracy; then there is no factor. */
  bool
  Factorise(const Eigen::Ref<const Eigen::VectorXd> & diagonal, const Eigen::Ref<const Eigen::VectorXd> & offDiagonal);

  /** The same for a matrix of the pattern that the analysis was made of, of which the lower triangle is read. */
  bool
  Factorise(const Eigen::SparseMatrix<double> & matrix);

  /** Replaces each column b by x. \pre The last Factorise() gave true. */
  void
  SolveInPlace(Eigen::Ref<Eigen::MatrixXd> b) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};

/** Replaces each column b by the solution of A x = b; false where A, of which the lower triangle is read, is not
 * positive definite, and b is as it was. \ingroup SparseFactorisation */
SparseFactorisation_EXPORT bool
SolvePositiveDefinite(const Eigen::SparseMatrix<double> & A, Eigen::Ref<Eigen::MatrixXd> b);
} // namespace shapeton

#endif
