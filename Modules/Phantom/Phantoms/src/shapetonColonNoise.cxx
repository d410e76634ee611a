#include "shapetonColonNoise.h"

#include "shapetonCubicBSpline.h"
#include "shapetonPhilox.h"
#include "shapetonPi.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr double c_Words = 4294967296.0; // 2^32, the number of values of a word
constexpr double c_LargestCoefficient =
  1.5; // bound of the random coefficients of splines, so that the noise is in about [-1, 1]
} // namespace

ColonRandom::ColonRandom(unsigned seed, ColonStream stream, unsigned position)
  : m_Key((std::uint64_t{ seed } << 32) | static_cast<std::uint32_t>(stream)), m_Position(position)
{}

double
ColonRandom::Uniform()
{
  const auto words = Philox4x32(m_Key, { m_Index, m_Draw++, m_Position, 0xC0104U });
  return (words.a + words.b * (1.0 / c_Words)) * (1.0 / c_Words);
}

double
ColonRandom::Uniform(double low, double high)
{
  return low + (high - low) * this->Uniform();
}

double
ColonRandom::Normal()
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - this->Uniform()));
  return radius * std::cos(TwoPi * this->Uniform());
}

void
ColonRandom::Seek(std::uint32_t index)
{
  m_Index = index;
  m_Draw = 0;
}

SmoothNoise::SmoothNoise(ColonRandom & random, double length, double knotDistance)
  : m_KnotDistance(knotDistance), m_Coefficients(static_cast<std::size_t>(std::ceil(length / knotDistance)) + 4)
{
  for (double & c : m_Coefficients)
  {
    c = random.Uniform(-c_LargestCoefficient, c_LargestCoefficient);
  }
}

double
SmoothNoise::operator()(double x) const
{
  const double       t = std::max(0.0, x / m_KnotDistance);
  const std::size_t  last = m_Coefficients.size() - 4;
  const std::size_t  i = std::min(static_cast<std::size_t>(t), last);
  const CubicWeights w(std::min(t - i, 1.0));
  double             sum = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    sum += w.value[k] * m_Coefficients[i + k];
  }
  return sum;
}

double
SmoothStep(double a, double b, double x)
{
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
} // namespace shapeton
