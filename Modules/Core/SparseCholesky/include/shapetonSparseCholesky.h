#ifndef shapetonSparseCholesky_h
#define shapetonSparseCholesky_h

#include "SparseCholeskyExport.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace shapeton
{
/** \class SparseCholesky
 * \brief Solves A x = b for symmetric positive definite matrices A whose pattern is a graph: one row for each vertex,
 * two elements off the diagonal for each edge.
 *
 * A = L L^T, front by front (multifrontal, supernodes), in an order of nested dissection (METIS), with dense kernels
 * for the instruction set of the CPU at hand. The order and the symbolic analysis serve any number of matrices. For
 * planar graphs and graphs of bounded genus with n vertices a factor takes O(n^1.5) operations and O(n log n) memory.
 * The same bytes come out for any number of threads and on any CPU with the same METIS.
 *
 * \ingroup SparseCholesky
 */
class SparseCholesky_EXPORT SparseCholesky
{
public:
  /** \pre Edges name pairs of different vertices in [0, numberOfVertices), each pair once; the graph may have several
   * components. */
  SparseCholesky(int numberOfVertices, const std::vector<std::array<int, 2>> & edges);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky &&) noexcept;
  SparseCholesky &
  operator=(SparseCholesky &&) noexcept;

  /** Factorises the matrix with this diagonal and these elements at the edges. False where a pivot is not positive: the
   * matrix is not positive definite, or not to working accuracy; then there is no factor. */
  bool
  Factorise(const std::vector<double> & diagonal, const std::vector<double> & offDiagonal);

  /** Replaces b by x. \pre The last Factorise() gave true. */
  void
  Solve(std::vector<double> & b) const;

  /** Elements of the factor, with those that the merging of supernodes adds. */
  std::size_t
  FactorElements() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> m_Implementation;
};
} // namespace shapeton

#endif
