#include "shapetonHarmonicSolver.h"

#include "shapetonDisjointSets.h"
#include "shapetonExceptions.h"
#include "shapetonSparseCholesky.h"

#include <utility>

namespace shapeton
{
namespace
{
/** For each vertex 0 if it is free, or -1 - its row among the fixed ones. */
std::vector<int>
RowsOfVertices(int vertices, const std::vector<int> & fixed)
{
  std::vector<int> rows(vertices, 0);
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    const int vertex = fixed[i];
    if (vertex < 0 || vertex >= vertices)
    {
      throw InputError("fixed vertex " + std::to_string(vertex) + " does not exist; the surface has " +
                       std::to_string(vertices) + " vertices");
    }
    if (rows[vertex] < 0)
    {
      throw InputError("vertex " + std::to_string(vertex) + " has two fixed values");
    }
    rows[vertex] = -1 - static_cast<int>(i);
  }
  return rows;
}

SymbolicFactorization
SymbolicOf(int vertices, const std::vector<std::array<int, 2>> & edges)
{
  return SymbolicFactorization(vertices, edges, EliminationOrder::MinimumDegree);
}

/** The solution is unique if each component has a fixed vertex. */
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
      throw InputError("a harmonic function requires a fixed value in each component of the surface; the component of "
                       "vertex " +
                       std::to_string(vertex) + " has none");
    }
  }
}
} // namespace

struct HarmonicSolver::Factor
{
  Factor(const SurfaceLaplacian &      laplacian,
         const std::vector<int> &      fixed,
         const SymbolicFactorization & symbolic,
         const Progress &              progress);

  std::vector<int>                                   rows; ///< -1 - the row among the fixed vertices, 0 for free ones
  std::vector<std::pair<std::array<int, 2>, double>> weightsToFixed; ///< for edges from a free to a fixed vertex
  SparseCholesky                                     cholesky;
};

/** Replaces the rows of fixed vertices by identity rows; the pattern is then independent of the fixed vertices. */
HarmonicSolver::Factor::Factor(const SurfaceLaplacian &      laplacian,
                               const std::vector<int> &      fixed,
                               const SymbolicFactorization & symbolic,
                               const Progress &              progress)
  : rows(RowsOfVertices(laplacian.NumberOfVertices(), fixed)), cholesky(symbolic)
{
  RequireFixedComponents(laplacian, fixed);
  Eigen::VectorXd diagonal = StiffnessDiagonal(laplacian);
  Eigen::VectorXd offDiagonal = -laplacian.weights;
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const auto & [a, b] = laplacian.edges[edge];
    if (rows[a] >= 0 && rows[b] >= 0)
    {
      continue;
    }
    double & element = offDiagonal[static_cast<Eigen::Index>(edge)];
    if (rows[a] >= 0 || rows[b] >= 0)
    {
      weightsToFixed.push_back({ rows[a] >= 0 ? std::array<int, 2>{ a, b } : std::array<int, 2>{ b, a }, -element });
    }
    element = 0.0;
  }
  for (const int vertex : fixed)
  {
    diagonal[vertex] = 1.0;
  }
  cholesky.Factorize(diagonal, offDiagonal, progress);
  if (!cholesky.HasFactor()) // clamped weights can make it indefinite
  {
    throw InputError("the stiffness matrix of the surface cannot be factorized; repair or remesh the surface");
  }
}

HarmonicSolver::HarmonicSolver(const SurfaceLaplacian & laplacian,
                               std::vector<int>         fixedVertices,
                               const Progress &         progress)
  : HarmonicSolver(laplacian,
                   std::move(fixedVertices),
                   SymbolicOf(laplacian.NumberOfVertices(), laplacian.edges),
                   progress)
{}

HarmonicSolver::HarmonicSolver(const SurfaceLaplacian &      laplacian,
                               std::vector<int>              fixedVertices,
                               const SymbolicFactorization & symbolic,
                               const Progress &              progress)
  : m_Fixed(std::move(fixedVertices)), m_Factor(std::make_unique<const Factor>(laplacian, m_Fixed, symbolic, progress))
{}

SymbolicFactorization
HarmonicSolver::Analyze(const SurfaceConnectivity & connectivity)
{
  std::vector<std::array<int, 2>> edges(connectivity.NumberOfEdges());
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    edges[edge] = connectivity.VerticesOfEdge(edge);
  }
  return SymbolicOf(connectivity.NumberOfVertices(), edges);
}

HarmonicSolver::~HarmonicSolver() = default;
HarmonicSolver::HarmonicSolver(HarmonicSolver &&) noexcept = default;
HarmonicSolver &
HarmonicSolver::operator=(HarmonicSolver &&) noexcept = default;

/** \equation{5.13} for source 0. */
Eigen::MatrixXd
HarmonicSolver::Solve(const Eigen::MatrixXd & fixedValues, const Eigen::MatrixXd & source) const
{
  const auto vertices = static_cast<Eigen::Index>(m_Factor->rows.size());
  if (fixedValues.rows() != static_cast<Eigen::Index>(m_Fixed.size()) ||
      (source.size() > 0 && (source.rows() != vertices || source.cols() != fixedValues.cols())))
  {
    throw InputError("a harmonic function requires " + std::to_string(m_Fixed.size()) +
                     " fixed values and a source for " + std::to_string(vertices) + " vertices");
  }
  Eigen::MatrixXd values = source;
  if (source.size() == 0)
  {
    values = Eigen::MatrixXd::Zero(vertices, fixedValues.cols());
  }
  for (const auto & [ends, weight] : m_Factor->weightsToFixed)
  {
    values.row(ends[0]) += weight * fixedValues.row(-1 - m_Factor->rows[ends[1]]);
  }
  for (std::size_t i = 0; i < m_Fixed.size(); ++i)
  {
    values.row(m_Fixed[i]) = fixedValues.row(static_cast<Eigen::Index>(i));
  }
  m_Factor->cholesky.SolveInPlace(values);
  if (!values.allFinite())
  {
    throw InputError("the harmonic function of this surface is not finite; repair or remesh the surface");
  }
  return values;
}
} // namespace shapeton
