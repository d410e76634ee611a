// Solves A x = b for the matrix of a grid of resistors: a graph, its diagonal and its edges.
// Usage: ExampleSparseFactorization
#include "shapetonSparseCholesky.h"

#include <algorithm>
#include <cmath>
#include <iostream>

int
main()
{
  constexpr int                   n = 200; // n x n vertices
  std::vector<std::array<int, 2>> edges;
  for (int i = 0; i < n * n; ++i)
  {
    if (i % n + 1 < n)
    {
      edges.push_back({ i, i + 1 });
    }
    if (i + n < n * n)
    {
      edges.push_back({ i, i + n });
    }
  }
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(n * n, 0.01); // makes the matrix positive definite
  Eigen::VectorXd offDiagonal = Eigen::VectorXd::Constant(edges.size(), -1.0);
  Eigen::VectorXd b(n * n);
  const auto      solution = [](int i) { return std::sin(0.1 * i); };
  for (int i = 0; i < n * n; ++i)
  {
    b[i] = diagonal[i] * solution(i);
  }
  for (const auto & [from, to] : edges) // b = A x, row by row
  {
    diagonal[from] += 1.0;
    diagonal[to] += 1.0;
    b[from] += solution(from) - solution(to);
    b[to] += solution(to) - solution(from);
  }

  // Ordering and symbolic analysis, for any number of matrices and threads.
  const shapeton::SymbolicFactorization symbolic(n * n, edges, shapeton::EliminationOrder::NestedDissection);
  shapeton::SparseCholesky              cholesky(symbolic);
  const bool                            isPositive = cholesky.Factorize(diagonal, offDiagonal);
  cholesky.SolveInPlace(b); // now b is x
  double error = 0.0;
  for (int i = 0; i < n * n; ++i)
  {
    error = std::max(error, std::abs(b[i] - solution(i)));
  }
  std::cout << (isPositive ? "positive definite" : "not positive definite") << ", " << symbolic.FactorElements()
            << " elements of the factor, greatest error " << error << '\n';
}
