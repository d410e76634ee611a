#include "shapetonCurveTubes.h"

#include "shapetonPi.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shapeton
{
namespace
{
using Vector3 = Eigen::Vector3d;

constexpr int sides = 12;  // of the cross section; chosen
constexpr int stacks = 10; // rings of a ball, from pole to pole

/** Collects vertices and faces. */
class MeshBuilder
{
public:
  void
  AddRing(const Vector3 & center, const Vector3 & u, const Vector3 & v, const RGBColor & color)
  {
    for (int side = 0; side < sides; ++side)
    {
      const double angle = 2.0 * Pi * side / sides;
      m_Points.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
      m_Colors.push_back(color);
    }
  }

  /** Faces between the last two rings. */
  void
  JoinRings()
  {
    const int second = static_cast<int>(m_Points.size()) - sides;
    const int first = second - sides;
    for (int side = 0; side < sides; ++side)
    {
      const int next = (side + 1) % sides;
      m_Faces.push_back({ first + side, first + next, second + next });
      m_Faces.push_back({ first + side, second + next, second + side });
    }
  }

  void
  AddBall(const Vector3 & center, double radius, const RGBColor & color)
  {
    for (int stack = 0; stack <= stacks; ++stack)
    {
      const double angle = Pi * stack / stacks;
      const double across = radius * std::sin(angle);
      this->AddRing(center - Vector3(0.0, 0.0, radius * std::cos(angle)),
                    Vector3(across, 0.0, 0.0),
                    Vector3(0.0, across, 0.0),
                    color);
      if (stack > 0)
      {
        this->JoinRings();
      }
    }
  }

  ColoredMesh
  Mesh() const
  {
    ColoredMesh colored;
    colored.colors = m_Colors;
    colored.mesh.V.resize(static_cast<Eigen::Index>(m_Points.size()), 3);
    colored.mesh.F.resize(static_cast<Eigen::Index>(m_Faces.size()), 3);
    for (std::size_t i = 0; i < m_Points.size(); ++i)
    {
      colored.mesh.V.row(static_cast<Eigen::Index>(i)) = m_Points[i].transpose();
    }
    for (std::size_t i = 0; i < m_Faces.size(); ++i)
    {
      colored.mesh.F.row(static_cast<Eigen::Index>(i)) << m_Faces[i][0], m_Faces[i][1], m_Faces[i][2];
    }
    return colored;
  }

private:
  std::vector<Vector3>            m_Points;
  std::vector<RGBColor>           m_Colors;
  std::vector<std::array<int, 3>> m_Faces;
};

/** The unit vector perpendicular to `tangent` that is closest to `last`, to avoid twist of the tube. */
Vector3
AcrossLike(const Vector3 & last, const Vector3 & tangent)
{
  constexpr double parallel = 1e-6; // sine of the angle below which `last` does not give a direction
  const Vector3    across = last - last.dot(tangent) * tangent;
  return across.norm() > parallel ? Vector3(across.normalized()) : tangent.unitOrthogonal();
}

void
AddTube(MeshBuilder & builder, const CurveActor & actor, const std::vector<int> & curve)
{
  const auto colorOf = [&](int vertex) {
    return actor.vertexColors.empty() ? actor.color : actor.vertexColors[vertex];
  };
  std::vector<int> vertices; // distinct consecutive points
  for (const int vertex : curve)
  {
    if (vertices.empty() || actor.curves->V.row(vertex) != actor.curves->V.row(vertices.back()))
    {
      vertices.push_back(vertex);
    }
  }
  const auto at = [&](std::size_t i) { return Vector3(actor.curves->V.row(vertices[i]).transpose()); };
  Vector3    across = Vector3::UnitX();
  const auto last = vertices.size() - 1;
  for (std::size_t i = 0; last > 0 && i <= last; ++i)
  {
    const Vector3 tangent = (at(std::min(i + 1, last)) - at(i == 0 ? 0 : i - 1)).normalized();
    across = AcrossLike(across, tangent);
    builder.AddRing(at(i), actor.radius * across, actor.radius * tangent.cross(across), colorOf(vertices[i]));
    if (i > 0)
    {
      builder.JoinRings();
    }
  }
  for (const std::size_t end : { std::size_t{ 0 }, last })
  {
    builder.AddBall(at(end), actor.radius, colorOf(vertices[end]));
  }
}
} // namespace

ColoredMesh
TubesAround(const CurveActor & actor)
{
  MeshBuilder builder;
  for (const std::vector<int> & curve : actor.curves->curves)
  {
    AddTube(builder, actor, curve);
  }
  return builder.Mesh();
}

ColoredMesh
BallsAt(const std::vector<MarkerActor> & markers)
{
  MeshBuilder builder;
  for (const MarkerActor & marker : markers)
  {
    builder.AddBall(marker.point, marker.radius, marker.color);
  }
  return builder.Mesh();
}
} // namespace shapeton
