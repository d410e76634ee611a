#include "shapetonFacePlace.h"

#include <Eigen/Dense>

namespace shapeton
{
Eigen::Vector3d
BarycentricOf(const SurfaceMesh & mesh, int face, const Eigen::Vector3d & point)
{
  const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0)), b = mesh.V.row(mesh.F(face, 1)),
                        c = mesh.V.row(mesh.F(face, 2));
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Matrix2d normal = edges.transpose() * edges;
  const Eigen::Vector2d t = normal.ldlt().solve(edges.transpose() * (point - a));
  return { 1.0 - t.x() - t.y(), t.x(), t.y() };
}
} // namespace shapeton
