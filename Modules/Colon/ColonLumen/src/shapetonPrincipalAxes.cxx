#include "shapetonPrincipalAxes.h"

#include <Eigen/Eigenvalues>

namespace shapeton
{
PrincipalAxes::PrincipalAxes(const Eigen::Matrix2d & symmetric)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(symmetric);
  values = solver.eigenvalues();
  vectors = solver.eigenvectors();
}
} // namespace shapeton
