#include "shapetonConformalMapPicture.h"

#include "shapetonPictureTestUtilities.h"
#include "shapetonPlanarDomains.h"

#include <gtest/gtest.h>

namespace
{
using namespace shapeton;
using namespace testsurfaces;

/** An annulus with one slit, bent out of the plane. */
SurfaceMesh
Cone()
{
  const PolarGrid grid;
  SurfaceMesh     mesh = WithSlits(grid.Mesh(), { Arc(grid, 14, 5, 30) });
  mesh.V *= 50.0;
  mesh.V.col(2) = -0.6 * mesh.V.leftCols(2).rowwise().norm();
  return mesh;
}

TEST(ConformalMapPicture, ChecksAlternate)
{
  const PlanePattern pattern = Checkerboard(2.0);
  EXPECT_EQ(pattern(1.0, 1.0), pattern(3.0, 3.0));
  EXPECT_EQ(pattern(1.0, 1.0), pattern(-1.0, -1.0));
  EXPECT_NE(pattern(1.0, 1.0), pattern(3.0, 1.0));
  EXPECT_NE(pattern(1.0, 1.0), pattern(1.0, -1.0));
}

TEST(ConformalMapPicture, PolarChecksCloseAroundTheMiddle)
{
  const PlanePattern pattern = PolarCheckerboard(12);
  const double       step = Pi / 6;
  for (int i = 0; i < 12; ++i)
  {
    const auto at = [&](int k, double r) {
      return pattern(r * std::cos((k + 0.5) * step), r * std::sin((k + 0.5) * step));
    };
    EXPECT_NE(at(i, 1.2), at(i + 1, 1.2)) << i;
    EXPECT_NE(at(i, 1.2), at(i, 1.2 * std::exp(step))) << i; // square
  }
}

TEST(ConformalMapPicture, LevelSetsGoFromBlueToRed)
{
  const PlanePattern pattern = LevelSets(0.0, 1.0, 0.1);
  EXPECT_EQ(pattern(0.05, 7.0), HeatColor(0.05));
  EXPECT_EQ(pattern(0.95, 7.0), HeatColor(0.95));
  EXPECT_NE(pattern(0.2, 0.0), HeatColor(0.2)); // a line
}

TEST(ConformalMapPicture, PatternsThatAreNoneAreRefused)
{
  EXPECT_THROW(Checkerboard(0.0), std::invalid_argument);
  EXPECT_THROW(PolarCheckerboard(7), std::invalid_argument);
  EXPECT_THROW(LevelSets(1.0, 0.0, 0.1), std::invalid_argument);
}

TEST(ConformalMapPicture, ViewerFacesAnOpenSurface)
{
  PatientViewOptions view;
  SurfaceMesh        mesh = Square(2, 10.0); // faces +z, the patient's head
  LookAtSurface(mesh, view);
  EXPECT_NEAR(view.elevation, 90.0, 1e-9);
  mesh.V.col(2).swap(mesh.V.col(0)); // faces -x, the patient's right
  LookAtSurface(mesh, view);
  EXPECT_NEAR(view.elevation, 0.0, 1e-9);
  EXPECT_NEAR(view.azimuth, -90.0, 1e-9);
  PatientViewOptions front;
  LookAtSurface(Icosphere(1, 10.0), front);
  EXPECT_EQ(front.azimuth, 0.0);
  EXPECT_EQ(front.elevation, 0.0);
}

TEST(ConformalMapPicture, Baseline)
{
  ConformalMapPictureOptions options;
  options.width = 640;
  options.height = 320;
  options.checks = 24;
  ExpectBaseline(DrawConformalMap(MapConformally(Cone(), {}, "the cone"), options), "shapetonConformalMapPicture.png");
}
} // namespace
