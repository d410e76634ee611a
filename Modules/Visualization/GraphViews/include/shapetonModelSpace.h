#ifndef shapetonModelSpace_h
#define shapetonModelSpace_h

#include "ShapetonGraphViewsExport.h"
#include "shapetonEmbeddingCertificate.h"

#include <vector>

namespace shapeton
{
/** A point of the unit sphere, or of the plane or the Poincare disk (z = 0). */
struct Place
{
  double x{ 0.0 };
  double y{ 0.0 };
  double z{ 0.0 };
};

inline double
Dot(const Place & p, const Place & q)
{
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

/** An isometry of the plane or the disk: z -> z + b, or z -> (a z + b) / (conj(b) z + conj(a)). */
struct Motion
{
  std::complex<double> a{ 1.0 };
  std::complex<double> b{ 0.0 };
};

/** Points, geodesics and circles of the sphere, the plane or the hyperbolic disk. */
class ShapetonGraphViews_EXPORT ModelSpace
{
public:
  explicit ModelSpace(EmbeddingGeometry geometry) : m_Geometry(geometry) {}

  EmbeddingGeometry
  Geometry() const
  {
    return m_Geometry;
  }

  /** The point at this fraction of the geodesic between two points. */
  Place
  Between(const Place & from, const Place & to, double share) const;

  /** `number` consecutive points of a circle. */
  std::vector<Place>
  Circle(const Place & center, double radius, int number) const;

  /** The point at this distance from `from`, in this direction of the chart; plane and disk only. */
  Place
  Walk(const Place & from, double direction, double distance) const;

  /** Sphere only: the point at this distance from `from` on the arc to `to`. */
  static Place
  OnArc(const Place & from, const Place & to, double distance);

  /** Half the angle at the center of a circle of radius r in the kite that it forms with a circle of radius s; plane
   * and disk only. */
  double
  HalfKiteAngle(double r, double s) const;

  /** Distance between the centers of orthogonal circles; plane and disk only. */
  double
  KiteDiagonal(double r, double s) const;

  Place
  Moved(const Motion & motion, const Place & place) const;

  /** Composition of two motions; `second` is applied first. */
  Motion
  Product(const Motion & first, const Motion & second) const;

  Motion
  Inverse(const Motion & motion) const;

private:
  EmbeddingGeometry m_Geometry;
};
} // namespace shapeton

#endif
