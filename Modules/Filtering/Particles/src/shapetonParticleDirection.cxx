#include "shapetonParticleDirection.h"
#include "shapetonPi.h"
#include "shapetonParticleMoments.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using namespace ParticleMoments;

constexpr double halfPi = 0.5 * Pi;

/** g0 + g1 s + g2 s^2 + g3 s^3: the volume per unit of s (8.5, differentiated), with s = 2 phi / pi. Bernstein form: no
 * coefficient is negative. */
struct VolumeDensity
{
  VolumeDensity(double w1, double w2, double w3)
  {
    // R^3 integrated over theta is sum_j moment[j] w1^(3-j) W^j, and W runs from w2 to w3.
    const double a = moment[0] * w1 * w1 * w1;
    const double b = moment[1] * w1 * w1;
    const double c = moment[2] * w1;
    const double d = moment[3];
    bernstein = { a + b * w2 + c * w2 * w2 + d * w2 * w2 * w2,
                  a + b * (2 * w2 + w3) / 3 + c * (w2 * w2 + 2 * w2 * w3) / 3 + d * w2 * w2 * w3,
                  a + b * (w2 + 2 * w3) / 3 + c * (w3 * w3 + 2 * w2 * w3) / 3 + d * w2 * w3 * w3,
                  a + b * w3 + c * w3 * w3 + d * w3 * w3 * w3 };
  }

  double
  At(double s) const
  {
    const double r = 1.0 - s;
    return bernstein[0] * r * r * r + 3 * bernstein[1] * r * r * s + 3 * bernstein[2] * r * s * s +
           bernstein[3] * s * s * s;
  }

  /** The integral from 0 to s, as a Bernstein polynomial of degree 4. */
  double
  Below(double s) const
  {
    const double r = 1.0 - s;
    const double e1 = bernstein[0];
    const double e2 = e1 + bernstein[1];
    const double e3 = e2 + bernstein[2];
    const double e4 = e3 + bernstein[3];
    return 0.25 * s * (4 * e1 * r * r * r + 6 * e2 * r * r * s + 4 * e3 * r * s * s + e4 * s * s * s);
  }

  std::array<double, 4> bernstein;
};

/** The zero in [0, upper] of an increasing function from its value and slope: Newton's method, with bisection if it
 * would leave the bracket or converge slowly. */
template <typename TFunction, typename TSlope>
double
FindZero(const TFunction & function, const TSlope & slope, double upper)
{
  double low = 0.0;
  double high = upper;
  double x = 0.5 * upper;
  for (int iteration = 0; iteration < 200 && high - low > 1e-16 * upper; ++iteration)
  {
    const double value = function(x);
    (value < 0.0 ? low : high) = x;
    double next = x - value / slope(x);
    if (!(next > low && next < high))
    {
      next = 0.5 * (low + high);
    }
    if (next == x || value == 0.0)
    {
      break;
    }
    x = next;
  }
  return x;
}

double
Cube(double x)
{
  return x * x * x;
}
} // namespace

/** \equation{3.4} in closed form.
 *
 * \equation{8.6} as a Bernstein polynomial, whose terms are all positive. */
double
OctantVolume(double w1, double w2, double w3)
{
  return PartialOctantVolume(w1, w2, w3, halfPi);
}

/** \equation{8.1}
 *
 * \equation{8.2}
 *
 * \equation{8.5} as a Bernstein polynomial, whose terms are all positive. */
double
PartialOctantVolume(double w1, double w2, double w3, double phi)
{
  return halfPi / 3.0 * VolumeDensity(w1, w2, w3).Below(phi / halfPi);
}

double
PhiOfPartialVolume(double w1, double w2, double w3, double volume)
{
  const VolumeDensity density(w1, w2, w3);
  const double        whole = density.Below(1.0);
  const double        wanted = whole <= 0.0 ? 0.0 : std::clamp(volume / (halfPi / 3.0 * whole), 0.0, 1.0) * whole;
  if (whole <= 0.0 || wanted <= 0.0 || wanted >= whole)
  {
    return whole <= 0.0 ? 0.5 * halfPi : wanted <= 0.0 ? 0.0 : halfPi;
  }
  return halfPi *
         FindZero([&](double s) { return density.Below(s) - wanted; }, [&](double s) { return density.At(s); }, 1.0);
}

/** \equation{3.8} in closed form.
 *
 * \equation{3.9}
 *
 * \equation{8.7} regrouped. */
double
SectorArea(double w1, double w2, double theta)
{
  const double u = theta / halfPi;
  const double radius = w1 * (1.0 - u) + w2 * u;
  return theta / 6.0 * (w1 * w1 + w1 * radius + radius * radius);
}

double
ThetaOfSectorArea(double w1, double w2, double area)
{
  const double whole = SectorArea(w1, w2, halfPi);
  if (!(whole > 0.0))
  {
    return 0.5 * halfPi;
  }
  // The cube of the radius is linear in the area; the angle is computed from it without cancellation.
  const double share = std::clamp(area / whole, 0.0, 1.0);
  const double radius = std::cbrt(Cube(w1) * (1.0 - share) + Cube(w2) * share);
  const double denominator = w1 * w1 + w1 * radius + radius * radius;
  return denominator > 0.0 ? std::min(halfPi, halfPi * share * (w1 * w1 + w1 * w2 + w2 * w2) / denominator) : 0.0;
}

/** \equation{3.5} as `radius`.
 *
 * \equation{8.3} as `radius`. */
double
SectorVolume(double w1, double w2, double theta)
{
  // By parts, three times: the derivative of R by theta is the constant `slope`.
  const double slope = (w2 - w1) / halfPi;
  const double radius = w1 + slope * theta;
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  const double upper = (6.0 * slope * slope - radius * radius) * radius * cosine +
                       3.0 * (radius * radius - 2.0 * slope * slope) * slope * sine;
  const double lower = (6.0 * slope * slope - w1 * w1) * w1;
  return (upper - lower) / 3.0;
}

double
ThetaOfSectorVolume(double w1, double w2, double volume)
{
  const double whole = SectorVolume(w1, w2, halfPi);
  const double wanted = std::clamp(volume, 0.0, std::max(whole, 0.0));
  if (!(whole > 0.0) || wanted <= 0.0 || wanted >= whole)
  {
    return !(whole > 0.0) ? 0.5 * halfPi : wanted <= 0.0 ? 0.0 : halfPi;
  }
  return FindZero([&](double theta) { return SectorVolume(w1, w2, theta) - wanted; },
                  [&](double theta) {
                    const double u = theta / halfPi;
                    return Cube(w1 * (1.0 - u) + w2 * u) / 3.0 * std::sin(theta);
                  },
                  halfPi);
}

/** \equation{3.6} as `across`.
 *
 * \equation{3.7}
 *
 * \equation{8.4} as `across`. */
std::array<double, 3>
DrawDirection(const EdgeWeights & weights, DirectionSampling sampling, const std::array<double, 3> & random)
{
  const EdgeWeights     even{ { 1, 1, 1, 1, 1, 1 } };
  const EdgeWeights &   w = sampling == DirectionSampling::Uniform ? even : weights;
  std::array<double, 8> volumes{};
  double                whole = 0.0;
  for (unsigned int octant = 0; octant < 8; ++octant)
  {
    volumes[octant] = OctantVolume(w[octant & 1], w[2 + (octant >> 1 & 1)], w[4 + (octant >> 2)]);
    whole += volumes[octant];
  }
  if (!(whole > 0.0) || std::all_of(weights.begin(), weights.end(), [](double weight) { return weight <= 0.0; }))
  {
    return {};
  }
  // Summed in the order of `whole`, so that rounding never selects an empty octant beyond the last one.
  unsigned int octant = 0;
  double       below = volumes[0];
  while (octant < 7 && random[0] * whole > below)
  {
    below += volumes[++octant];
  }
  const double w1 = w[octant & 1];
  const double w2 = w[2 + (octant >> 1 & 1)];
  const double w3 = w[4 + (octant >> 2)];
  const double phi = PhiOfPartialVolume(w1, w2, w3, random[1] * volumes[octant]);
  const double across = w2 * (1.0 - phi / halfPi) + w3 * phi / halfPi;
  const double theta = sampling == DirectionSampling::SectorArea
                         ? ThetaOfSectorArea(w1, across, random[2] * SectorArea(w1, across, halfPi))
                         : ThetaOfSectorVolume(w1, across, random[2] * SectorVolume(w1, across, halfPi));
  return { { (octant & 1 ? 1 : -1) * std::cos(theta),
             (octant >> 1 & 1 ? 1 : -1) * std::sin(theta) * std::cos(phi),
             (octant >> 2 ? 1 : -1) * std::sin(theta) * std::sin(phi) } };
}
} // namespace shapeton
