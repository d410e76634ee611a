#include "shapetonParticleKernels.h"
#include "shapetonPi.h"
#include "shapetonParticleMoments.h"

#include <cmath>

namespace shapeton
{
namespace ParticleKernels
{
namespace
{
/** The integral of (1 - u)^(3-j) u^j sin(theta) between two angles by eight-point Gauss quadrature: accurate to
 * rounding, because a polynomial of degree 15 approximates the sine that closely. */
double
Integral(int j, double from, double to)
{
  constexpr double nodes[4] = {
    0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959, 0.96028985649753623168
  };
  constexpr double weights[4] = {
    0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054, 0.10122853629037625915
  };
  const double half = 0.5 * (to - from);
  double       sum = 0.0;
  for (int node = 0; node < 8; ++node)
  {
    const double theta = from + half * (1.0 + (node < 4 ? nodes[node] : -nodes[node - 4]));
    const double u = theta * 2.0 / Pi;
    double       product = weights[node % 4] * std::sin(theta);
    for (int factor = 0; factor < 3; ++factor)
    {
      product *= factor < j ? u : 1.0 - u;
    }
    sum += product;
  }
  return sum * half;
}

/** The angle at which the integral from below, or from above, equals `integral`. */
double
AngleOf(int j, double integral, bool above)
{
  constexpr double right = 0.5 * Pi;
  double           low = 0.0;
  double           high = right;
  for (int bisection = 0; bisection < 50; ++bisection)
  {
    const double middle = 0.5 * (low + high);
    const bool   isLess = above ? Integral(j, middle, right) > integral : Integral(j, 0.0, middle) < integral;
    (isLess ? low : high) = middle;
  }
  return 0.5 * (low + high);
}
} // namespace

ThetaTable::ThetaTable()
{
  for (int j = 0; j < 4; ++j)
  {
    const double whole = Integral(j, 0.0, 0.5 * Pi);
    for (int i = 0; i <= ThetaTableSize; ++i)
    {
      const double place = static_cast<double>(i) / ThetaTableSize;
      const double integral = 0.5 * place * place * whole;
      const double half = std::sin(0.5 * AngleOf(j, integral, false));
      low[j][i] = static_cast<float>(2.0 * half * half);
      high[j][i] = static_cast<float>(std::cos(AngleOf(j, integral, true)));
    }
  }
}
} // namespace ParticleKernels
} // namespace shapeton
