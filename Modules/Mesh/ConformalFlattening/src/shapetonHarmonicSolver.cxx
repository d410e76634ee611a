#include "shapetonHarmonicSolver.h"

#include "shapetonDisjointSets.h"
#include "shapetonExceptions.h"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace shapeton
{
namespace
{
using Sparse = Eigen::SparseMatrix<double>;

/** For each vertex its row among the free ones, or -1 - its row among the fixed ones. */
std::vector<int>
RowsOfVertices(int vertices, const std::vector<int> & fixed)
{
  std::vector<int> rows(vertices, 0);
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    const int vertex = fixed[i];
    if (vertex < 0 || vertex >= vertices)
    {
      throw InputError("there is no vertex " + std::to_string(vertex) + " to give a value to, but " +
                       std::to_string(vertices) + " vertices");
    }
    if (rows[vertex] < 0)
    {
      throw InputError("vertex " + std::to_string(vertex) + " is given two values");
    }
    rows[vertex] = -1 - static_cast<int>(i);
  }
  int next = 0;
  for (int & row : rows)
  {
    row = row < 0 ? row : next++;
  }
  return rows;
}

/** The solution is unique where each component has a fixed vertex. */
void
RequireFixedComponents(const SurfaceLaplacian & laplacian, const std::vector<int> & fixed)
{
  DisjointSets components(laplacian.NumberOfVertices());
  for (const auto & [a, b] : laplacian.edges)
  {
    components.Join(a, b);
  }
  std::vector<char> hasFixed(laplacian.NumberOfVertices(), 0);
  for (const int vertex : fixed)
  {
    hasFixed[components.Find(vertex)] = 1;
  }
  for (int vertex = 0; vertex < laplacian.NumberOfVertices(); ++vertex)
  {
    if (!hasFixed[components.Find(vertex)])
    {
      throw InputError("a harmonic function needs a fixed value in each component of the surface; that of vertex " +
                       std::to_string(vertex) + " has none");
    }
  }
}

/** Approximate minimum degree of a graph by its edges. */
template <typename TEdge>
std::vector<int>
OrderOf(int vertices, int edges, const TEdge & edgeOf)
{
  // The lower triangle with the diagonal, which AMDOrdering needs; values do not count.
  Sparse pattern(vertices, vertices);
  pattern.resizeNonZeros(vertices + edges);
  std::fill_n(pattern.valuePtr(), vertices + edges, 1.0);
  int * const begin = pattern.outerIndexPtr();
  begin[0] = 0;
  std::fill_n(begin + 1, vertices, 1);
  for (int edge = 0; edge < edges; ++edge)
  {
    const auto & [a, b] = edgeOf(edge);
    ++begin[std::min(a, b) + 1];
  }
  std::partial_sum(begin, begin + vertices + 1, begin);
  std::vector<int> next(begin, begin + vertices);
  for (int vertex = 0; vertex < vertices; ++vertex)
  {
    pattern.innerIndexPtr()[next[vertex]++] = vertex;
  }
  for (int edge = 0; edge < edges; ++edge)
  {
    const auto & [a, b] = edgeOf(edge);
    pattern.innerIndexPtr()[next[std::min(a, b)]++] = std::max(a, b);
  }
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), permutation);
  return { permutation.indices().data(), permutation.indices().data() + vertices };
}
} // namespace

struct HarmonicSolver::Factor
{
  Factor(const SurfaceLaplacian & laplacian, const std::vector<int> & fixed, const std::vector<int> & order);

  /** Among the free vertices in the order of elimination, or -1 - the row among the fixed ones. */
  std::vector<int>                                                         rows;
  std::vector<int>                                                         freeVertices;
  Sparse                                                                   freeToFixed; ///< block of L
  Eigen::SimplicialLDLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> cholesky;

private:
  /** The upper triangle of the block of free vertices. */
  Sparse
  FreeBlock(const SurfaceLaplacian & laplacian) const;
  void
  FillFreeToFixed(const SurfaceLaplacian & laplacian, Eigen::Index fixed);
};

HarmonicSolver::Factor::Factor(const SurfaceLaplacian & laplacian,
                               const std::vector<int> & fixed,
                               const std::vector<int> & order)
  : rows(RowsOfVertices(laplacian.NumberOfVertices(), fixed))
{
  RequireFixedComponents(laplacian, fixed);
  if (order.size() != rows.size())
  {
    throw InputError("the order of elimination has " + std::to_string(order.size()) + " of " +
                     std::to_string(rows.size()) + " vertices");
  }
  for (const int vertex : order)
  {
    if (rows[vertex] >= 0)
    {
      rows[vertex] = static_cast<int>(freeVertices.size());
      freeVertices.push_back(vertex);
    }
  }
  this->FillFreeToFixed(laplacian, static_cast<Eigen::Index>(fixed.size()));
  if (!freeVertices.empty())
  {
    cholesky.compute(this->FreeBlock(laplacian));
    if (cholesky.info() != Eigen::Success)
    {
      throw InputError("the stiffness matrix of the surface cannot be factorised; repair or remesh the surface");
    }
  }
}

Sparse
HarmonicSolver::Factor::FreeBlock(const SurfaceLaplacian & laplacian) const
{
  // Column by column: edges to earlier rows, then the diagonal. Rows within a column need no order.
  const auto      free = static_cast<Eigen::Index>(freeVertices.size());
  Eigen::VectorXi counts = Eigen::VectorXi::Ones(free);
  for (const auto & [a, b] : laplacian.edges)
  {
    if (rows[a] >= 0 && rows[b] >= 0)
    {
      ++counts[std::max(rows[a], rows[b])];
    }
  }
  Sparse matrix(free, free);
  matrix.resizeNonZeros(counts.sum());
  Eigen::VectorXi next(free);
  matrix.outerIndexPtr()[0] = 0;
  for (Eigen::Index j = 0; j < free; ++j)
  {
    next[j] = matrix.outerIndexPtr()[j];
    matrix.outerIndexPtr()[j + 1] = next[j] + counts[j];
  }
  const auto put = [&](int row, int column, double value) {
    matrix.innerIndexPtr()[next[column]] = row;
    matrix.valuePtr()[next[column]++] = value;
  };
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const int a = rows[laplacian.edges[edge][0]];
    const int b = rows[laplacian.edges[edge][1]];
    if (a >= 0 && b >= 0)
    {
      put(std::min(a, b), std::max(a, b), -laplacian.weights[static_cast<Eigen::Index>(edge)]);
    }
  }
  const Eigen::VectorXd diagonal = StiffnessDiagonal(laplacian);
  for (Eigen::Index j = 0; j < free; ++j)
  {
    put(static_cast<int>(j), static_cast<int>(j), diagonal[freeVertices[j]]);
  }
  return matrix;
}

void
HarmonicSolver::Factor::FillFreeToFixed(const SurfaceLaplacian & laplacian, Eigen::Index fixed)
{
  std::vector<Eigen::Triplet<double>> triplets;
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const int a = rows[laplacian.edges[edge][0]];
    const int b = rows[laplacian.edges[edge][1]];
    if ((a < 0) != (b < 0))
    {
      triplets.emplace_back(std::max(a, b), -1 - std::min(a, b), -laplacian.weights[static_cast<Eigen::Index>(edge)]);
    }
  }
  freeToFixed.resize(static_cast<Eigen::Index>(freeVertices.size()), fixed);
  freeToFixed.setFromTriplets(triplets.begin(), triplets.end());
}

HarmonicSolver::HarmonicSolver(const SurfaceLaplacian & laplacian, std::vector<int> fixedVertices)
  : HarmonicSolver(laplacian,
                   std::move(fixedVertices),
                   OrderOf(laplacian.NumberOfVertices(), static_cast<int>(laplacian.edges.size()), [&](int edge) {
                     return laplacian.edges[edge];
                   }))
{}

HarmonicSolver::HarmonicSolver(const SurfaceLaplacian & laplacian,
                               std::vector<int>         fixedVertices,
                               const std::vector<int> & order)
  : m_Fixed(std::move(fixedVertices)), m_Factor(std::make_unique<const Factor>(laplacian, m_Fixed, order))
{}

std::vector<int>
HarmonicSolver::EliminationOrder(const SurfaceConnectivity & connectivity)
{
  return OrderOf(connectivity.NumberOfVertices(), connectivity.NumberOfEdges(), [&](int edge) {
    return connectivity.VerticesOfEdge(edge);
  });
}

HarmonicSolver::~HarmonicSolver() = default;
HarmonicSolver::HarmonicSolver(HarmonicSolver &&) noexcept = default;
HarmonicSolver &
HarmonicSolver::operator=(HarmonicSolver &&) noexcept = default;

/** \equation{5.13} where the source is 0. */
Eigen::MatrixXd
HarmonicSolver::Solve(const Eigen::MatrixXd & fixedValues, const Eigen::MatrixXd & source) const
{
  const auto vertices = static_cast<Eigen::Index>(m_Factor->rows.size());
  const auto free = static_cast<Eigen::Index>(m_Factor->freeVertices.size());
  if (fixedValues.rows() != static_cast<Eigen::Index>(m_Fixed.size()) ||
      (source.size() > 0 && (source.rows() != vertices || source.cols() != fixedValues.cols())))
  {
    throw InputError("a harmonic function needs " + std::to_string(m_Fixed.size()) + " fixed values and a source for " +
                     std::to_string(vertices) + " vertices");
  }
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(vertices, fixedValues.cols());
  Eigen::MatrixXd right = -(m_Factor->freeToFixed * fixedValues);
  for (Eigen::Index i = 0; i < free && source.size() > 0; ++i)
  {
    right.row(i) += source.row(m_Factor->freeVertices[i]);
  }
  if (free > 0)
  {
    right = m_Factor->cholesky.solve(right).eval();
  }
  if (!right.allFinite())
  {
    throw InputError("the harmonic function of this surface is not finite; repair or remesh the surface");
  }
  for (Eigen::Index i = 0; i < free; ++i)
  {
    values.row(m_Factor->freeVertices[i]) = right.row(i);
  }
  for (std::size_t i = 0; i < m_Fixed.size(); ++i)
  {
    values.row(m_Fixed[i]) = fixedValues.row(static_cast<Eigen::Index>(i));
  }
  return values;
}
} // namespace shapeton
