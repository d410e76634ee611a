#include "shapetonAxisTicks.h"

#include "shapetonCsvTable.h"
#include "shapetonReadableText.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace shapeton
{
namespace
{
/** Accepts values, best first, at a minimum distance from all accepted ones. */
template <typename TValue>
class TickCollector
{
public:
  TickCollector(double leastDistance, const PixelOf & pixelOf) : m_LeastDistance(leastDistance), m_PixelOf(pixelOf) {}

  /** Accepts the value if it is at least `distances` times the minimum distance away from all others. */
  void
  Offer(TValue value, double distances = 1.0)
  {
    const double pixel = m_PixelOf(static_cast<double>(value));
    const bool   isFree = std::all_of(m_Pixels.begin(), m_Pixels.end(), [&](double taken) {
      return std::fabs(taken - pixel) >= distances * m_LeastDistance;
    });
    if (isFree)
    {
      m_Pixels.push_back(pixel);
      m_Values.push_back(value);
    }
  }

  std::vector<TValue>
  Sorted() const
  {
    std::vector<TValue> values(m_Values);
    std::sort(values.begin(), values.end());
    return values;
  }

private:
  double              m_LeastDistance;
  const PixelOf &     m_PixelOf;
  std::vector<double> m_Pixels;
  std::vector<TValue> m_Values;
};

double
PowerOfTen(int exponent)
{
  double power = 1.0;
  for (int i = 0; i < std::abs(exponent); ++i)
  {
    power *= 10;
  }
  return exponent < 0 ? 1.0 / power : power;
}
} // namespace

std::vector<double>
HeatTicks(double lower, double upper, double leastDistance, const PixelOf & pixelOf)
{
  TickCollector<double> ticks(leastDistance, pixelOf);
  // Multipliers by roundness: one digit, then two, then three; three digits only where there is enough space.
  constexpr double                    room = 1.4;
  constexpr double                    muchRoom = 2.2;
  const std::vector<std::vector<int>> roundness{ { 1 }, { 2, 5 }, { 3, 4, 6, 7, 8, 9 } };
  if (lower == 0.0)
  {
    ticks.Offer(0.0);
  }
  const auto offer = [&](int multiplier, int exponent, double distances) {
    const double heat = exponent < 0 ? multiplier / PowerOfTen(-exponent) : multiplier * PowerOfTen(exponent);
    if (heat >= lower && heat <= upper)
    {
      ticks.Offer(heat, distances);
    }
  };
  for (const std::vector<int> & multipliers : roundness)
  {
    for (const int multiplier : multipliers)
    {
      for (int exponent = 0; exponent >= -5; --exponent)
      {
        offer(multiplier, exponent, 1.0);
      }
    }
  }
  constexpr int steps[] = { 5, 1 }; // of two digits
  for (const int step : steps)
  {
    for (int exponent = -1; exponent >= -6; --exponent)
    {
      for (int multiplier = 10 + step; multiplier < 100; multiplier += step)
      {
        offer(multiplier, exponent, room);
      }
    }
  }
  for (int exponent = -2; exponent >= -7; --exponent)
  {
    for (int multiplier = 101; multiplier < 1000; ++multiplier)
    {
      offer(multiplier, exponent, muchRoom);
    }
  }
  return ticks.Sorted();
}

std::vector<std::uint64_t>
TimeTicks(const std::vector<std::uint64_t> & timeSteps, double leastDistance, const PixelOf & pixelOf)
{
  TickCollector<std::uint64_t> ticks(leastDistance, pixelOf);
  const std::uint64_t          first = timeSteps.front();
  const std::uint64_t          last = timeSteps.back();
  ticks.Offer(last);
  ticks.Offer(first);
  const double  middle = static_cast<double>(timeSteps[timeSteps.size() / 2]);
  const bool    isLinear = 4.0 * (middle - static_cast<double>(first)) > static_cast<double>(last - first);
  std::uint64_t leading = 1;
  while (leading <= last / 10)
  {
    leading *= 10;
  }
  if (isLinear)
  {
    // Five to ten steps across the whole axis.
    constexpr std::uint64_t divisors[] = { 2, 5, 10, 20 };
    constexpr std::uint64_t fewestSteps = 5;
    const std::uint64_t     whole = last - first;
    std::uint64_t           step = leading;
    for (const std::uint64_t divisor : divisors)
    {
      step = whole / step < fewestSteps ? std::max<std::uint64_t>(leading / divisor, 1) : step;
    }
    for (std::uint64_t value = (first / step + 1) * step; value < last; value += step)
    {
      ticks.Offer(value);
    }
    return ticks.Sorted();
  }
  constexpr std::uint64_t multipliers[] = { 1, 5, 2 }; // by roundness
  for (const std::uint64_t multiplier : multipliers)
  {
    for (std::uint64_t decade = leading; decade >= 1; decade /= 10)
    {
      if (multiplier * decade > first && multiplier * decade < last)
      {
        ticks.Offer(multiplier * decade);
      }
    }
  }
  return ticks.Sorted();
}

std::vector<double>
RoundTicks(double lower, double upper, int greatestNumber)
{
  std::vector<double> ticks;
  if (!(upper > lower) || !std::isfinite(upper - lower) || greatestNumber < 1)
  {
    return ticks;
  }
  constexpr double ten = 10.0;
  constexpr int    five = 5;
  const double     least = (upper - lower) / greatestNumber;
  int              exponent = static_cast<int>(std::floor(std::log10(least))) - 1;
  int              digit = 1;
  while (digit * std::pow(ten, exponent) < least * (1.0 - 1e-9))
  {
    exponent += digit == five ? 1 : 0;
    digit = digit == 1 ? 2 : digit == 2 ? five : 1;
  }
  const double step = digit * PowerOfTen(exponent);
  const double tolerance = 1e-9 * greatestNumber;
  for (double k = std::ceil(lower / step - tolerance); k * step <= upper + tolerance * step; k += 1.0)
  {
    ticks.push_back(k * step + 0.0); // avoids -0
  }
  return ticks;
}

std::string
HeatLabel(double heat, int digits)
{
  return PlainNumber(CsvTable::Rounded(heat, digits));
}

std::string
GroupedDigits(std::uint64_t value)
{
  std::string text = std::to_string(value);
  for (int place = static_cast<int>(text.size()) - 3; place > 0; place -= 3)
  {
    text.insert(place, " ");
  }
  return text;
}
} // namespace shapeton
