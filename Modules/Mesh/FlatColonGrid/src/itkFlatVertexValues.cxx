#include "itkFlatVertexValues.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace itk
{
namespace
{
/** Of a face, by its corners. */
struct FaceShape
{
  FaceShape(const VertexMatrix & V, const FaceMatrix & F, int face)
  {
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = V.row(F(face, k));
    }
    normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    area = 0.5 * normal.norm();
  }

  Eigen::Vector3d corners[3];
  Eigen::Vector3d normal; ///< twice the area long
  double          area;
};

double
AreaOfMap(const Eigen::MatrixX2d & uv, const FaceMatrix & F, int face)
{
  const Eigen::Vector2d a = uv.row(F(face, 1)) - uv.row(F(face, 0));
  const Eigen::Vector2d b = uv.row(F(face, 2)) - uv.row(F(face, 0));
  return 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
}

/** Means over faces and back, weighted by area: h^2 / 3 of variance each time, h the mean edge. */
void
Smooth(const FaceMatrix &       F,
       const std::vector<int> & sourceOfVertex,
       const Eigen::VectorXd &  areaOfFaces,
       const Eigen::VectorXd &  areaOfVertices,
       double                   length,
       Eigen::VectorXd &        values)
{
  const double edgeSquare = 4.0 / std::sqrt(3.0) * areaOfFaces.sum() / std::max<double>(1.0, areaOfFaces.size());
  const int    passes = static_cast<int>(std::min(200.0, std::round(3.0 * length * length / edgeSquare)));
  for (int pass = 0; pass < passes; ++pass)
  {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(values.size());
    for (int face = 0; face < F.rows(); ++face)
    {
      const int    a = sourceOfVertex[F(face, 0)];
      const int    b = sourceOfVertex[F(face, 1)];
      const int    c = sourceOfVertex[F(face, 2)];
      const double share = areaOfFaces[face] / 3.0 * (values[a] + values[b] + values[c]) / 3.0;
      sums[a] += share;
      sums[b] += share;
      sums[c] += share;
    }
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      values[i] = areaOfVertices[i] > 0.0 ? sums[i] / areaOfVertices[i] : values[i];
    }
  }
}
} // namespace

FlatVertexValues
MakeFlatVertexValues(const VertexMatrix &     V,
                     const FaceMatrix &       F,
                     const Eigen::MatrixX2d & uv,
                     const std::vector<int> & sourceOfVertex,
                     double                   curvatureLength)
{
  const int        vertices = 1 + *std::max_element(sourceOfVertex.begin(), sourceOfVertex.end());
  FlatVertexValues values{ VertexMatrix::Zero(vertices, 3), Eigen::VectorXd::Zero(vertices), {} };
  VertexMatrix     growth = VertexMatrix::Zero(vertices, 3);
  Eigen::VectorXd  area = Eigen::VectorXd::Zero(vertices);
  Eigen::VectorXd  areaOfMap = Eigen::VectorXd::Zero(vertices);
  Eigen::VectorXd  areaOfFaces(F.rows());
  for (int face = 0; face < F.rows(); ++face)
  {
    const FaceShape       shape(V, F, face);
    const Eigen::Vector3d unit = shape.area > 0.0 ? Eigen::Vector3d(shape.normal.normalized()) : shape.normal;
    const double          mapped = AreaOfMap(uv, F, face);
    areaOfFaces[face] = shape.area;
    for (int k = 0; k < 3; ++k)
    {
      const int             vertex = sourceOfVertex[F(face, k)];
      const Eigen::Vector3d opposite = shape.corners[(k + 2) % 3] - shape.corners[(k + 1) % 3];
      values.normals.row(vertex) += shape.normal;
      growth.row(vertex) += 0.5 * unit.cross(opposite); // of the area, when the corner moves
      area[vertex] += shape.area / 3.0;
      areaOfMap[vertex] += mapped / 3.0;
    }
  }
  values.normals.rowwise().normalize();
  // Area grows where a bulge is pulled further out: the gradient is 2 H n (Meyer et al., 2003, equation 8).
  values.curvature =
    (area.array() > 0.0)
      .select(0.5 * growth.cwiseProduct(values.normals).rowwise().sum().array() / area.array().max(1e-300), 0.0);
  values.scale = (areaOfMap.array() > 0.0).select((area.array() / areaOfMap.array().max(1e-300)).sqrt(), 0.0);
  Smooth(F, sourceOfVertex, areaOfFaces, area, curvatureLength, values.curvature);
  return values;
}
} // namespace itk
