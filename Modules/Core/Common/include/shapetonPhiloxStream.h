#ifndef shapetonPhiloxStream_h
#define shapetonPhiloxStream_h

#include "shapetonPhilox.h"

namespace shapeton
{
/** \class PhiloxStream
 * \brief A sequential random number generator. The streams of a seed are independent; the sequence of a stream does not
 * depend on draws from other streams.
 * \ingroup ShapetonCommon */
class PhiloxStream
{
public:
  PhiloxStream(std::uint64_t seed, std::uint32_t stream, std::uint32_t purpose)
    : m_Key(seed), m_Stream(stream), m_Purpose(purpose)
  {}

  /** 32 uniform bits. */
  std::uint32_t
  Word()
  {
    if (m_Left == 0)
    {
      const auto words = Philox4x32(
        m_Key,
        PhiloxWords<std::uint32_t>{
          static_cast<std::uint32_t>(m_Counter), static_cast<std::uint32_t>(m_Counter >> 32), m_Stream, m_Purpose });
      ++m_Counter;
      m_Words[0] = words.a;
      m_Words[1] = words.b;
      m_Words[2] = words.c;
      m_Words[3] = words.d;
      m_Left = 4;
    }
    return m_Words[--m_Left];
  }

  /** Uniform in [0, n), for 1 <= n < 2^31; the largest deviation from uniform is n / 2^32. */
  int
  Below(int n)
  {
    return static_cast<int>((std::uint64_t{ Word() } * static_cast<std::uint32_t>(n)) >> 32);
  }

  /** Uniform in [0, 1), a multiple of 2^-32. */
  double
  Unit()
  {
    constexpr double values = 4294967296.0; // 2^32
    return Word() * (1.0 / values);
  }

private:
  std::uint64_t m_Key;
  std::uint64_t m_Counter{ 0 };
  std::uint32_t m_Stream;
  std::uint32_t m_Purpose;
  std::uint32_t m_Words[4]{};
  int           m_Left{ 0 };
};
} // namespace shapeton

#endif
