#include "shapetonPhantomSolid.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using PointType = PhantomBody::PointType;

constexpr double farAway = 15.0; // mm

class SolidBody : public PhantomBody
{
public:
  SolidBody(PhantomSolid solid, double intensity) : m_Solid(std::move(solid)), m_Intensity(intensity) {}

  BodyProbe
  Probe(const PointType & point) const override
  {
    const double distance = m_Solid.distance(point) / m_Solid.slope;
    return { distance, std::abs(distance) };
  }

  double
  Intensity(const PointType &) const override
  {
    return m_Intensity;
  }

  void
  Paint(const PointType & point, double width, double & value) const override
  {
    value += ShareInside(m_Solid.distance(point), width) * (m_Intensity - value);
  }

private:
  PhantomSolid m_Solid;
  double       m_Intensity;
};

// The only exponents in use are 2 and bodyExponent; x * x * sqrt(x) is x to the power of bodyExponent.
static_assert(bodyExponent == 2.0 + 1.0 / 2.0);
double
Power(double x, double exponent)
{
  return exponent == 2.0 ? x * x : (exponent == bodyExponent ? x * x * std::sqrt(x) : std::pow(x, exponent));
}

double
PowerLessOne(double x, double exponent)
{
  return exponent == 2.0 ? x : (exponent == bodyExponent ? x * std::sqrt(x) : std::pow(x, exponent - 1.0));
}
} // namespace

PhantomBody::~PhantomBody() = default;

// First-order distance (k - 1) / |grad k| of the norm k = |p / radii|, whose gradient is at most 1 / shortest. In three
// dimensions, the gradient of a norm with exponent n is at least 3^(1/n - 1/2) / longest.
PhantomSolid
EllipsoidSolid(const PointType & center, const itk::Vector<double, 3> & radii, double exponent)
{
  const double shortest = std::min({ radii[0], radii[1], radii[2] });
  const double longest = std::max({ radii[0], radii[1], radii[2] });
  const auto   distance = [=](const PointType & p) {
    double scaled[3];
    double sum = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      scaled[i] = std::abs(p[i] - center[i]) / radii[i];
      sum += Power(scaled[i], exponent);
    }
    const double     k = exponent == 2.0 ? std::sqrt(sum) : std::pow(sum, 1.0 / exponent);
    constexpr double atCenter = 1e-6; // the gradient vanishes
    if (k < atCenter)
    {
      return -shortest;
    }
    double squared = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double ratio = scaled[i] / k;
      const double partial = PowerLessOne(ratio, exponent) / radii[i];
      squared += partial * partial;
    }
    return (k - 1.0) / std::sqrt(squared);
  };
  return { distance, std::pow(3.0, 0.5 - 1.0 / exponent) * longest / shortest };
}

PhantomSolid
ColumnSolid(double x, double y, double a, double b, double exponent)
{
  const double radii[3] = { a, b, std::max(a, b) };
  PhantomSolid section = EllipsoidSolid(MakePoint(x, y, 0.0), itk::Vector<double, 3>(radii), exponent);
  const auto   distance = section.distance;
  return { [distance](const PointType & p) { return distance(MakePoint(p[0], p[1], 0.0)); }, section.slope };
}

double
DistanceToSegment(const PointType & p, const PointType & a, const PointType & b)
{
  const auto   along = b - a;
  const double squared = along.GetSquaredNorm();
  const double t = squared > 0.0 ? std::clamp(((p - a) * along) / squared, 0.0, 1.0) : 0.0;
  return (p - (a + along * t)).GetNorm();
}

PhantomSolid
CapsuleSolid(const PointType & from, const PointType & to, double radius)
{
  return { [=](const PointType & p) { return DistanceToSegment(p, from, to) - radius; } };
}

PhantomSolid
TubeSolid(const std::vector<PointType> & points, double radius)
{
  return { [=](const PointType & p) {
    double least = (p - points.front()).GetNorm();
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      least = std::min(least, DistanceToSegment(p, points[i - 1], points[i]));
    }
    return least - radius;
  } };
}

PhantomSolid
HalfSpaceSolid(const itk::Vector<double, 3> & normal, double offset)
{
  return { [=](const PointType & p) { return normal * p.GetVectorFromOrigin() - offset; } };
}

PhantomSolid
BoxSolid(const PointType & center, const itk::Vector<double, 3> & halfSize)
{
  return { [=](const PointType & p) {
    double inside = -1e9;
    double outside = 0.0;
    for (unsigned int i = 0; i < 3; ++i)
    {
      const double d = std::abs(p[i] - center[i]) - halfSize[i];
      inside = std::max(inside, d);
      outside += d > 0.0 ? d * d : 0.0;
    }
    return inside > 0.0 ? std::sqrt(outside) : inside;
  } };
}

// If one distance is large, the other is not evaluated, since each one is a bound of the true distance.
PhantomSolid
Both(const PhantomSolid & a, const PhantomSolid & b)
{
  return { [first = a.distance, second = b.distance](const PointType & p) {
            const double distance = first(p);
            return distance > farAway ? distance : std::max(distance, second(p));
          },
           std::max(a.slope, b.slope) };
}

PhantomSolid
Without(const PhantomSolid & a, const PhantomSolid & b)
{
  return { [first = a.distance, second = b.distance](const PointType & p) {
            const double distance = first(p);
            return distance > farAway ? distance : std::max(distance, -second(p));
          },
           std::max(a.slope, b.slope) };
}

PhantomSolid
Either(const PhantomSolid & a, const PhantomSolid & b)
{
  return { [first = a.distance, second = b.distance](const PointType & p) { return std::min(first(p), second(p)); },
           std::max(a.slope, b.slope) };
}

PhantomSolid
Grown(const PhantomSolid & solid, double margin)
{
  return { [distance = solid.distance, margin](const PointType & p) { return distance(p) - margin; }, solid.slope };
}

PhantomSolid
ShellOf(const PhantomSolid & solid, double thickness)
{
  return { [distance = solid.distance, thickness](const PointType & p) {
            return std::abs(distance(p)) - 0.5 * thickness;
          },
           solid.slope };
}

std::shared_ptr<const PhantomBody>
MakeSolidBody(const PhantomSolid & solid, double intensity)
{
  return std::make_shared<SolidBody>(solid, intensity);
}
} // namespace shapeton
