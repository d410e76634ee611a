#ifndef shapetonSparseCholesky_h
#define shapetonSparseCholesky_h

#include "shapetonProgress.h"
#include "shapetonSymbolicFactorisation.h"

namespace shapeton
{
/** \class SparseCholesky
 * \brief Solves A x = b for real symmetric matrices A, as a rule positive definite ones.
 *
 * A = L D L^T with D of 1 and, where A is not positive definite, -1; front by front (multifrontal, supernodes), with
 * dense kernels for the instruction set of the CPU at hand and all of ITK's threads. The same bytes come out for any
 * number of threads and on any CPU.
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

  /** Factorises the matrix with this diagonal and these elements at the edges, without pivoting. True where it is
   * positive definite to working accuracy. An indefinite one has a factor, too, unless a pivot is 0 or not finite: see
   * HasFactor(). There is none after progress has thrown. */
  bool
  Factorise(const Eigen::Ref<const Eigen::VectorXd> & diagonal,
            const Eigen::Ref<const Eigen::VectorXd> & offDiagonal,
            const Progress &                          progress = {});

  /** The same for a matrix of the pattern that the analysis was made of, of which the lower triangle is read. */
  bool
  Factorise(const Eigen::SparseMatrix<double> & matrix, const Progress & progress = {});

  bool
  HasFactor() const;

  /** Of the last matrix; by Sylvester's law of inertia the number of negative pivots. \pre HasFactor(). */
  int
  NegativeEigenvalues() const;

  /** Replaces each column b by x; exact to rounding for a positive definite matrix, while elements of the factor of an
   * indefinite one can grow. \pre HasFactor(). */
  void
  SolveInPlace(Eigen::Ref<Eigen::MatrixXd> b, const Progress & progress = {}) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};

/** Replaces each column b by the solution of A x = b; false where A, of which the lower triangle is read, is not
 * positive definite, and b is as it was. \ingroup SparseFactorisation */
SparseFactorisation_EXPORT bool
SolvePositiveDefinite(const Eigen::SparseMatrix<double> & A,
                      Eigen::Ref<Eigen::MatrixXd>         b,
                      const Progress &                    progress = {});
} // namespace shapeton

#endif
