#include "itkHarmonicSolver.h"

#include "itkToolError.h"

#include <Eigen/SparseCholesky>

#include <numeric>

namespace itk
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

int
Root(std::vector<int> & parents, int i)
{
  while (parents[i] != i)
  {
    i = parents[i] = parents[parents[i]];
  }
  return i;
}

/** The solution is unique where each component has a fixed vertex. */
void
RequireFixedComponents(const SurfaceLaplacian & laplacian, const std::vector<int> & fixed)
{
  std::vector<int> parents(laplacian.NumberOfVertices());
  std::iota(parents.begin(), parents.end(), 0);
  for (const auto & [a, b] : laplacian.edges)
  {
    parents[Root(parents, a)] = Root(parents, b);
  }
  std::vector<char> hasFixed(parents.size(), 0);
  for (const int vertex : fixed)
  {
    hasFixed[Root(parents, vertex)] = 1;
  }
  for (int vertex = 0; vertex < laplacian.NumberOfVertices(); ++vertex)
  {
    if (!hasFixed[Root(parents, vertex)])
    {
      throw InputError("a harmonic function needs a fixed value in each component of the surface; that of vertex " +
                       std::to_string(vertex) + " has none");
    }
  }
}
} // namespace

struct HarmonicSolver::Factor
{
  Factor(const SurfaceLaplacian & laplacian, const std::vector<int> & fixed);

  std::vector<int>              rows;
  std::vector<int>              freeVertices;
  Sparse                        freeToFixed; ///< the block of L
  Eigen::SimplicialLDLT<Sparse> cholesky;

private:
  /** The lower triangle of the block of free vertices, and the other block. */
  Sparse
  FillBlocks(const SurfaceLaplacian & laplacian, Eigen::Index fixed);
};

HarmonicSolver::Factor::Factor(const SurfaceLaplacian & laplacian, const std::vector<int> & fixed)
  : rows(RowsOfVertices(laplacian.NumberOfVertices(), fixed))
{
  RequireFixedComponents(laplacian, fixed);
  for (int vertex = 0; vertex < laplacian.NumberOfVertices(); ++vertex)
  {
    if (rows[vertex] >= 0)
    {
      freeVertices.push_back(vertex);
    }
  }
  const Sparse matrix = this->FillBlocks(laplacian, static_cast<Eigen::Index>(fixed.size()));
  if (matrix.rows() > 0)
  {
    cholesky.compute(matrix);
    if (cholesky.info() != Eigen::Success)
    {
      throw InputError("the stiffness matrix of the surface cannot be factorised; repair or remesh the surface");
    }
  }
}

Sparse
HarmonicSolver::Factor::FillBlocks(const SurfaceLaplacian & laplacian, Eigen::Index fixed)
{
  const Eigen::VectorXd               diagonal = StiffnessDiagonal(laplacian);
  std::vector<Eigen::Triplet<double>> inner, outer;
  inner.reserve(freeVertices.size() + laplacian.edges.size());
  for (std::size_t i = 0; i < freeVertices.size(); ++i)
  {
    inner.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[freeVertices[i]]);
  }
  for (std::size_t edge = 0; edge < laplacian.edges.size(); ++edge)
  {
    const double weight = laplacian.weights[static_cast<Eigen::Index>(edge)];
    const int    a = rows[laplacian.edges[edge][0]];
    const int    b = rows[laplacian.edges[edge][1]];
    if (a >= 0 && b >= 0)
    {
      inner.emplace_back(std::max(a, b), std::min(a, b), -weight);
    }
    else if (a >= 0 || b >= 0)
    {
      outer.emplace_back(std::max(a, b), -1 - std::min(a, b), -weight);
    }
  }
  const auto free = static_cast<Eigen::Index>(freeVertices.size());
  Sparse     matrix(free, free);
  matrix.setFromTriplets(inner.begin(), inner.end());
  freeToFixed.resize(free, fixed);
  freeToFixed.setFromTriplets(outer.begin(), outer.end());
  return matrix;
}

HarmonicSolver::HarmonicSolver(const SurfaceLaplacian & laplacian, std::vector<int> fixedVertices)
  : m_Fixed(std::move(fixedVertices)), m_Factor(std::make_unique<const Factor>(laplacian, m_Fixed))
{}

HarmonicSolver::~HarmonicSolver() = default;
HarmonicSolver::HarmonicSolver(HarmonicSolver &&) noexcept = default;
HarmonicSolver &
HarmonicSolver::operator=(HarmonicSolver &&) noexcept = default;

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
} // namespace itk
