#ifndef shapetonPhantomRandom_h
#define shapetonPhantomRandom_h

#include "shapetonPhilox.h"

namespace shapeton
{
/** Limits between which a number is drawn uniformly. */
struct DrawnRange
{
  double low;
  double high;
};

/** Random numbers that depend only on the seed, the stream and the number of previous draws. */
class PhantomRandom
{
public:
  PhantomRandom(unsigned seed, std::uint32_t stream) : m_Seed(seed), m_Stream(stream) {}

  /** Uniform in [low, high). */
  double
  Uniform(double low, double high)
  {
    const auto words = Philox4x32(m_Seed, PhiloxWords<std::uint32_t>{ m_Next++, m_Stream, 0x5ca17eU, 0 });
    return low + (high - low) * UnitFloat(words.a);
  }
  double
  Uniform(const DrawnRange & range)
  {
    return this->Uniform(range.low, range.high);
  }

private:
  std::uint64_t m_Seed;
  std::uint32_t m_Stream;
  std::uint32_t m_Next{ 0 };
};
} // namespace shapeton

#endif
