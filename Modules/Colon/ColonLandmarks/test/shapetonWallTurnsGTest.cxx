#include "shapetonWallTurns.h"

#include "shapetonFlatTestTubes.h"

#include <gtest/gtest.h>

#include <vector>

using shapeton::FlatColonGrid;
using shapeton::WallTurns;

namespace
{
constexpr double bendRadius = 40.0; // mm
constexpr double tubeRadius = 20.0;
constexpr int    rows = 17;
constexpr int    columnsPerRow = 3;

/** Angle around a torus for an angle of the conformal map; both are 0 at the outer side. */
double
AngleOnTorus(double onMap)
{
  const double half = std::remainder(0.5 * onMap, flattubes::pi); // of the tangent
  const double stretch = std::sqrt((bendRadius + tubeRadius) / (bendRadius - tubeRadius));
  return 2.0 * (std::atan(stretch * std::tan(half)) + 0.5 * onMap - half);
}

/** A quarter of a torus with its conformal map, which narrows the inner side. */
FlatColonGrid
BentTube()
{
  const double              height = std::sqrt(bendRadius * bendRadius - tubeRadius * tubeRadius);
  const flattubes::TubeForm form{ 120, 60, 2.0 * flattubes::pi * tubeRadius, 0.5 * flattubes::pi * height };
  return FlatColonGrid(flattubes::MakeFlatTube(form, [height](double u, double onMap) {
    const double angle = AngleOnTorus(onMap);
    const double reach = bendRadius + tubeRadius * std::cos(angle);
    return Eigen::Vector3d(reach * std::cos(u / height), reach * std::sin(u / height), tubeRadius * std::sin(angle));
  }));
}
} // namespace

/** The wall length around a torus is the tube radius times the angle. */
TEST(WallTurns, OfATorusAreItsAngles)
{
  const FlatColonGrid grid = BentTube();
  const WallTurns     turns(grid, rows, columnsPerRow);
  double              greatest = 0.0;
  for (double onMap = -1.0; onMap < 2.0; onMap += 0.013)
  {
    // The row direction of the grid is +v or -v.
    const double alongV = grid.IsMirrored() ? onMap : -onMap;
    const double expected = AngleOnTorus(2.0 * flattubes::pi * alongV) / (2.0 * flattubes::pi);
    const double found = turns.FromMap(rows / 2, onMap) * (grid.IsMirrored() ? 1.0 : -1.0);
    EXPECT_NEAR(expected, found, 0.003) << onMap;
    EXPECT_NEAR(onMap, turns.ToMap(rows / 2, turns.FromMap(rows / 2, onMap)), 1e-12);
    greatest = std::max(greatest, std::abs(expected - alongV));
  }
  EXPECT_GT(greatest, 0.05); // error of the map itself
}

TEST(WallTurns, OfTheMapAreItsOwn)
{
  const FlatColonGrid grid = BentTube();
  const WallTurns     turns = WallTurns::OfMap(grid, rows);
  for (double onMap = -1.0; onMap < 2.0; onMap += 0.013)
  {
    EXPECT_NEAR(onMap, turns.FromMap(3, onMap), 1e-12);
    EXPECT_NEAR(onMap, turns.ToMap(3, onMap), 1e-12);
  }
}

TEST(WallTurns, PixelsCoverEachCellOnce)
{
  const FlatColonGrid grid = BentTube();
  for (const WallTurns & turns : { WallTurns(grid, rows, columnsPerRow), WallTurns::OfMap(grid, rows) })
  {
    for (const int cells : { 7, 72, 500 })
    {
      std::vector<double> covered(cells, 0.0);
      for (int pixel = 0; pixel < grid.Rows(); ++pixel)
      {
        turns.ForCellsOfPixel(5, pixel, cells, [&](int cell, double share) {
          ASSERT_GE(cell, 0);
          ASSERT_LT(cell, cells);
          EXPECT_GE(share, 0.0);
          covered[cell] += share;
        });
      }
      for (const double share : covered)
      {
        EXPECT_NEAR(1.0, share, 1e-9);
      }
    }
  }
}
