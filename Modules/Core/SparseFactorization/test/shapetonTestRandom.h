#ifndef shapetonTestRandom_h
#define shapetonTestRandom_h

#include <cmath>
#include <cstdint>
#include <random>

namespace shapeton
{
namespace test
{
/** Platform-independent random numbers. */
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_Engine(seed) {}
  int
  Below(int n)
  {
    return static_cast<int>(m_Engine() % static_cast<std::uint64_t>(n));
  }
  /** Random number in [-1, 1). */
  double
  Signed()
  {
    return std::ldexp(static_cast<double>(m_Engine() >> 11), -52) - 1.0;
  }

private:
  std::mt19937_64 m_Engine;
};
} // namespace test
} // namespace shapeton

#endif
