#include "shapetonExceptions.h"
#include "shapetonOrderOfElimination.h"
#include "shapetonSymbolicParts.h"

#include <algorithm>
#include <tuple>

namespace shapeton
{
namespace
{
using Edges = std::vector<std::array<int, 2>>;

void
CheckEdges(int numberOfVertices, Edges edges)
{
  if (numberOfVertices < 1)
  {
    throw InputError("a matrix requires at least one row");
  }
  for (auto & [a, b] : edges)
  {
    if (a < 0 || b < 0 || a >= numberOfVertices || b >= numberOfVertices || a == b)
    {
      throw InputError("edge " + std::to_string(a) + ", " + std::to_string(b) + " is not a pair of different rows of " +
                       std::to_string(numberOfVertices));
    }
    std::tie(a, b) = std::minmax({ a, b });
  }
  std::sort(edges.begin(), edges.end());
  const auto twin = std::adjacent_find(edges.begin(), edges.end());
  if (twin != edges.end())
  {
    throw InputError("edge " + std::to_string((*twin)[0]) + ", " + std::to_string((*twin)[1]) +
                     " occurs twice; add the elements up");
  }
}

Edges
EdgesOf(const Eigen::SparseMatrix<double> & matrix)
{
  Edges edges;
  for (int column = 0; column < matrix.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
    {
      if (it.row() > column)
      {
        edges.push_back({ static_cast<int>(it.row()), column });
      }
    }
  }
  return edges;
}
} // namespace

SymbolicFactorization::SymbolicFactorization(int                                     numberOfVertices,
                                             const std::vector<std::array<int, 2>> & edges,
                                             EliminationOrder                        order)
{
  CheckEdges(numberOfVertices, edges);
  m_Parts = std::make_shared<const Parts>(OrderOfElimination(numberOfVertices, edges, order), edges);
}

SymbolicFactorization::SymbolicFactorization(const Eigen::SparseMatrix<double> & matrix, EliminationOrder order)
  : SymbolicFactorization(static_cast<int>(matrix.rows()), EdgesOf(matrix), order)
{}

int
SymbolicFactorization::NumberOfVertices() const
{
  return static_cast<int>(m_Parts->supernodes.order.size());
}

int
SymbolicFactorization::NumberOfEdges() const
{
  return m_Parts->numberOfEdges;
}

int
SymbolicFactorization::NumberOfSupernodes() const
{
  return m_Parts->supernodes.Number();
}

std::size_t
SymbolicFactorization::FactorElements() const
{
  const Supernodes & supernodes = m_Parts->supernodes;
  std::size_t        elements = 0;
  for (int s = 0; s < supernodes.Number(); ++s)
  {
    elements += static_cast<std::size_t>(supernodes.Width(s)) * (supernodes.Width(s) + supernodes.NumberOfRows(s));
  }
  return elements;
}

double
SymbolicFactorization::Products() const
{
  return 2.0 * m_Parts->tasks.products;
}
} // namespace shapeton
