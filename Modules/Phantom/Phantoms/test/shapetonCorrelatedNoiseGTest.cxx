#include "shapetonCorrelatedNoise.h"

#include <gtest/gtest.h>

namespace
{
constexpr int side = 80;

itk::ImageRegion<3>
Cube()
{
  itk::ImageRegion<3> region;
  region.SetIndex({ { 5, -3, 2 } });
  region.SetSize({ { side, side, side } });
  return region;
}

std::vector<float>
Noise(std::uint64_t seed)
{
  std::vector<float>              values(side * side * side, 0.0F);
  const shapeton::CorrelatedNoise noise(seed, Cube(), 25.0, { { 0.63, 0.14, 0.42 } });
  noise.AddTo(values, Cube());
  return values;
}

// Mean product of values `step` apart, divided by the requested variance.
double
Correlation(const std::vector<float> & values, std::size_t step, int lag)
{
  double      sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (i / step % side + lag < side)
    {
      sum += values[i] * values[i + lag * step];
      ++count;
    }
  }
  return sum / (625.0 * static_cast<double>(count));
}
} // namespace

TEST(CorrelatedNoise, HasTheDeviationAndTheCorrelationsAskedFor)
{
  const auto values = Noise(11);
  EXPECT_NEAR(Correlation(values, 1, 0), 1.0, 0.015);
  EXPECT_NEAR(Correlation(values, 1, 1), 0.63, 0.015);
  EXPECT_NEAR(Correlation(values, side, 1), 0.14, 0.015);
  EXPECT_NEAR(Correlation(values, side * side, 1), 0.42, 0.015);
  EXPECT_NEAR(Correlation(values, 1, 3), 0.0, 0.015);
  EXPECT_NEAR(Correlation(values, side, 3), 0.0, 0.015);
  double sum = 0.0;
  for (const float value : values)
  {
    sum += value;
  }
  EXPECT_NEAR(sum / static_cast<double>(values.size()), 0.0, 0.3);
}

TEST(CorrelatedNoise, DependsOnSeedAndIndexAlone)
{
  const auto whole = Noise(11);
  const auto other = Noise(12);
  EXPECT_NE(whole, other);
  itk::ImageRegion<3> piece;
  piece.SetIndex({ { 9, 0, 40 } });
  piece.SetSize({ { 20, 3, 4 } });
  std::vector<float>              part(20 * 3 * 4, 0.0F);
  const shapeton::CorrelatedNoise noise(11, Cube(), 25.0, { { 0.63, 0.14, 0.42 } });
  noise.AddTo(part, piece);
  for (int z = 0; z < 4; ++z)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int x = 0; x < 20; ++x)
      {
        const auto at = ((z + 38) * side + y + 3) * side + x + 4;
        EXPECT_EQ(part[(z * 3 + y) * 20 + x], whole[at]);
      }
    }
  }
}
