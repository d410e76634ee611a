#ifndef shapetonPhilox_h
#define shapetonPhilox_h

#include "shapetonHostDevice.h"

#include <cstdint>

namespace shapeton
{
/** Four words: a counter, or the random numbers generated from it.
 * \ingroup ShapetonCommon */
template <typename TWord>
struct PhiloxWords
{
  TWord a;
  TWord b;
  TWord c;
  TWord d;
};

/** The product of two 32-bit numbers as two words.
 * \ingroup ShapetonCommon */
struct PhiloxMultiply
{
  SHAPETON_HOST_DEVICE void
  operator()(std::uint32_t x, std::uint32_t factor, std::uint32_t & high, std::uint32_t & low) const
  {
    const std::uint64_t product = std::uint64_t{ x } * factor;
    high = static_cast<std::uint32_t>(product >> 32);
    low = static_cast<std::uint32_t>(product);
  }
};

/** The block of random words for a key and a counter: Philox4x32-10, ten rounds of multiply, xor and swap (Salmon et
 * al., SC 2011). All 128 bits are uniform; blocks of different counters are independent.
 *
 * `TWord` is an unsigned 32-bit integer, or a vector of them that works element by element; `TMultiply` multiplies a
 * `TWord` by a number. \ingroup ShapetonCommon */
template <typename TWord, typename TMultiply = PhiloxMultiply>
SHAPETON_HOST_DEVICE PhiloxWords<TWord>
                     Philox4x32(std::uint64_t key, PhiloxWords<TWord> x, const TMultiply & multiply = TMultiply())
{
  constexpr std::uint32_t factor0 = 0xD2511F53U, factor1 = 0xCD9E8D57U; // as published
  constexpr std::uint32_t weyl0 = 0x9E3779B9U, weyl1 = 0xBB67AE85U;
  auto                    key0 = static_cast<std::uint32_t>(key);
  auto                    key1 = static_cast<std::uint32_t>(key >> 32);
  for (int round = 0; round < 10; ++round)
  {
    TWord high0, low0, high1, low1;
    multiply(x.a, factor0, high0, low0);
    multiply(x.c, factor1, high1, low1);
    x = { high1 ^ x.b ^ key0, low1, high0 ^ x.d ^ key1, low0 };
    key0 += weyl0;
    key1 += weyl1;
  }
  return x;
}

SHAPETON_HOST_DEVICE PhiloxWords<std::uint32_t>
                     Philox4x32(std::uint64_t key, const PhiloxWords<std::uint32_t> & counter)
{
  return Philox4x32<std::uint32_t>(key, counter, PhiloxMultiply());
}

/** The 24 high bits of a word, scaled to [0, 1).
 * \ingroup ShapetonCommon */
SHAPETON_HOST_DEVICE float
UnitFloat(std::uint32_t word)
{
  constexpr float values = 16777216.0F; // 2^24
  return static_cast<float>(word >> 8) * (1.0F / values);
}
} // namespace shapeton

#endif
