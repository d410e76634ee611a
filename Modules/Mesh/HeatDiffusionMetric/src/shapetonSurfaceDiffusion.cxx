#include "shapetonSurfaceDiffusion.h"

#include "shapetonParallelFor.h"
#include "shapetonExceptions.h"

#include <Eigen/IterativeLinearSolvers>

#include <stdexcept>

namespace shapeton
{
/** \equation{5.1} with the sign of the forward heat equation. */
void
DiffuseOverSurface(const SurfaceLaplacian & laplacian, double time, Eigen::MatrixXd & values, double tolerance)
{
  constexpr int steps = 2;
  if (values.rows() != laplacian.NumberOfVertices() || !(time >= 0.0))
  {
    throw std::invalid_argument("diffusion over a surface needs a row for each vertex and a time from 0");
  }
  if (time == 0.0)
  {
    return;
  }
  Eigen::SparseMatrix<double> system = time / steps * StiffnessMatrix(laplacian);
  system.diagonal() += laplacian.mass;
  ParallelFor(static_cast<std::size_t>(values.cols()), [&](std::size_t column) {
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver(system);
    solver.setTolerance(tolerance);
    Eigen::VectorXd x = values.col(static_cast<Eigen::Index>(column));
    for (int step = 0; step < steps; ++step)
    {
      const Eigen::VectorXd right = laplacian.mass.cwiseProduct(x);
      x = solver.solveWithGuess(right, x);
      if (solver.info() != Eigen::Success || !x.allFinite())
      {
        throw InputError("values cannot be smoothed over the surface; repair or remesh it");
      }
    }
    values.col(static_cast<Eigen::Index>(column)) = x;
  });
}
} // namespace shapeton
