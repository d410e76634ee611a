#ifndef shapetonSelectedInversion_h
#define shapetonSelectedInversion_h

#include "shapetonProgress.h"
#include "shapetonSymbolicFactorisation.h"

#include <functional>

namespace shapeton
{
struct FactorLayout;

/** The elements of a sparse symmetric matrix: one for each vertex, one for each edge. \ingroup SparseFactorisation */
struct SymmetricElements
{
  Eigen::VectorXcd diagonal;
  Eigen::VectorXcd offDiagonal;
};

/** \class SelectedInversion
 * \brief Elements of the inverse of sparse complex-symmetric matrices (A = A^T, not Hermitian) where the matrix has
 * some.
 *
 * A is factorised as L D L^T, D with dense blocks, front by front (multifrontal, supernodes); Takahashi's recursion
 * then runs from the root of the elimination tree to its leaves and needs the inverse on the pattern of the factor
 * alone. In a front with pivot block P and rows F below it, G = F P^-1 is kept, and the inverse Z obeys Z_RI = -Z_RR G,
 * Z_II = P^-1 - G^T Z_RI.
 *
 * There is no pivoting. That is safe where all x^* A x (x != 0) lie in a half plane of the complex numbers that does
 * not contain 0 on its border, as then all Schur complements have the property, too, and elements cannot grow much: A =
 * z M + s L with M positive, L positive semidefinite, s > 0 has it for every complex z off the negative real axis and
 * 0. The worse the nearer z is to that axis.
 *
 * An object serves any number of matrices of its pattern, concurrently. The same elements come out for any number of
 * threads and on any CPU.
 *
 * \ingroup SparseFactorisation
 */
class SparseFactorisation_EXPORT SelectedInversion
{
public:
  explicit SelectedInversion(SymbolicFactorisation symbolic);
  ~SelectedInversion();
  SelectedInversion(SelectedInversion &&) noexcept;
  SelectedInversion &
  operator=(SelectedInversion &&) noexcept;

  /** The elements of the inverse on the diagonal and on the edges. Throws InputError where a pivot block is singular
   * or an element is not finite. */
  SymmetricElements
  Invert(const SymmetricElements & matrix) const;

  /** Inverts matrixOf(0), ... matrixOf(number - 1), at most `atOnce` at a time, which the memory depends on, with all
   * of ITK's threads. Hands them to `take` in this order, one by one. `matrixOf` may be called concurrently. */
  void
  InvertAll(int                                                         number,
            const std::function<SymmetricElements(int)> &               matrixOf,
            const std::function<void(int, const SymmetricElements &)> & take,
            int                                                         atOnce = 2,
            const Progress &                                            progress = {}) const;

  const SymbolicFactorisation &
  Symbolic() const
  {
    return m_Symbolic;
  }

private:
  void
  CheckSizes(const SymmetricElements & matrix) const;

  SymbolicFactorisation               m_Symbolic;
  std::unique_ptr<const FactorLayout> m_Layout;
};
} // namespace shapeton

#endif
