#include "shapetonShapeDistance.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace shape
{
namespace
{
double
Dot(const Vector & a, const Vector & b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double
Length(const Vector & a)
{
  return std::sqrt(Dot(a, a));
}

Vector
Minus(const Vector & a, const Vector & b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

// sqrt of a sum of squares instead of hypot, since it is correctly rounded and thus platform-independent.
double
Length(double a, double b)
{
  return std::sqrt(a * a + b * b);
}

double
Distance(const Sphere & sphere, const Vector & p)
{
  return Length(p) - sphere.radius;
}

double
Distance(const Ellipsoid & ellipsoid, const Vector & p)
{
  const Vector scaled{ { p[0] / ellipsoid.radii[0], p[1] / ellipsoid.radii[1], p[2] / ellipsoid.radii[2] } };
  return (Length(scaled) - 1.0) * *std::min_element(ellipsoid.radii.begin(), ellipsoid.radii.end());
}

double
Distance(const Box & box, const Vector & p)
{
  Vector beyond;
  for (unsigned int i = 0; i < 3; ++i)
  {
    beyond[i] = std::abs(p[i]) - box.halfSize[i];
  }
  const double inside = std::min(*std::max_element(beyond.begin(), beyond.end()), 0.0);
  for (double & value : beyond)
  {
    value = std::max(value, 0.0);
  }
  return Length(beyond) + inside;
}

double
Distance(const Cylinder & cylinder, const Vector & p)
{
  const double side = Length(p[0], p[1]) - cylinder.radius;
  const double end = std::abs(p[2]) - cylinder.halfLength;
  return Length(std::max(side, 0.0), std::max(end, 0.0)) + std::min(std::max(side, end), 0.0);
}

double
Distance(const Torus & torus, const Vector & p)
{
  return Length(Length(p[0], p[1]) - torus.ringRadius, p[2]) - torus.tubeRadius;
}

double
DistanceToSegment(const Vector & a, const Vector & b, const Vector & p)
{
  const Vector along = Minus(b, a);
  const Vector fromA = Minus(p, a);
  const double squared = Dot(along, along);
  const double t = squared > 0.0 ? std::clamp(Dot(fromA, along) / squared, 0.0, 1.0) : 0.0;
  return Length(Vector{ { fromA[0] - t * along[0], fromA[1] - t * along[1], fromA[2] - t * along[2] } });
}

double
Distance(const Tube & tube, const Vector & p)
{
  double least = DistanceToSegment(tube.points[0], tube.points[1], p);
  for (std::size_t i = 2; i < tube.points.size(); ++i)
  {
    least = std::min(least, DistanceToSegment(tube.points[i - 1], tube.points[i], p));
  }
  return least - tube.radius;
}

// The position of the point before the deformation.
Vector
Undo(const Bend & bend, const Vector & p)
{
  const double toCenter = bend.arcRadius - p[0];
  return { { bend.arcRadius - Length(toCenter, p[2]), p[1], bend.arcRadius * std::atan2(p[2], toCenter) } };
}

Vector
Undo(const Twist & twist, const Vector & p)
{
  const double c = std::cos(twist.rate * p[2]);
  const double s = std::sin(twist.rate * p[2]);
  return { { c * p[0] + s * p[1], c * p[1] - s * p[0], p[2] } };
}

Vector
Undo(const Bumps &, const Vector & p)
{
  return p;
}

double
Displacement(const Bumps & bumps, const Vector & p)
{
  const double k = bumps.waveNumber;
  return bumps.amplitude * std::sin(k * p[0]) * std::sin(k * p[1]) * std::sin(k * p[2]);
}

// A function with the sign of the signed distance, in object coordinates.
double
ImplicitValue(const Object & object, Vector p)
{
  double displacement = 0.0;
  for (auto deformation = object.deformations.rbegin(); deformation != object.deformations.rend(); ++deformation)
  {
    if (const auto * bumps = std::get_if<Bumps>(&*deformation))
    {
      displacement += Displacement(*bumps, p);
    }
    p = std::visit([&p](const auto & kind) { return Undo(kind, p); }, *deformation);
  }
  return std::visit([&p](const auto & primitive) { return Distance(primitive, p); }, object.primitive) - displacement;
}

// Uses the smaller one-sided difference, since a central difference may cross the gap of a bent object.
double
GradientLength(const Object & object, const Vector & p, double value)
{
  const double step = 1e-6 * object.boundingRadius;
  Vector       gradient;
  for (unsigned int i = 0; i < 3; ++i)
  {
    Vector before = p;
    Vector after = p;
    before[i] -= step;
    after[i] += step;
    const double backward = std::abs(value - ImplicitValue(object, before));
    const double forward = std::abs(ImplicitValue(object, after) - value);
    gradient[i] = std::min(backward, forward) / step;
  }
  return Length(gradient);
}

// A lower bound of the distance to the object, 0 inside the envelope. It improves f / |grad f| far from the surface,
// where space is stretched (at the center of a bend, far from the axis of a twist).
double
DistanceToEnvelope(const Object & object, Vector p)
{
  const Bend * const bend = object.deformations.empty() ? nullptr : std::get_if<Bend>(&object.deformations.back());
  if (bend)
  {
    p = Undo(*bend, p);
    p[2] = 0.0; // only distances perpendicular to the arc are preserved
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    p[i] = std::max(std::abs(p[i]) - object.envelope[i], 0.0);
  }
  return Length(p);
}

Vector
ToObjectFrame(const Object & object, const Vector & point)
{
  const Vector d = Minus(point, object.center);
  Vector       p{ { 0.0, 0.0, 0.0 } };
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      p[i] += object.rotation[j][i] * d[j]; // the transpose
    }
  }
  return p;
}

// ---- half extents ----

struct HalfExtentOf
{
  Vector
  operator()(const Sphere & sphere) const
  {
    return { { sphere.radius, sphere.radius, sphere.radius } };
  }
  Vector
  operator()(const Ellipsoid & ellipsoid) const
  {
    return ellipsoid.radii;
  }
  Vector
  operator()(const Box & box) const
  {
    return box.halfSize;
  }
  Vector
  operator()(const Cylinder & cylinder) const
  {
    return { { cylinder.radius, cylinder.radius, cylinder.halfLength } };
  }
  Vector
  operator()(const Torus & torus) const
  {
    const double outer = torus.ringRadius + torus.tubeRadius;
    return { { outer, outer, torus.tubeRadius } };
  }
  Vector
  operator()(const Tube & tube) const
  {
    Vector extent{ { 0.0, 0.0, 0.0 } };
    for (const auto & point : tube.points)
    {
      for (unsigned int i = 0; i < 3; ++i)
      {
        extent[i] = std::max(extent[i], std::abs(point[i]) + tube.radius);
      }
    }
    return extent;
  }
};

struct LocalBounds
{
  Vector center;
  double radius;
};

struct BoundsOf
{
  LocalBounds
  operator()(const Sphere & sphere) const
  {
    return { { { 0.0, 0.0, 0.0 } }, sphere.radius };
  }
  LocalBounds
  operator()(const Ellipsoid & ellipsoid) const
  {
    return { { { 0.0, 0.0, 0.0 } }, *std::max_element(ellipsoid.radii.begin(), ellipsoid.radii.end()) };
  }
  LocalBounds
  operator()(const Torus & torus) const
  {
    return { { { 0.0, 0.0, 0.0 } }, torus.ringRadius + torus.tubeRadius };
  }
  LocalBounds
  operator()(const Tube & tube) const
  {
    Vector lower = tube.points.front();
    Vector upper = lower;
    for (const auto & point : tube.points)
    {
      for (unsigned int i = 0; i < 3; ++i)
      {
        lower[i] = std::min(lower[i], point[i]);
        upper[i] = std::max(upper[i], point[i]);
      }
    }
    return { { { 0.5 * (lower[0] + upper[0]), 0.5 * (lower[1] + upper[1]), 0.5 * (lower[2] + upper[2]) } },
             0.5 * Length(Minus(upper, lower)) + tube.radius };
  }
  template <typename TPrimitive>
  LocalBounds
  operator()(const TPrimitive & primitive) const
  {
    return { { { 0.0, 0.0, 0.0 } }, Length(HalfExtentOf{}(primitive)) };
  }
};
} // namespace

Vector
HalfExtent(const Primitive & primitive)
{
  return std::visit(HalfExtentOf{}, primitive);
}

Vector
Envelope(const Object & object)
{
  Vector     extent = HalfExtent(object.primitive);
  const bool twisted =
    std::any_of(object.deformations.begin(), object.deformations.end(), [](const Deformation & deformation) {
      return std::holds_alternative<Twist>(deformation);
    });
  if (twisted)
  {
    extent[0] = extent[1] = Length(extent[0], extent[1]);
  }
  for (const auto & deformation : object.deformations)
  {
    if (const auto * bumps = std::get_if<Bumps>(&deformation))
    {
      for (double & value : extent)
      {
        // A twist in between mixes x and y.
        value += std::abs(bumps->amplitude) * (twisted ? std::sqrt(2.0) : 1.0);
      }
    }
  }
  return extent;
}

void
UpdateBounds(Object & object)
{
  object.envelope = Envelope(object);
  const LocalBounds bounds = std::visit(BoundsOf{}, object.primitive);
  Vector            center = bounds.center;
  double            radius = bounds.radius;
  if (!object.deformations.empty())
  {
    radius += Length(center);
    center = Vector{ { 0.0, 0.0, 0.0 } };
  }
  for (const auto & deformation : object.deformations)
  {
    if (std::holds_alternative<Bend>(deformation))
    {
      radius *= std::sqrt(2.0); // (x, z) maps to a point whose squared length is at most x^2 + z^2 (R - x) / R; |x| < R
    }
    else if (const auto * bumps = std::get_if<Bumps>(&deformation))
    {
      radius += std::abs(bumps->amplitude);
    }
  }
  for (unsigned int i = 0; i < 3; ++i)
  {
    object.boundingCenter[i] = object.center[i] + Dot(object.rotation[i], center);
  }
  object.boundingRadius = radius;
}

double
SignedDistance(const Object & object, const Vector & point)
{
  const Vector p = ToObjectFrame(object, point);
  const double value = ImplicitValue(object, p);
  if (object.deformations.empty() && !std::holds_alternative<Ellipsoid>(object.primitive))
  {
    return value;
  }
  const double distance = value / std::max(GradientLength(object, p, value), 1e-3);
  return distance > 0.0 ? std::max(distance, DistanceToEnvelope(object, p)) : distance;
}
} // namespace shape
} // namespace shapeton
