#include "shapetonFlatVertexValues.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Shape of a face, computed from its corners. */
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
  Eigen::Vector3d normal; ///< length is twice the area of the face
  double          area;
};

double
AreaOfMap(const Eigen::MatrixX2d & uv, const FaceMatrix & F, int face)
{
  const Eigen::Vector2d a = uv.row(F(face, 1)) - uv.row(F(face, 0));
  const Eigen::Vector2d b = uv.row(F(face, 2)) - uv.row(F(face, 0));
  return 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
}

/** Averages vertex values along the surface. */
class SurfaceSmoother
{
public:
  SurfaceSmoother(const FaceMatrix &       F,
                  const std::vector<int> & sourceOfVertex,
                  const Eigen::VectorXd &  areaOfFaces,
                  const Eigen::VectorXd &  areaOfVertices)
    : m_F(F), m_SourceOfVertex(sourceOfVertex), m_AreaOfFaces(areaOfFaces), m_AreaOfVertices(areaOfVertices)
  {}

  /** Smooths with a standard deviation of `length`. Averaging from vertices to faces and back adds a variance of h^2 /
   * 3 per direction, where h is the mean edge length. */
  template <typename TValues>
  void
  Smooth(double length, TValues & values) const
  {
    const double edgeSquare = 4.0 / std::sqrt(3.0) * m_AreaOfFaces.sum() / std::max<double>(1.0, m_AreaOfFaces.size());
    const int    passes = static_cast<int>(std::min(200.0, std::round(3.0 * length * length / edgeSquare)));
    for (int pass = 0; pass < passes; ++pass)
    {
      this->SmoothOnce(values);
    }
  }

private:
  template <typename TValues>
  void
  SmoothOnce(TValues & values) const
  {
    TValues sums = TValues::Zero(values.rows(), values.cols());
    for (int face = 0; face < m_F.rows(); ++face)
    {
      const int  a = m_SourceOfVertex[m_F(face, 0)];
      const int  b = m_SourceOfVertex[m_F(face, 1)];
      const int  c = m_SourceOfVertex[m_F(face, 2)];
      const auto share = (m_AreaOfFaces[face] / 9.0 * (values.row(a) + values.row(b) + values.row(c))).eval();
      sums.row(a) += share;
      sums.row(b) += share;
      sums.row(c) += share;
    }
    for (Eigen::Index i = 0; i < values.rows(); ++i)
    {
      if (m_AreaOfVertices[i] > 0.0)
      {
        values.row(i) = sums.row(i) / m_AreaOfVertices[i];
      }
    }
  }

  const FaceMatrix &       m_F;
  const std::vector<int> & m_SourceOfVertex;
  const Eigen::VectorXd &  m_AreaOfFaces;
  const Eigen::VectorXd &  m_AreaOfVertices;
};
} // namespace

FlatVertexValues
MakeFlatVertexValues(const VertexMatrix &     V,
                     const FaceMatrix &       F,
                     const Eigen::MatrixX2d & uv,
                     const std::vector<int> & sourceOfVertex,
                     double                   curvatureLength,
                     double                   normalLength)
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
      growth.row(vertex) += 0.5 * unit.cross(opposite); // area gradient with respect to the corner
      area[vertex] += shape.area / 3.0;
      areaOfMap[vertex] += mapped / 3.0;
    }
  }
  values.normals.rowwise().normalize();
  // The area gradient is 2 H n (Meyer et al., 2003, equation 8), positive for bulges.
  values.curvature =
    (area.array() > 0.0)
      .select(0.5 * growth.cwiseProduct(values.normals).rowwise().sum().array() / area.array().max(1e-300), 0.0);
  values.scale = (areaOfMap.array() > 0.0).select((area.array() / areaOfMap.array().max(1e-300)).sqrt(), 0.0);
  const SurfaceSmoother smoother(F, sourceOfVertex, areaOfFaces, area);
  smoother.Smooth(curvatureLength, values.curvature);
  smoother.Smooth(normalLength, values.normals);
  values.normals.rowwise().normalize();
  return values;
}
} // namespace shapeton
