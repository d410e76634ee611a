#include "shapetonPerspectiveRendering.h"

#include "shapetonPi.h"
#include "shapetonSampleComposition.h"
#include "shapetonSurfaceQuality.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;

class Projection
{
public:
  explicit Projection(const PerspectiveCamera & camera) : m_Camera(camera)
  {
    constexpr double widestField = 170.0; // degrees; at 180 the picture is infinitely large
    const Vector3d   look = camera.focus - camera.eye;
    const Vector3d   across = look.cross(camera.up);
    if (!(across.norm() > 1e-9 * camera.up.norm() * look.norm()) || !(camera.fieldOfView > 0.0) ||
        !(camera.fieldOfView < widestField) || !(camera.nearest > 0.0) || !(camera.lightReach > 0.0))
    {
      throw std::invalid_argument(
        "a perspective camera has a zero view direction, one parallel to up, or a number out of range");
    }
    m_Forward = look.normalized();
    m_Right = across.normalized();
    m_Up = m_Right.cross(m_Forward);
    m_Scale = 0.5 * camera.width / std::tan(0.5 * camera.fieldOfView * Pi / 180.0);
  }

  /** Depth in front of the eye, mm. */
  double
  DepthOf(const Vector3d & point) const
  {
    return (point - m_Camera.eye).dot(m_Forward);
  }

  Eigen::Vector2d
  PlaceOf(const Vector3d & point) const
  {
    const Vector3d way = point - m_Camera.eye;
    const double   scale = m_Scale / this->DepthOf(point);
    return { 0.5 * (m_Camera.width - 1.0) + scale * way.dot(m_Right),
             0.5 * (m_Camera.height - 1.0) - scale * way.dot(m_Up) };
  }

  ScreenVertex
  Project(const Vector3d & point, const Vector3d & normal) const
  {
    const double          depth = std::max(this->DepthOf(point), m_Camera.nearest);
    const Eigen::Vector2d place = this->PlaceOf(m_Camera.eye + (point - m_Camera.eye) * (depth / this->DepthOf(point)));
    // 1 / depth is linear over a face on the screen. So is this value, which increases with depth.
    const double order = -1000.0 * m_Camera.nearest / depth;
    return { ScreenPlace(place.x()),
             ScreenPlace(place.y()),
             static_cast<float>(order),
             { static_cast<float>(normal.dot(m_Right)),
               static_cast<float>(normal.dot(m_Up)),
               static_cast<float>(-normal.dot(m_Forward)) } };
  }

  /** 0 to 1. */
  double
  LightAt(const Vector3d & point) const
  {
    const double share = (point - m_Camera.eye).norm() / m_Camera.lightReach;
    return 1.0 / (1.0 + share * share);
  }

private:
  const PerspectiveCamera & m_Camera;
  Vector3d                  m_Forward;
  Vector3d                  m_Right;
  Vector3d                  m_Up;
  double                    m_Scale{ 1.0 };
};

/** Faces that are entirely in front of the eye. */
FaceMatrix
FacesInFront(const SurfaceMesh & surface, const Projection & projection, double nearest)
{
  FaceMatrix faces(surface.F.rows(), 3);
  int        number = 0;
  for (Eigen::Index face = 0; face < surface.F.rows(); ++face)
  {
    bool isInFront = true;
    for (int k = 0; k < 3; ++k)
    {
      isInFront = isInFront && projection.DepthOf(surface.V.row(surface.F(face, k)).transpose()) >= nearest;
    }
    if (isInFront)
    {
      faces.row(number++) = surface.F.row(face);
    }
  }
  return faces.topRows(number);
}
} // namespace

Picture::Pointer
RenderPerspective(const SurfaceMesh &           surface,
                  const std::vector<RGBColor> & vertexColors,
                  const PerspectiveCamera &     camera)
{
  const RGBColor   background = MakeColor(18, 19, 25);
  const Projection projection(camera);
  if (static_cast<Eigen::Index>(vertexColors.size()) != surface.V.rows())
  {
    throw std::invalid_argument("a perspective picture requires a color for each vertex");
  }
  const FaceMatrix   faces = FacesInFront(surface, projection, camera.nearest);
  const VertexMatrix normals = VertexNormals(surface.V, surface.F);
  ScreenPart         part;
  part.faces = &faces;
  part.hasDepthShading = false;
  part.vertices.resize(surface.V.rows());
  part.vertexColors.resize(surface.V.rows());
  for (Eigen::Index i = 0; i < surface.V.rows(); ++i)
  {
    const Vector3d point = surface.V.row(i).transpose();
    if (projection.DepthOf(point) > 0.0)
    {
      part.vertices[i] = projection.Project(point, normals.row(i).transpose());
    }
    part.vertexColors[i] = MixColors(background, vertexColors[i], projection.LightAt(point));
  }
  const auto         samples = RasterizeParts({ part }, camera.width, camera.height);
  const auto         picture = NewPicture(camera.width, camera.height, background);
  const DepthShading noShading(samples, camera.width, camera.height, 1.0, 0.0);
  ComposeSamples(picture, samples, noShading, background);
  return picture;
}

Eigen::Vector2d
ProjectPoint(const Eigen::Vector3d & point, const PerspectiveCamera & camera)
{
  const Projection projection(camera);
  return projection.DepthOf(point) > 0.0
           ? projection.PlaceOf(point)
           : Eigen::Vector2d(Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()));
}
} // namespace shapeton
