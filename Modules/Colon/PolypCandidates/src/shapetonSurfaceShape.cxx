#include "shapetonSurfaceShape.h"

#include "shapetonParallelFor.h"
#include "shapetonPi.h"
#include "shapetonSurfaceDiffusion.h"

#include <Eigen/Dense>

#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d
AreaVector(const VertexMatrix & V, const FaceMatrix & F, int face)
{
  const Vector3d a = V.row(F(face, 0)), b = V.row(F(face, 1)), c = V.row(F(face, 2));
  return 0.5 * (b - a).cross(c - a);
}

/** Vertex normals into the lumen, opposite to the face normals. */
Eigen::MatrixXd
InwardNormals(const VertexMatrix & V, const FaceMatrix & F)
{
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(V.rows(), 3);
  for (int face = 0; face < F.rows(); ++face)
  {
    const Vector3d area = AreaVector(V, F, face);
    for (int k = 0; k < 3; ++k)
    {
      normals.row(F(face, k)) -= area;
    }
  }
  normals.rowwise().normalize();
  return normals;
}

/** The shape operator S of a face as a symmetric 3 x 3 matrix: the least squares solution of S e = dn over the edges
 * e. */
Matrix3d
ShapeOperator(const VertexMatrix & V, const FaceMatrix & F, const VertexMatrix & normals, int face)
{
  const Vector3d area = AreaVector(V, F, face);
  const Vector3d first = (V.row(F(face, 1)) - V.row(F(face, 0))).transpose();
  if (!(area.norm() > 0.0))
  {
    return Matrix3d::Zero();
  }
  Eigen::Matrix<double, 3, 2> frame;
  frame.col(0) = first.normalized();
  frame.col(1) = area.normalized().cross(frame.col(0));
  Matrix3d normalMatrix = Matrix3d::Zero(); // for the unknowns a, b, c in S = [a b; b c]
  Vector3d right = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const int                   from = F(face, k), to = F(face, (k + 1) % 3);
    const Eigen::Vector2d       edge = frame.transpose() * (V.row(to) - V.row(from)).transpose();
    const Eigen::Vector2d       change = frame.transpose() * (normals.row(to) - normals.row(from)).transpose();
    Eigen::Matrix<double, 2, 3> rows;
    rows << edge.x(), edge.y(), 0.0, 0.0, edge.x(), edge.y();
    normalMatrix += rows.transpose() * rows;
    right += rows.transpose() * change;
  }
  const Vector3d  s = normalMatrix.ldlt().solve(right);
  Eigen::Matrix2d inPlane;
  inPlane << s[0], s[1], s[1], s[2];
  return frame * inPlane * frame.transpose();
}

Vector3d
AnyPerpendicular(const Vector3d & normal)
{
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  return normal.cross(Vector3d::Unit(least)).normalized();
}

/** Principal curvatures of an operator in the plane perpendicular to `normal`, largest first. */
Eigen::Vector2d
PrincipalCurvatures(const Matrix3d & shape, const Vector3d & normal)
{
  Eigen::Matrix<double, 3, 2> frame;
  frame.col(0) = AnyPerpendicular(normal);
  frame.col(1) = normal.cross(frame.col(0));
  const Eigen::Matrix2d inPlane = frame.transpose() * shape * frame;
  const double          mean = 0.5 * inPlane.trace();
  const double          half = std::hypot(0.5 * (inPlane(0, 0) - inPlane(1, 1)), inPlane(0, 1));
  return { mean + half, mean - half };
}
} // namespace

SurfaceShape
MeasureSurfaceShape(const VertexMatrix &        V,
                    const SurfaceConnectivity & connectivity,
                    const FaceMatrix &          F,
                    double                      time,
                    const Progress &            progress)
{
  const SurfaceLaplacian laplacian = MakeSurfaceLaplacian(connectivity, EdgeLengths(connectivity, V));
  SurfaceShape           shape;
  shape.areas = laplacian.mass;
  Eigen::MatrixXd normals = InwardNormals(V, F);
  progress(0.1);
  DiffuseOverSurface(laplacian, time, normals, progress.Part("", 0.1, 0.7));
  normals.rowwise().normalize();
  shape.inwardNormals = normals;

  std::vector<Matrix3d> operators(F.rows());
  const auto            findOperator = [&](std::size_t face) {
    operators[face] = AreaVector(V, F, static_cast<int>(face)).norm() *
                      ShapeOperator(V, F, shape.inwardNormals, static_cast<int>(face));
  };
  ParallelForBlocks(operators.size(), findOperator, progress.Part("", 0.7, 0.85));
  shape.greater.resize(V.rows());
  shape.lesser.resize(V.rows());
  const auto findCurvatures = [&](std::size_t i) {
    const auto vertex = static_cast<int>(i);
    Matrix3d   sum = Matrix3d::Zero();
    for (const int face : connectivity.FacesOfVertex(vertex))
    {
      sum += operators[face] / 3.0;
    }
    const double          area = std::max(shape.areas[vertex], 1e-12);
    const Eigen::Vector2d curvatures = PrincipalCurvatures(sum / area, shape.inwardNormals.row(vertex).transpose());
    shape.greater[vertex] = curvatures[0];
    shape.lesser[vertex] = curvatures[1];
  };
  ParallelForBlocks(static_cast<std::size_t>(V.rows()), findCurvatures, progress.Part("", 0.85, 1.0));
  return shape;
}

double
ShapeIndex(double greater, double lesser)
{
  return 2.0 / Pi * std::atan2(greater + lesser, greater - lesser);
}

double
Curvedness(double greater, double lesser)
{
  return std::sqrt(0.5 * (greater * greater + lesser * lesser));
}
} // namespace shapeton
