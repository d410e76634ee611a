#include "shapetonSurfaceDiffusion.h"

#include "shapetonExceptions.h"
#include "shapetonSparseCholesky.h"

namespace shapeton
{
/** \equation{5.1} with the sign of the forward heat equation. */
void
DiffuseOverSurface(const SurfaceLaplacian & laplacian, double time, Eigen::MatrixXd & values, const Progress & progress)
{
  constexpr int steps = 2;
  RequireParameter(values.rows() == laplacian.NumberOfVertices(), "the values must have one row per vertex");
  RequireParameter(time >= 0.0, "the parameter \"time\" must be at least 0");
  if (!values.allFinite())
  {
    throw InputError("a value on the surface is not a finite number; replace it");
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
