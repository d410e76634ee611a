#include "shapetonLevelSurface.h"
#include "shapetonPi.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceQuality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace shapeton;

namespace
{
constexpr std::array<int, 3> size{ { 40, 30, 30 } };

/** Values whose zero level set is two spheres: radius 9 around (14, 15, 15) and radius 4 around (31, 15, 15). */
std::vector<float>
TwoBalls()
{
  std::vector<float> values;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        const double large = 9.013 - std::hypot(x - 14.0, y - 15.0, z - 15.0);
        const double small = 4.013 - std::hypot(x - 31.0, y - 15.0, z - 15.0);
        values.push_back(static_cast<float>(std::max(large, small)));
      }
    }
  }
  return values;
}
} // namespace

TEST(LevelSurface, IsClosedAndEnclosesTheBalls)
{
  std::vector<float>        values = TwoBalls();
  const std::vector<float>  before = values;
  const SurfaceMesh         mesh = LevelSurface(values, size, 0.0);
  const SurfaceConnectivity connectivity(mesh);
  EXPECT_EQ(values, before);
  EXPECT_TRUE(connectivity.IsClosed());
  EXPECT_TRUE(connectivity.IsOriented());
  EXPECT_EQ(connectivity.Components().size(), 2U);
  const double balls = 4.0 / 3.0 * shapeton::Pi * (std::pow(9.013, 3) + std::pow(4.013, 3));
  EXPECT_NEAR(std::abs(EnclosedVolume(mesh.V, mesh.F)), balls, 0.01 * balls);
}

TEST(LevelSurface, StartsWhereItIsTold)
{
  std::vector<float> values = TwoBalls();
  const SurfaceMesh  mesh = LevelSurface(values, size, 0.0);
  const SurfaceMesh  moved = LevelSurface(values, size, 0.0, -1.0);
  EXPECT_LT(((mesh.V - moved.V).array() - 1.0).abs().maxCoeff(), 1e-5); // VTK points have single precision
  EXPECT_EQ(mesh.F, moved.F);
}

TEST(LevelSurface, OuterShellIsTheLargestAndLooksOutwards)
{
  std::vector<float> values = TwoBalls();
  for (const bool turned : { false, true })
  {
    SurfaceMesh mesh = LevelSurface(values, size, 0.0);
    if (turned)
    {
      mesh.F.col(1).swap(mesh.F.col(2));
    }
    const SurfaceMesh shell = OuterShell(mesh);
    const double      ball = 4.0 / 3.0 * shapeton::Pi * std::pow(9.013, 3);
    EXPECT_NEAR(EnclosedVolume(shell.V, shell.F), ball, 0.01 * ball);
  }
}

TEST(LevelSurface, RefusesAnotherNumberOfValues)
{
  std::vector<float> values(5);
  EXPECT_THROW(LevelSurface(values, size, 0.0), std::invalid_argument);
}
