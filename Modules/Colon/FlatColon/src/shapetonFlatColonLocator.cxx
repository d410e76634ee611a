#include "shapetonFlatColonLocator.h"

#include <Eigen/Geometry>

namespace shapeton
{
namespace
{
/** Barycentric coordinates of a point in the plane of a triangle; the nearest corner if the triangle is degenerate. */
Eigen::Vector3d
BarycentricOfPoint(const VertexMatrix & V, const FaceMatrix & F, int face, const Eigen::Vector3d & point)
{
  const Eigen::Vector3d a = V.row(F(face, 0)), b = V.row(F(face, 1)), c = V.row(F(face, 2));
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double          square = normal.squaredNorm();
  if (!(square > 0.0))
  {
    const Eigen::Vector3d squares((point - a).squaredNorm(), (point - b).squaredNorm(), (point - c).squaredNorm());
    Eigen::Index          nearest = 0;
    squares.minCoeff(&nearest);
    return Eigen::Vector3d::Unit(nearest);
  }
  const double    ofB = (point - a).cross(c - a).dot(normal) / square;
  const double    ofC = (b - a).cross(point - a).dot(normal) / square;
  Eigen::Vector3d shares(1.0 - ofB - ofC, ofB, ofC);
  shares = shares.cwiseMax(0.0);
  return shares / shares.sum();
}
} // namespace

FlatColonLocator::FlatColonLocator(const FlatColonGrid & grid) : m_Grid(grid), m_Surface(grid.Points(), grid.Faces()) {}

FlatColonLocator::~FlatColonLocator() = default;

FlatPlace
FlatColonLocator::Find(const Eigen::Vector3d & point) const
{
  const SurfaceLocator::Closest closest = m_Surface.FindClosest(point);
  FlatPlace                     place;
  place.face = closest.face;
  place.surfacePoint = closest.point;
  place.distance = closest.distance;
  place.uv = m_Grid.UvOfFacePoint(closest.face,
                                  BarycentricOfPoint(m_Grid.Points(), m_Grid.Faces(), closest.face, closest.point));
  place.pixel = m_Grid.PixelOfUv(place.uv);
  return place;
}
} // namespace shapeton
