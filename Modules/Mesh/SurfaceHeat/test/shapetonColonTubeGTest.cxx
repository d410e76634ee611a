#include "shapetonColonTube.h"
#include "shapetonSurfaceConnectivity.h"

#include <gtest/gtest.h>

namespace
{
using namespace shapeton;

TEST(ColonTube, IsATubeWithTheHandlesAskedFor)
{
  const testsurfaces::ColonTube tube = testsurfaces::MakeColonTube({ 12000, 10 });
  const SurfaceConnectivity     connectivity(tube.mesh);
  ASSERT_EQ(connectivity.Components().size(), 1u);
  EXPECT_TRUE(connectivity.IsManifold());
  EXPECT_TRUE(connectivity.IsOriented());
  EXPECT_EQ(connectivity.BoundaryLoops().size(), 2u);
  EXPECT_EQ(connectivity.Components()[0].genus.value(), 10);
  EXPECT_EQ(tube.handles.size(), 10u);
  EXPECT_NEAR(connectivity.NumberOfFaces(), 12000, 600);
}

TEST(ColonTube, HasANarrowestRadiusAndASeed)
{
  testsurfaces::ColonTubeOptions options;
  options.faces = 4000;
  const testsurfaces::ColonTube first = testsurfaces::MakeColonTube(options);
  EXPECT_GT(first.narrowestRadius, 8.0);
  EXPECT_LT(first.narrowestRadius, options.radius);
  EXPECT_EQ(testsurfaces::MakeColonTube(options).mesh.V, first.mesh.V);
  options.seed = 2;
  EXPECT_NE(testsurfaces::MakeColonTube(options).mesh.V, first.mesh.V);
}

TEST(ColonTube, RefusesHandlesThatDoNotFit)
{
  EXPECT_THROW(testsurfaces::MakeColonTube({ 1000, 100 }), std::runtime_error);
}
} // namespace
