#ifndef shapetonPhantomSolid_h
#define shapetonPhantomSolid_h

#include "shapetonPhantomBody.h"

#include "itkVector.h"

#include <functional>
#include <vector>

namespace shapeton
{
/** A solid defined by signed distance: negative inside, first-order accurate near the surface. `distance` / `slope` is
 * a lower bound of the true distance. */
struct PhantomSolid
{
  using PointType = PhantomBody::PointType;
  std::function<double(const PointType &)> distance;
  double                                   slope{ 1.0 };
};

inline itk::Point<double, 3>
MakePoint(double x, double y, double z)
{
  const double values[3] = { x, y, z };
  return itk::Point<double, 3>(values);
}

inline itk::Vector<double, 3>
MakeVector(double x, double y, double z)
{
  const double values[3] = { x, y, z };
  return itk::Vector<double, 3>(values);
}

/** Exponent of cross-sections of the body: between an ellipse (2) and a rectangle. EllipsoidSolid() is fast for both.
 */
constexpr double bodyExponent = 2.5;

/** |x / a|^n + |y / b|^n + |z / c|^n = 1, n >= 2. */
PhantomSolid
EllipsoidSolid(const itk::Point<double, 3> & center, const itk::Vector<double, 3> & radii, double exponent = 2.0);

/** An infinite cylinder along z with such a cross-section. */
PhantomSolid
ColumnSolid(double x, double y, double a, double b, double exponent = 2.0);

PhantomSolid
CapsuleSolid(const itk::Point<double, 3> & from, const itk::Point<double, 3> & to, double radius);

/** A tube along a polyline with round ends. */
PhantomSolid
TubeSolid(const std::vector<itk::Point<double, 3>> & points, double radius);

/** Half space normal * p <= offset for a unit normal. */
PhantomSolid
HalfSpaceSolid(const itk::Vector<double, 3> & normal, double offset);

PhantomSolid
BoxSolid(const itk::Point<double, 3> & center, const itk::Vector<double, 3> & halfSize);

PhantomSolid
Both(const PhantomSolid & a, const PhantomSolid & b);
PhantomSolid
Either(const PhantomSolid & a, const PhantomSolid & b);
PhantomSolid
Without(const PhantomSolid & a, const PhantomSolid & b);

/** The solid dilated by `margin` mm; eroded if negative. */
PhantomSolid
Grown(const PhantomSolid & solid, double margin);

/** The points within `thickness` / 2 of the surface. */
PhantomSolid
ShellOf(const PhantomSolid & solid, double thickness);

/** A body of uniform intensity. */
std::shared_ptr<const PhantomBody>
MakeSolidBody(const PhantomSolid & solid, double intensity);

double
DistanceToSegment(const itk::Point<double, 3> & p, const itk::Point<double, 3> & a, const itk::Point<double, 3> & b);
} // namespace shapeton

#endif
