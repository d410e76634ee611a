#include "shapetonRefinedPattern.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Maximum number of parts; sufficient for smooth shading. */
constexpr Eigen::Index enoughFaces = 50000;
/** Faces are subdivided down to this fraction of the whole shape, about two pixels. */
constexpr double finest = 1.0 / 500.0;
constexpr int    mostParts = 400;

struct Refined
{
  SurfaceMesh      mesh;
  Eigen::MatrixX2d uv;
};

Refined
CutInFour(const Refined & coarse)
{
  const SurfaceConnectivity connectivity(coarse.mesh);
  const Eigen::Index        vertices = coarse.mesh.V.rows();
  Refined                   fine;
  fine.mesh.V.resize(vertices + connectivity.NumberOfEdges(), 3);
  fine.uv.resize(fine.mesh.V.rows(), 2);
  fine.mesh.V.topRows(vertices) = coarse.mesh.V;
  fine.uv.topRows(vertices) = coarse.uv;
  for (int edge = 0; edge < connectivity.NumberOfEdges(); ++edge)
  {
    const auto & [a, b] = connectivity.VerticesOfEdge(edge);
    fine.mesh.V.row(vertices + edge) = 0.5 * (coarse.mesh.V.row(a) + coarse.mesh.V.row(b));
    fine.uv.row(vertices + edge) = 0.5 * (coarse.uv.row(a) + coarse.uv.row(b));
  }
  fine.mesh.F.resize(4 * coarse.mesh.F.rows(), 3);
  for (int face = 0; face < coarse.mesh.NumberOfFaces(); ++face)
  {
    const auto middle = [&](int k) { return static_cast<int>(vertices) + connectivity.EdgeOfFace(face, k); };
    for (int k = 0; k < 3; ++k)
    {
      fine.mesh.F.row(4 * face + k) << coarse.mesh.F(face, k), middle(k), middle((k + 2) % 3);
    }
    fine.mesh.F.row(4 * face + 3) << middle(0), middle(1), middle(2);
  }
  return fine;
}

/** Number of parts into which the sides of a face are divided. */
int
PartsOfSides(const SurfaceMesh & mesh, Eigen::Index face, double length)
{
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    longest = std::max(longest, (mesh.V.row(mesh.F(face, k)) - mesh.V.row(mesh.F(face, (k + 1) % 3))).norm());
  }
  return std::clamp(static_cast<int>(std::ceil(longest / length)), 1, mostParts);
}

/** Appends the points of a face with evenly divided sides, and their colors, to the surface. */
class FaceCutter
{
public:
  FaceCutter(const Refined & from, const PlanePattern & pattern) : m_From(from), m_Pattern(pattern) {}

  void
  Add(Eigen::Index face, int parts)
  {
    const int  first = static_cast<int>(m_Points.size());
    const auto at = [&](int i, int j) { return first + i * (2 * parts + 3 - i) / 2 + j; };
    for (int i = 0; i <= parts; ++i)
    {
      for (int j = 0; i + j <= parts; ++j)
      {
        m_Points.push_back(this->Mix(m_From.mesh.V, face, double(i) / parts, double(j) / parts));
      }
    }
    for (int i = 0; i < parts; ++i)
    {
      for (int j = 0; i + j < parts; ++j)
      {
        this->AddPart(face, { at(i, j), at(i + 1, j), at(i, j + 1) }, (i + 1.0 / 3.0) / parts, (j + 1.0 / 3.0) / parts);
        if (i + j + 1 < parts)
        {
          this->AddPart(
            face, { at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) }, (i + 2.0 / 3.0) / parts, (j + 2.0 / 3.0) / parts);
        }
      }
    }
  }
  ColoredSurface
  Take()
  {
    ColoredSurface surface;
    surface.mesh.V.resize(static_cast<Eigen::Index>(m_Points.size()), 3);
    surface.mesh.F.resize(static_cast<Eigen::Index>(m_Faces.size()), 3);
    for (std::size_t i = 0; i < m_Points.size(); ++i)
    {
      surface.mesh.V.row(static_cast<Eigen::Index>(i)) = m_Points[i];
    }
    for (std::size_t i = 0; i < m_Faces.size(); ++i)
    {
      surface.mesh.F.row(static_cast<Eigen::Index>(i)) << m_Faces[i][0], m_Faces[i][1], m_Faces[i][2];
    }
    surface.faceColors = std::move(m_Colors);
    return surface;
  }

private:
  template <typename TMatrix>
  Eigen::Matrix<double, 1, TMatrix::ColsAtCompileTime>
  Mix(const TMatrix & values, Eigen::Index face, double b, double c) const
  {
    const auto & F = m_From.mesh.F;
    return (1.0 - b - c) * values.row(F(face, 0)) + b * values.row(F(face, 1)) + c * values.row(F(face, 2));
  }
  void
  AddPart(Eigen::Index face, const std::array<int, 3> & corners, double b, double c)
  {
    const Eigen::RowVector2d uv = this->Mix(m_From.uv, face, b, c);
    m_Faces.push_back(corners);
    m_Colors.push_back(m_Pattern(uv[0], uv[1]));
  }

  const Refined &                 m_From;
  const PlanePattern &            m_Pattern;
  std::vector<Eigen::RowVector3d> m_Points;
  std::vector<std::array<int, 3>> m_Faces;
  std::vector<RGBColor>           m_Colors;
};
} // namespace

ColoredSurface
RefineForPattern(const SurfaceMesh & shape, const Eigen::MatrixX2d & uv, const PlanePattern & pattern)
{
  Refined refined;
  refined.mesh.V = shape.V;
  refined.mesh.F = shape.F;
  refined.uv = uv;
  while (refined.mesh.F.rows() < enoughFaces)
  {
    refined = CutInFour(refined);
  }
  const double finestSide = finest * (shape.V.colwise().maxCoeff() - shape.V.colwise().minCoeff()).maxCoeff();
  FaceCutter   cutter(refined, pattern);
  for (Eigen::Index face = 0; face < refined.mesh.F.rows(); ++face)
  {
    cutter.Add(face, PartsOfSides(refined.mesh, face, finestSide));
  }
  return cutter.Take();
}
} // namespace shapeton
