#ifndef shapetonSelectedInversion_h
#define shapetonSelectedInversion_h

#include "HeatDiffusionMetricExport.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace shapeton
{
/** The elements of a sparse symmetric matrix: one for each vertex, one for each edge. \ingroup HeatDiffusionMetric */
struct SymmetricElements
{
  Eigen::VectorXcd diagonal;
  Eigen::VectorXcd offDiagonal;
};

/** \class SelectedInversion
 * \brief Elements of the inverse of sparse complex-symmetric matrices (A = A^T, not Hermitian) where the matrix has
 * some.
 *
 * A is factorised as L D L^T, D with dense blocks, in an order of nested dissection (METIS), front by front
 * (multifrontal, supernodes); Takahashi's recursion then runs from the root of the elimination tree to its leaves and
 * needs the inverse on the pattern of the factor alone. In a front with pivot block P and rows F below it, G = F P^-1
 * is kept, and the inverse Z obeys Z_RI = -Z_RR G, Z_II = P^-1 - G^T Z_RI. For the graph of a surface with n vertices
 * this takes O(n^1.5) operations and O(n log n) memory; a tube is cheaper than a disk.
 *
 * There is no pivoting. That is safe where all x^* A x (x != 0) lie in a half plane of the complex numbers that does
 * not contain 0 on its border, as then all Schur complements have the property, too, and elements cannot grow much: A =
 * z M + s L with M positive, L positive semidefinite, s > 0 has it for every complex z off the negative real axis and
 * 0. The worse the nearer z is to that axis.
 *
 * An object holds the order and the symbolic analysis, and serves any number of matrices of this pattern, concurrently.
 * The same elements come out for any number of threads and on any CPU.
 *
 * \ingroup HeatDiffusionMetric
 */
class HeatDiffusionMetric_EXPORT SelectedInversion
{
public:
  /** \pre Edges name pairs of different vertices in [0, numberOfVertices), each pair once; else InputError. The graph
   * may have several components. */
  SelectedInversion(int numberOfVertices, std::vector<std::array<int, 2>> edges);
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
            int                                                         atOnce = 2) const;

  /** \name What one inversion costs */
  ///@{
  int
  NumberOfSupernodes() const;
  /** Elements of the factor that are kept, with those that merging and padding add. */
  std::size_t
  FactorElements() const;
  /** Complex products of factorisation and inversion. */
  double
  Products() const;
  ///@}

private:
  struct Layout;
  void
  CheckSizes(const SymmetricElements & matrix) const;

  std::size_t                   m_NumberOfVertices;
  std::size_t                   m_NumberOfEdges;
  std::unique_ptr<const Layout> m_Layout;
};
} // namespace shapeton

#endif
