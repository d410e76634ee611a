#include "shapetonSurfaceDiffusion.h"

#include "shapetonExceptions.h"
#include "shapetonSparseCholesky.h"

#include <stdexcept>

namespace shapeton
{
/** \equation{5.1} with the sign of the forward heat equation. */
void
DiffuseOverSurface(const SurfaceLaplacian & laplacian, double time, Eigen::MatrixXd & values, const Progress & progress)
{
  constexpr int steps = 2;
  if (values.rows() != laplacian.NumberOfVertices() || !(time >= 0.0))
  {
    throw std::invalid_argument("surface diffusion requires one row per vertex and a nonnegative time");
  }
  if (time == 0.0)
  {
    return;
  }
  SparseCholesky solver(
    SymbolicFactorization(laplacian.NumberOfVertices(), laplacian.edges, EliminationOrder::MinimumDegree));
  progress(0.4);
  const double step = time / steps;
  const bool   isPositive = solver.Factorize(
    laplacian.mass + step * StiffnessDiagonal(laplacian), -step * laplacian.weights, progress.Part("", 0.4, 0.8));
  for (int i = 0; i < steps && isPositive; ++i)
  {
    values = laplacian.mass.asDiagonal() * values;
    solver.SolveInPlace(values, progress.Part("", 0.8 + 0.2 * i / steps, 0.8 + 0.2 * (i + 1) / steps));
  }
  if (!isPositive || !values.allFinite())
  {
    throw InputError("values cannot be smoothed over the surface; repair or remesh it");
  }
}
} // namespace shapeton
