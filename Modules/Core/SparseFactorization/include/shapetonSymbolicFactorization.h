#ifndef shapetonSymbolicFactorization_h
#define shapetonSymbolicFactorization_h

#include "ShapetonSparseFactorizationExport.h"

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace shapeton
{
/** Method to compute the elimination order. \ingroup ShapetonSparseFactorization */
enum class EliminationOrder
{
  /** Approximate minimum degree (Eigen): fast to compute; for one or two factorizations of real matrices. */
  MinimumDegree,
  /** Nested dissection (METIS): fewer operations, and large subtrees that threads can share; computing it takes as
   * long as ten real factorizations. METIS reseeds std::rand(); calls are serialized, and no other code should call
   * std::rand() at the same time. */
  NestedDissection
};

/** \class SymbolicFactorization
 * \brief Symbolic analysis of a sparse symmetric pattern: elimination order, elimination tree, supernodes.
 *
 * The pattern is a graph: one row per vertex, two off-diagonal elements per edge. One analysis can be used for any
 * number of matrices concurrently, real ones with SparseCholesky and complex-symmetric ones with SelectedInversion;
 * copies share it. For planar graphs and graphs of bounded genus with n vertices a factorization takes O(n^1.5)
 * operations and O(n log n) memory. The analysis is deterministic.
 *
 * \ingroup ShapetonSparseFactorization */
class ShapetonSparseFactorization_EXPORT SymbolicFactorization
{
public:
  struct Parts;

  /** Edges are pairs of different vertices in [0, numberOfVertices), each pair once; otherwise throws InputError. The
   * graph may have several components. */
  SymbolicFactorization(int numberOfVertices, const std::vector<std::array<int, 2>> & edges, EliminationOrder order);

  /** The pattern of a symmetric matrix, read from its lower triangle; its edges are numbered column by column. */
  SymbolicFactorization(const Eigen::SparseMatrix<double> & matrix, EliminationOrder order);

  int
  NumberOfVertices() const;
  int
  NumberOfEdges() const;
  /** \name Cost of a factorization */
  ///@{
  int
  NumberOfSupernodes() const;
  /** Elements of a real factor, including those added by merging supernodes. */
  std::size_t
  FactorElements() const;
  /** Multiplications of factorization and selected inversion together. */
  double
  Products() const;
  ///@}

  /** Internal data for the factorizations of this module. */
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
