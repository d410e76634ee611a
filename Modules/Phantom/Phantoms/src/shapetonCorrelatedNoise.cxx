#include "shapetonCorrelatedNoise.h"

#include "shapetonCounterNoise.h"

#include <cmath>

namespace shapeton
{
namespace
{
// The smaller solution of 2 a / (1 + 2 a^2) = correlation.
double
SideWeight(double correlation)
{
  return correlation <= 0.0 ? 0.0 : (1.0 - std::sqrt(1.0 - 2.0 * correlation * correlation)) / (2.0 * correlation);
}

// Filters an array [outer][length][inner] along the middle axis, which is shortened by two layers.
std::vector<float>
FilterAxis(const std::vector<float> & in, std::size_t outer, std::size_t length, std::size_t inner, double side)
{
  const double       norm = 1.0 / std::sqrt(1.0 + 2.0 * side * side);
  const auto         middleWeight = static_cast<float>(norm);
  const auto         sideWeight = static_cast<float>(side * norm);
  const std::size_t  results = length - 2;
  std::vector<float> out(outer * results * inner);
  for (std::size_t o = 0; o < outer; ++o)
  {
    const float * const from = &in[o * length * inner];
    float * const       to = &out[o * results * inner];
    for (std::size_t i = 0; i < results * inner; ++i)
    {
      to[i] = middleWeight * from[i + inner] + sideWeight * (from[i] + from[i + 2 * inner]);
    }
  }
  return out;
}
} // namespace

CorrelatedNoise::CorrelatedNoise(std::uint64_t                 seed,
                                 const RegionType &            grid,
                                 double                        standardDeviation,
                                 const std::array<double, 3> & correlation)
  : m_Seed(seed)
  , m_Grid(grid)
  , m_StandardDeviation(standardDeviation)
  , m_Side{ { SideWeight(correlation[0]), SideWeight(correlation[1]), SideWeight(correlation[2]) } }
{}

void
CorrelatedNoise::AddTo(std::vector<float> & values, const RegionType & region) const
{
  if (m_StandardDeviation <= 0.0)
  {
    return;
  }
  const auto                   start = region.GetIndex() - m_Grid.GetIndex();
  const auto                   grid = m_Grid.GetSize();
  const auto                   size = region.GetSize();
  std::vector<float>           white((size[0] + 2) * (size[1] + 2) * (size[2] + 2));
  std::vector<float>::iterator next = white.begin();
  for (std::uint64_t z = start[2]; z < start[2] + size[2] + 2; ++z)
  {
    for (std::uint64_t y = start[1]; y < start[1] + size[1] + 2; ++y)
    {
      const std::uint64_t line = (z * (grid[1] + 2) + y) * (grid[0] + 2);
      for (std::uint64_t x = start[0]; x < start[0] + size[0] + 2; ++x)
      {
        *next++ = static_cast<float>(NormalNoise(m_Seed, line + x));
      }
    }
  }
  white = FilterAxis(white, 1, size[2] + 2, (size[0] + 2) * (size[1] + 2), m_Side[2]);
  white = FilterAxis(white, size[2], size[1] + 2, size[0] + 2, m_Side[1]);
  white = FilterAxis(white, size[2] * size[1], size[0] + 2, 1, m_Side[0]);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] += static_cast<float>(m_StandardDeviation) * white[i];
  }
}
} // namespace shapeton
