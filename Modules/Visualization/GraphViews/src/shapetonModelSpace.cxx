#include "shapetonModelSpace.h"

#include "shapetonPi.h"

#include <cmath>

namespace shapeton
{
namespace
{
using Complex = std::complex<double>;

Place
Unit(const Place & p)
{
  const double length = std::sqrt(Dot(p, p));
  return { p.x / length, p.y / length, p.z / length };
}

Place
Combination(double a, const Place & p, double b, const Place & q)
{
  return { a * p.x + b * q.x, a * p.y + b * q.y, a * p.z + b * q.z };
}

/** Direction at p of the arc to q. */
Place
Tangent(const Place & p, const Place & q)
{
  const Place chord = Combination(1.0, q, -1.0, p);
  return Unit(Combination(1.0, chord, -Dot(chord, p), p));
}

Complex
Number(const Place & p)
{
  return { p.x, p.y };
}

Place
PlaceOf(Complex z)
{
  return { z.real(), z.imag(), 0.0 };
}

/** Moebius transformation of the disk that maps 0 to z. */
Complex
FromCenter(Complex z, Complex w)
{
  return (w + z) / (1.0 + std::conj(z) * w);
}

double
Angle(const Place & p, const Place & q)
{
  const Place sum = Combination(1.0, p, 1.0, q);
  const Place difference = Combination(1.0, p, -1.0, q);
  return 2.0 * std::atan2(std::sqrt(Dot(difference, difference)), std::sqrt(Dot(sum, sum)));
}
} // namespace

Place
ModelSpace::OnArc(const Place & from, const Place & to, double distance)
{
  return Unit(Combination(std::cos(distance), from, std::sin(distance), Tangent(from, to)));
}

Place
ModelSpace::Between(const Place & from, const Place & to, double share) const
{
  if (m_Geometry == EmbeddingGeometry::Spherical)
  {
    const double angle = Angle(from, to);
    return angle > 1e-12 ? OnArc(from, to, share * angle) : from;
  }
  if (m_Geometry == EmbeddingGeometry::Euclidean)
  {
    return Combination(1.0 - share, from, share, to);
  }
  const Complex w = FromCenter(-Number(from), Number(to)); // the geodesic is straight in the chart centered at `from`
  const double  length = std::abs(w);
  const Complex part = length > 0.0 ? w / length * std::tanh(share * std::atanh(std::min(length, 1.0 - 1e-16))) : w;
  return PlaceOf(FromCenter(Number(from), part));
}

std::vector<Place>
ModelSpace::Circle(const Place & center, double radius, int number) const
{
  std::vector<Place> points;
  const Place        x = Unit(std::abs(center.x) < 0.7 ? Combination(1.0, { 1.0, 0.0, 0.0 }, -center.x, center)
                                                : Combination(1.0, { 0.0, 1.0, 0.0 }, -center.y, center));
  const Place y{ center.y * x.z - center.z * x.y, center.z * x.x - center.x * x.z, center.x * x.y - center.y * x.x };
  for (int i = 0; i < number; ++i)
  {
    const double angle = 2.0 * Pi * i / number;
    if (m_Geometry == EmbeddingGeometry::Spherical)
    {
      const Place direction = Combination(std::cos(angle), x, std::sin(angle), y);
      points.push_back(Combination(std::cos(radius), center, std::sin(radius), direction));
    }
    else
    {
      points.push_back(this->Walk(center, angle, radius));
    }
  }
  return points;
}

Place
ModelSpace::Walk(const Place & from, double direction, double distance) const
{
  if (m_Geometry == EmbeddingGeometry::Euclidean)
  {
    return PlaceOf(Number(from) + std::polar(distance, direction));
  }
  return PlaceOf(FromCenter(Number(from), std::polar(std::tanh(0.5 * distance), direction)));
}

double
ModelSpace::HalfKiteAngle(double r, double s) const
{
  return m_Geometry == EmbeddingGeometry::Euclidean ? std::atan2(s, r) : std::atan2(std::tanh(s), std::sinh(r));
}

double
ModelSpace::KiteDiagonal(double r, double s) const
{
  if (m_Geometry == EmbeddingGeometry::Euclidean)
  {
    return std::hypot(r, s);
  }
  const double a = std::sinh(0.5 * r) * std::sinh(0.5 * r); // cosh l = cosh r cosh s without cancellation
  const double b = std::sinh(0.5 * s) * std::sinh(0.5 * s);
  return 2.0 * std::asinh(std::sqrt(a + b + 2.0 * a * b));
}

Place
ModelSpace::Moved(const Motion & motion, const Place & place) const
{
  switch (m_Geometry)
  {
    case EmbeddingGeometry::Spherical:
      return place;
    case EmbeddingGeometry::Euclidean:
      return PlaceOf(Number(place) + motion.b);
    default:
      return PlaceOf((motion.a * Number(place) + motion.b) /
                     (std::conj(motion.b) * Number(place) + std::conj(motion.a)));
  }
}

Motion
ModelSpace::Product(const Motion & first, const Motion & second) const
{
  if (m_Geometry == EmbeddingGeometry::Euclidean)
  {
    return { 1.0, first.b + second.b };
  }
  return { first.a * second.a + first.b * std::conj(second.b), first.a * second.b + first.b * std::conj(second.a) };
}

Motion
ModelSpace::Inverse(const Motion & motion) const
{
  return { std::conj(motion.a), -motion.b };
}
} // namespace shapeton
