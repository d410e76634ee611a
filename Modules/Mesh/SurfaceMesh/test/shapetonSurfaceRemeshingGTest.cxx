#include "shapetonSurfaceRemeshing.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonTestSurfaces.h"
#include "shapetonExceptions.h"

#include "gtest/gtest.h"

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
Remeshed(const shapeton::SurfaceMesh & mesh, double length)
{
  shapeton::SurfaceRemeshingSettings options;
  options.edgeLength = length;
  return shapeton::RemeshSurface(mesh, options);
}

TEST(SurfaceRemeshing, StretchedTrianglesBecomeEquilateral)
{
  const shapeton::SurfaceMesh    torus = Roughened(Torus(200, 12, 20, 8), 0.02, 1); // sides of 0.6 mm and 4 mm
  const shapeton::SurfaceMesh    remeshed = Remeshed(torus, 1.5);
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(remeshed);
  EXPECT_TRUE(quality.isClosed);
  EXPECT_TRUE(quality.isOriented);
  EXPECT_EQ(quality.genus, 1);
  EXPECT_GE(quality.smallestAngle.percentile1, 30.0);
  EXPECT_NEAR(quality.edgeLength.median, 1.5, 0.15);
  EXPECT_LE(quality.edgeLength.maximum, 1.6 * 1.5);
  EXPECT_NEAR(*quality.volume, shapeton::EnclosedVolume(torus.V, torus.F), 0.02 * *quality.volume);
}

TEST(SurfaceRemeshing, VerticesLieOnTheGivenSurface)
{
  const shapeton::SurfaceMesh    sphere = Icosphere(3, 10.0);
  const shapeton::SurfaceMesh    remeshed = Remeshed(sphere, 0.8);
  const shapeton::SurfaceLocator locator(sphere.V, sphere.F);
  for (int v = 0; v < remeshed.NumberOfVertices(); ++v)
  {
    EXPECT_LE(locator.FindClosest(remeshed.V.row(v).transpose()).distance, 1e-9);
  }
}

TEST(SurfaceRemeshing, BoundaryLoopsStay)
{
  const shapeton::SurfaceMesh cylinder = Cylinder(60, 10, 10.0, 30.0);
  for (const double length : { 0.7, 1.5, 4.0 })
  {
    const shapeton::SurfaceMesh    remeshed = Remeshed(cylinder, length);
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(remeshed);
    EXPECT_TRUE(quality.isManifold);
    EXPECT_EQ(quality.genus, 0);
    ASSERT_EQ(quality.boundaryLoopLengths.size(), 2u);
    EXPECT_NEAR(quality.boundaryLoopLengths[0], 2.0 * Pi * 10.0, 0.5);
    EXPECT_NEAR(quality.boundaryLoopLengths[1], 2.0 * Pi * 10.0, 0.5);
    EXPECT_NEAR(quality.highestCorner[2] - quality.lowestCorner[2], 30.0, 1e-9);
  }
}

TEST(SurfaceRemeshing, AFlatSquareKeepsItsCornersAndArea)
{
  const shapeton::SurfaceMesh remeshed = Remeshed(Square(3, 10.0), 1.0);
  EXPECT_NEAR(shapeton::SurfaceArea(remeshed.V, remeshed.F), 100.0, 1e-9);
  EXPECT_LE(remeshed.V.col(2).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GE(shapeton::InspectSurface(remeshed).smallestAngle.percentile1, 25.0);
}

TEST(SurfaceRemeshing, KeepsTheTopologyOfRoughSurfaces)
{
  for (int seed = 1; seed <= 8; ++seed)
  {
    const shapeton::SurfaceMesh mesh =
      Roughened(Together({ Icosphere(2, 4), Torus(14, 9, 9, 3), Cylinder(9, 8, 3, 8) }), 0.4, seed);
    for (const double length : { 0.5, 1.5, 6.0 })
    {
      const shapeton::SurfaceQuality quality = shapeton::InspectSurface(Remeshed(mesh, length));
      EXPECT_TRUE(quality.isManifold);
      EXPECT_TRUE(quality.isOriented);
      EXPECT_EQ(quality.components.size(), 3u);
      EXPECT_EQ(quality.genus, 1);
      EXPECT_EQ(quality.boundaryLoopLengths.size(), 2u);
    }
  }
}

TEST(SurfaceRemeshing, EqualInputGivesEqualOutput)
{
  const shapeton::SurfaceMesh one = Remeshed(Torus(30, 20, 10, 4), 1.0);
  const shapeton::SurfaceMesh two = Remeshed(Torus(30, 20, 10, 4), 1.0);
  EXPECT_EQ(one.V, two.V);
  EXPECT_EQ(one.F, two.F);
}

TEST(SurfaceRemeshing, WrongInputIsRefused)
{
  EXPECT_THROW(Remeshed(Octahedron(), 0.0), shapeton::ParameterError);
  EXPECT_THROW(Remeshed(Octahedron(), -1.0), shapeton::ParameterError);
  EXPECT_THROW(Remeshed(Octahedron(), 1e-6), shapeton::InputError); // too many faces
  EXPECT_THROW(Remeshed(MoebiusStrip(9, 2), 1.0), shapeton::InputError);
}
} // namespace
