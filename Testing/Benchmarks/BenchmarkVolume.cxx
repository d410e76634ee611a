#include "BenchmarkVolume.h"
#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

std::vector<float>
MakeBenchmarkVolume(const std::array<std::size_t, 3> & size)
{
  struct Ball
  {
    float x, y, z, radius, value; // relative to the sides of the volume; radius relative to the first side
  };
  const std::array<Ball, 3> balls = {
    { { 0.31F, 0.35F, 0.39F, 0.16F, 120 }, { 0.66F, 0.59F, 0.55F, 0.21F, 200 }, { 0.23F, 0.74F, 0.70F, 0.10F, 250 } }
  };
  std::vector<float> volume(size[0] * size[1] * size[2]);
  shapeton::ParallelFor(size[2], [&](std::size_t z) {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x)
      {
        const std::size_t i = (z * size[1] + y) * size[0] + x;
        auto              hash = static_cast<std::uint32_t>(i) * 2654435761U;
        hash = (hash ^ hash >> 15) * 0x7feb352dU;
        float value = 20.0F + 10.0F * std::sin(0.05F * x) * std::cos(0.04F * y + 0.03F * z);
        for (const Ball & ball : balls)
        {
          const float distance =
            std::hypot(x - ball.x * size[0], y - ball.y * size[1], z - ball.z * size[2]) - ball.radius * size[0];
          const float share = std::clamp(0.5F - distance / 2.0F, 0.0F, 1.0F);
          value = value * (1.0F - share) + ball.value * share;
        }
        volume[i] = value + (hash >> 8) * (12.0F / 16777216.0F) - 6.0F;
      }
    }
  });
  return volume;
}
