#ifndef shapetonSelectedInversion_h
#define shapetonSelectedInversion_h

#include "shapetonProgress.h"
#include "shapetonSymbolicFactorization.h"

#include <functional>

namespace shapeton
{
struct FactorLayout;

/** The nonzero elements of a sparse symmetric matrix: one per vertex, one per edge.
 * \ingroup ShapetonSparseFactorization */
struct SymmetricElements
{
  Eigen::VectorXcd diagonal;
  Eigen::VectorXcd offDiagonal;
};

/** \class SelectedInversion
 * \brief Computes elements of the inverse of sparse complex-symmetric matrices (A = A^T, not Hermitian) on the
 * sparsity pattern of the matrix.
 *
 * A is factorized as L D L^T, D block diagonal, front by front (multifrontal, supernodes). Takahashi's recursion then
 * runs from the root of the elimination tree to its leaves and needs the inverse only on the pattern of the factor. In
 * a front with pivot block P and rows F below it, G = F P^-1 is stored, and the inverse Z satisfies Z_RI = -Z_RR G,
 * Z_II = P^-1 - G^T Z_RI.
 *
 * There is no pivoting. This is stable if all x^* A x (x != 0) are in an open complex half plane whose border contains
 * 0: all Schur complements then share this property, and element growth is bounded. It holds for A = z M + s L with M
 * positive, L positive semidefinite, s > 0 and every complex z off the nonpositive real axis. The growth increases as z
 * approaches that axis.
 *
 * An object can invert any number of matrices with its pattern, concurrently. Results are identical for any number of
 * threads and on any CPU.
 *
 * \ingroup ShapetonSparseFactorization */
class ShapetonSparseFactorization_EXPORT SelectedInversion
{
public:
  explicit SelectedInversion(SymbolicFactorization symbolic);
  ~SelectedInversion();
  SelectedInversion(SelectedInversion &&) noexcept;
  SelectedInversion &
  operator=(SelectedInversion &&) noexcept;

  /** The elements of the inverse on the diagonal and on the edges. Throws InputError if a pivot block is singular or
   * an element is not finite. */
  SymmetricElements
  Invert(const SymmetricElements & matrix) const;

  /** Inverts matrixOf(0), ... matrixOf(number - 1) with all of ITK's threads. At most `atOnce` matrices are in memory
   * at a time. Passes the inverses to `take` in this order, one by one. `matrixOf` may be called concurrently. */
  void
  InvertAll(int                                                         number,
            const std::function<SymmetricElements(int)> &               matrixOf,
            const std::function<void(int, const SymmetricElements &)> & take,
            int                                                         atOnce = 2,
            const Progress &                                            progress = {}) const;

  const SymbolicFactorization &
  Symbolic() const
  {
    return m_Symbolic;
  }

private:
  void
  CheckSizes(const SymmetricElements & matrix) const;

  SymbolicFactorization               m_Symbolic;
  std::unique_ptr<const FactorLayout> m_Layout;
};
} // namespace shapeton

#endif
