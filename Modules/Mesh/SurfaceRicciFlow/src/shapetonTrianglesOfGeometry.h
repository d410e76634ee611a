#ifndef shapetonTrianglesOfGeometry_h
#define shapetonTrianglesOfGeometry_h

#include "shapetonRicciFlowWords.h"

#include <array>
#include <cmath>

namespace shapeton
{
/** Half-angle tangents of a triangle: entry k at corner k, side k from corner k to the next one. */
struct TriangleAngles
{
  std::array<double, 3> tangents{};
  bool                  isSound{ false };

  double
  Angle(int k) const
  {
    return 2.0 * std::atan(tangents[k]);
  }
  double
  Cosine(int k) const
  {
    const double square = tangents[k] * tangents[k];
    return (1.0 - square) / (1.0 + square);
  }
  double
  Sine(int k) const
  {
    return 2.0 * tangents[k] / (1.0 + tangents[k] * tangents[k]);
  }
};

/** x, sinh x or sin x: half the circumference of a circle of radius x, divided by pi. */
inline double
GeometricSine(RicciGeometry geometry, double x)
{
  return geometry == RicciGeometry::Euclidean ? x : geometry == RicciGeometry::Hyperbolic ? std::sinh(x) : std::sin(x);
}

/** Angles from side lengths by the half-angle formula tan^2 = S(p - b) S(p - c) / (S(p) S(p - a)), where p is half the
 * perimeter. `isSound` is false if a triangle inequality is violated. */
inline TriangleAngles
AnglesOfTriangle(RicciGeometry geometry, const std::array<double, 3> & sides)
{
  TriangleAngles              result;
  const std::array<double, 3> rests{ 0.5 * (sides[1] + sides[2] - sides[0]),
                                     0.5 * (sides[2] + sides[0] - sides[1]),
                                     0.5 * (sides[0] + sides[1] - sides[2]) };
  if (!(rests[0] > 0.0 && rests[1] > 0.0 && rests[2] > 0.0))
  {
    return result;
  }
  const double                whole = GeometricSine(geometry, rests[0] + rests[1] + rests[2]);
  const std::array<double, 3> s{ GeometricSine(geometry, rests[0]),
                                 GeometricSine(geometry, rests[1]),
                                 GeometricSine(geometry, rests[2]) };
  for (int k = 0; k < 3; ++k)
  {
    const int opposite = (k + 1) % 3;
    result.tangents[k] = std::sqrt(s[k] * s[(k + 2) % 3] / (whole * s[opposite]));
  }
  result.isSound = std::isfinite(result.tangents[0] + result.tangents[1] + result.tangents[2]) && whole > 0.0;
  return result;
}
} // namespace shapeton

#endif
