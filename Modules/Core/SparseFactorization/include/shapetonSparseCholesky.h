#ifndef shapetonSparseCholesky_h
#define shapetonSparseCholesky_h

#include "shapetonProgress.h"
#include "shapetonSymbolicFactorization.h"

namespace shapeton
{
/** \class SparseCholesky
 * \brief Solves A x = b for real symmetric matrices A, usually positive definite ones.
 *
 * A = L D L^T, with D = 1, or +-1 if A is not positive definite; front by front (multifrontal, supernodes), with dense
 * kernels for the instruction set of the CPU and all of ITK's threads. Results are bitwise identical for any number of
 * threads and on any CPU.
 *
 * \ingroup ShapetonSparseFactorization */
class ShapetonSparseFactorization_EXPORT SparseCholesky
{
public:
  explicit SparseCholesky(SymbolicFactorization symbolic);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky &&) noexcept;
  SparseCholesky &
  operator=(SparseCholesky &&) noexcept;

  /** Factorizes the matrix with this diagonal and these edge elements, without pivoting. Returns true if it is
   * positive definite to working accuracy. An indefinite matrix also has a factor unless a pivot is 0 or not finite;
   * see HasFactor(). If progress throws, there is no factor. */
  bool
  Factorize(const Eigen::Ref<const Eigen::VectorXd> & diagonal,
            const Eigen::Ref<const Eigen::VectorXd> & offDiagonal,
            const Progress &                          progress = {});

  /** Overload for a matrix with the analyzed pattern; reads its lower triangle. */
  bool
  Factorize(const Eigen::SparseMatrix<double> & matrix, const Progress & progress = {});

  bool
  HasFactor() const;

  /** Number of negative eigenvalues of the last matrix, which by Sylvester's law of inertia is the number of negative
   * pivots.
   * \pre HasFactor(). */
  int
  NegativeEigenvalues() const;

  /** Replaces each column b by x. Exact to rounding for a positive definite matrix; the factor of an indefinite one
   * may have large elements. \pre HasFactor(). */
  void
  SolveInPlace(Eigen::Ref<Eigen::MatrixXd> b, const Progress & progress = {}) const;

private:
  class Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};

/** Replaces each column b by the solution of A x = b; reads the lower triangle of A. Returns false and leaves b
 * unchanged if A is not positive definite. \ingroup ShapetonSparseFactorization */
ShapetonSparseFactorization_EXPORT bool
SolvePositiveDefinite(const Eigen::SparseMatrix<double> & A,
                      Eigen::Ref<Eigen::MatrixXd>         b,
                      const Progress &                    progress = {});
} // namespace shapeton

#endif
