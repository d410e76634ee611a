#ifndef shapetonSymbolicFactorisation_h
#define shapetonSymbolicFactorisation_h

#include "SparseFactorisationExport.h"

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace shapeton
{
/** How the order of elimination is found. \ingroup SparseFactorisation */
enum class EliminationOrder
{
  /** Approximate minimum degree (Eigen): quickly found, for one or two factorisations of real matrices. */
  MinimumDegree,
  /** Nested dissection (METIS): fewer operations, and large subtrees that threads can share; its search costs as much
   * as ten real factorisations. METIS seeds std::rand() and leaves it changed; calls take turns, and nobody else should
   * call it meanwhile. */
  NestedDissection
};

/** \class SymbolicFactorisation
 * \brief The analysis of a sparse symmetric pattern: order of elimination, elimination tree, supernodes.
 *
 * The pattern is a graph: a row for each vertex, two elements off the diagonal for each edge. One analysis serves any
 * number of matrices, real ones by SparseCholesky and complex-symmetric ones by SelectedInversion, concurrently; copies
 * share it. For planar graphs and graphs of bounded genus with n vertices a factor takes O(n^1.5) operations and
 * O(n log n) memory. The same graph gives the same analysis.
 *
 * \ingroup SparseFactorisation
 */
class SparseFactorisation_EXPORT SymbolicFactorisation
{
public:
  struct Parts;

  /** Edges name pairs of different vertices in [0, numberOfVertices), each pair once; else InputError. The graph may
   * have several components. */
  SymbolicFactorisation(int numberOfVertices, const std::vector<std::array<int, 2>> & edges, EliminationOrder order);

  /** The pattern of a symmetric matrix, of which the lower triangle is read; its edges follow one another column by
   * column. */
  SymbolicFactorisation(const Eigen::SparseMatrix<double> & matrix, EliminationOrder order);

  int
  NumberOfVertices() const;
  int
  NumberOfEdges() const;
  /** \name What a factorisation costs */
  ///@{
  int
  NumberOfSupernodes() const;
  /** Elements of a real factor, with those that the merging of supernodes adds. */
  std::size_t
  FactorElements() const;
  /** Products of elimination and selected inversion together. */
  double
  Products() const;
  ///@}

  /** For the factorisations of this module. */
  const Parts &
  GetParts() const
  {
    return *m_Parts;
  }

private:
  std::shared_ptr<const Parts> m_Parts;
};
} // namespace shapeton

#endif
