#include "shapetonPhilox.h"

#include "gtest/gtest.h"

#include <cmath>
#include <vector>

namespace
{
void
ExpectWords(const shapeton::PhiloxWords<std::uint32_t> & words,
            std::uint32_t                                a,
            std::uint32_t                                b,
            std::uint32_t                                c,
            std::uint32_t                                d)
{
  EXPECT_EQ(words.a, a);
  EXPECT_EQ(words.b, b);
  EXPECT_EQ(words.c, c);
  EXPECT_EQ(words.d, d);
}
} // namespace

// Published test vectors of Random123 (kat_vectors, philox4x32, 10 rounds).
TEST(Philox, GivesThePublishedAnswers)
{
  ExpectWords(shapeton::Philox4x32(0, { 0, 0, 0, 0 }), 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8);
  constexpr std::uint32_t ones = 0xffffffff;
  ExpectWords(shapeton::Philox4x32(~std::uint64_t{ 0 }, { ones, ones, ones, ones }),
              0x408f276d,
              0x41c83b0e,
              0xa20bc7c6,
              0x6d5451fd);
  ExpectWords(shapeton::Philox4x32(0x299f31d0a4093822, { 0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344 }),
              0xd16cfe09,
              0x94fdcceb,
              0x5001e420,
              0x24126ea1);
}

TEST(Philox, UnitFloatsFillTheIntervalEvenly)
{
  EXPECT_EQ(shapeton::UnitFloat(0), 0.0F);
  EXPECT_LT(shapeton::UnitFloat(0xffffffff), 1.0F);
  constexpr unsigned int bins = 64;
  constexpr unsigned int draws = 1U << 20;
  std::vector<double>    counts(bins, 0.0);
  for (std::uint32_t i = 0; i < draws; ++i)
  {
    ++counts[static_cast<std::size_t>(shapeton::UnitFloat(shapeton::Philox4x32(7, { i, 0, 0, 0 }).a) * bins)];
  }
  double chiSquare = 0.0;
  for (const double count : counts)
  {
    chiSquare += (count - draws / bins) * (count - draws / bins) / (draws / bins);
  }
  // 63 degrees of freedom: fewer than one run in a million deviates by more than 5 standard deviations.
  EXPECT_NEAR(chiSquare, bins - 1.0, 5.0 * std::sqrt(2.0 * (bins - 1.0)));
}
