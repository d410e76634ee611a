#include "shapetonCounterNoise.h"

#include "shapetonPhilox.h"

#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double ln2 = 0.693147180559945309417232121458;

// The first 64 of the 128 bits of a block.
std::uint64_t
RandomBits(std::uint64_t seed, std::uint64_t counter)
{
  const auto words =
    Philox4x32(seed, { static_cast<std::uint32_t>(counter), static_cast<std::uint32_t>(counter >> 32), 0, 0 });
  return (std::uint64_t{ words.a } << 32) | words.b;
}

// ln x = e ln 2 + 2 artanh((m - 1) / (m + 1)), sqrt(1/2) <= m < sqrt(2).
double
Log(double x)
{
  int              exponent = 0;
  double           mantissa = std::frexp(x, &exponent);
  constexpr double sqrtOfHalf = 0.70710678118654752;
  if (mantissa < sqrtOfHalf)
  {
    mantissa *= 2.0;
    --exponent;
  }
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  double       sum = 0.0;
  for (int k = 23; k >= 1; k -= 2)
  {
    sum = sum * s * s + 1.0 / k;
  }
  return exponent * ln2 + 2.0 * s * sum;
}

// exp x = 2^k exp(r), |r| <= ln(2) / 2.
double
Exp(double x)
{
  const double k = std::floor(x / ln2 + 0.5);
  const double r = x - k * ln2;
  double       sum = 1.0;
  for (int n = 16; n >= 1; --n)
  {
    sum = 1.0 + sum * r / n;
  }
  return std::ldexp(sum, static_cast<int>(k));
}

template <std::size_t VSize>
double
Polynomial(const std::array<double, VSize> & coefficients, double x)
{
  double value = 0.0;
  for (const double coefficient : coefficients)
  {
    value = value * x + coefficient;
  }
  return value;
}

// Wichura, Algorithm AS 241, PPND16: relative accuracy about 1e-16. Coefficients in order of descending powers.
double
InverseNormalDistribution(double p)
{
  using Coefficients = std::array<double, 8>;
  constexpr Coefficients a{ { 2.5090809287301226727e+3,
                              3.3430575583588128105e+4,
                              6.7265770927008700853e+4,
                              4.5921953931549871457e+4,
                              1.3731693765509461125e+4,
                              1.9715909503065514427e+3,
                              1.3314166789178437745e+2,
                              3.3871328727963666080e+0 } };
  constexpr Coefficients b{ { 5.2264952788528545610e+3,
                              2.8729085735721942674e+4,
                              3.9307895800092710610e+4,
                              2.1213794301586595867e+4,
                              5.3941960214247511077e+3,
                              6.8718700749205790830e+2,
                              4.2313330701600911252e+1,
                              1.0 } };
  constexpr Coefficients c{ { 7.74545014278341407640e-4,
                              2.27238449892691845833e-2,
                              2.41780725177450611770e-1,
                              1.27045825245236838258e+0,
                              3.64784832476320460504e+0,
                              5.76949722146069140550e+0,
                              4.63033784615654529590e+0,
                              1.42343711074968357734e+0 } };
  constexpr Coefficients d{ { 1.05075007164441684324e-9,
                              5.47593808499534494600e-4,
                              1.51986665636164571966e-2,
                              1.48103976427480074590e-1,
                              6.89767334985100004550e-1,
                              1.67638483018380384940e+0,
                              2.05319162663775882187e+0,
                              1.0 } };
  constexpr Coefficients e{ { 2.01033439929228813265e-7,
                              2.71155556874348757815e-5,
                              1.24266094738807843860e-3,
                              2.65321895265761230930e-2,
                              2.96560571828504891230e-1,
                              1.78482653991729133580e+0,
                              5.46378491116411436990e+0,
                              6.65790464350110377720e+0 } };
  constexpr Coefficients f{ { 2.04426310338993978564e-15,
                              1.42151175831644588870e-7,
                              1.84631831751005468180e-5,
                              7.86869131145613259100e-4,
                              1.48753612908506148525e-2,
                              1.36929880922735805310e-1,
                              5.99832206555887937690e-1,
                              1.0 } };
  constexpr double       central = 0.425; // half width of the region around the median
  const double           q = p - 0.5;
  if (std::abs(q) <= central)
  {
    const double r = 0.180625 - q * q;
    return q * Polynomial(a, r) / Polynomial(b, r);
  }
  const double r = std::sqrt(-Log(q < 0.0 ? p : 1.0 - p));
  const double tail =
    r <= 5.0 ? Polynomial(c, r - 1.6) / Polynomial(d, r - 1.6) : Polynomial(e, r - 5.0) / Polynomial(f, r - 5.0);
  return q < 0.0 ? -tail : tail;
}
} // namespace

double
NormalNoise(std::uint64_t seed, std::uint64_t counter)
{
  // Midpoint of one of 2^52 equal parts of (0, 1): p and 1 - p are exact and nonzero.
  const std::uint64_t part = RandomBits(seed, counter) >> 12;
  return InverseNormalDistribution(std::ldexp(static_cast<double>(2 * part + 1), -std::numeric_limits<double>::digits));
}

// 1/2 + density(x) * (x + x^3/3 + x^5/(3*5) + ...), Marsaglia 2004.
double
NormalDistribution(double x)
{
  constexpr double certain = 8.0; // beyond, the distribution is 0 or 1 to within 1e-15
  if (std::abs(x) >= certain)
  {
    return x < 0.0 ? 0.0 : 1.0;
  }
  double sum = 0.0;
  double term = x;
  for (int k = 3; sum + term != sum; k += 2)
  {
    sum += term;
    term *= x * x / k;
  }
  constexpr double inverseSqrtOf2Pi = 0.398942280401432677939946059934;
  return 0.5 + inverseSqrtOf2Pi * Exp(-0.5 * x * x) * sum;
}
} // namespace shapeton
