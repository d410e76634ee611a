#include "shapetonFlatColonRows.h"

#include "shapetonFlatTestTubes.h"
#include "shapetonExceptions.h"

#include <gtest/gtest.h>

namespace
{
using namespace flattubes;
using shapeton::FlatColonGrid;
} // namespace

TEST(FlatColonRows, CoverTheColonOnce)
{
  const FlatColonGrid grid(MakeCylinder({}));
  for (const int greatest : { 1, 7, 40, 75, 149, 150, 4000 })
  {
    const auto rows = BreakIntoRows(grid, greatest);
    EXPECT_EQ(rows.size(), static_cast<std::size_t>((150 + greatest - 1) / greatest));
    int next = 0;
    for (const shapeton::FlatColonRow & row : rows)
    {
      EXPECT_EQ(row.firstColumn, next);
      EXPECT_GE(row.columns, 1);
      EXPECT_LE(row.columns, greatest);
      EXPECT_LE(std::abs(row.columns - rows.front().columns), 1) << "row lengths differ by at most one column";
      next += row.columns;
    }
    EXPECT_EQ(next, 150);
  }
  EXPECT_THROW(BreakIntoRows(grid, 0), shapeton::ParameterError);
}

TEST(FlatColonRows, LongBridgesAreCutShort)
{
  shapeton::SurfaceMesh mesh = MakeCylinder({});                     // 60 rings of 2.5 mm
  mesh.cellArrays[0].values.block(20 * 96, 0, 24 * 96, 1).setOnes(); // 50 to 110 mm
  const FlatColonGrid grid(mesh);
  for (const int greatest : { 50, 1000 })
  {
    std::vector<int> shown;
    for (const shapeton::FlatColonRow & row : BreakIntoRows(grid, greatest, 10))
    {
      EXPECT_LE(row.ShownColumns(), greatest);
      for (int place = 0; place < row.ShownColumns(); ++place)
      {
        shown.push_back(row.ColumnAt(place));
        EXPECT_TRUE(row.Shows(shown.back() + 0.5));
        EXPECT_DOUBLE_EQ(row.PlaceOf(shown.back() + 0.5), place + 0.5);
      }
    }
    ASSERT_EQ(shown.size(), 100U) << "shortened by 50 mm";
    EXPECT_EQ(shown[54], 54);
    EXPECT_EQ(shown[55], 105);
    EXPECT_EQ(shown.back(), 149);
  }
  const auto whole = BreakIntoRows(grid, 1000, 10);
  EXPECT_FALSE(whole[0].Shows(80.0));
  EXPECT_DOUBLE_EQ(whole[0].PlaceOf(80.0), 55.0);
  EXPECT_EQ(BreakIntoRows(grid, 1000, 60)[0].ShownColumns(), 150) << "not shortened";
  EXPECT_EQ(BreakIntoRows(grid, 1000)[0].ShownColumns(), 150);
  EXPECT_THROW(BreakIntoRows(grid, 1000, -1), shapeton::ParameterError);
}

TEST(FlatColonRows, ScaleIsThatOfTheSurfaceWithoutBridges)
{
  // A cone is conformal with u = log of the radius; the scale is radius / mean radius.
  const TubeForm form{ 100, 100, 100.0, 100.0 };
  const double   meanRadius = form.circumference / (2.0 * pi);
  const auto     radius = [=](double u) { return meanRadius * std::exp(0.004 * (u - 50.0)); };
  const double   slope = 0.004 * meanRadius; // sine of half the opening angle
  auto           mesh = MakeFlatTube(form, [=](double u, double angle) {
    return OnCylinder(radius(u), radius(u) / slope * std::sqrt(1.0 - slope * slope), angle);
  });
  mesh.cellArrays[0].values.block(0, 0, 2 * 100 * 10, 1).setOnes(); // u below 10 mm
  const auto rows = BreakIntoRows(FlatColonGrid(mesh), 50);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_NEAR(rows[0].scale, std::exp(0.004 * (30.0 - 50.0)), 3e-3);
  EXPECT_NEAR(rows[0].lowScale, std::exp(0.004 * (14.0 - 50.0)), 3e-3);
  EXPECT_NEAR(rows[1].scale, std::exp(0.004 * (75.0 - 50.0)), 3e-3);
  EXPECT_NEAR(rows[1].highScale, std::exp(0.004 * (95.0 - 50.0)), 3e-3);
}

TEST(FlatColonRows, TicksLieWhereTheDistanceIsRound)
{
  std::vector<double> distances;
  for (int column = 0; column < 60; ++column)
  {
    distances.push_back(17.0 + 0.5 * (column + 0.5)); // 17 mm at the left border
  }
  const auto ticks = shapeton::RulerTicks(distances, 10.0);
  ASSERT_EQ(ticks.size(), 3U);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_DOUBLE_EQ(ticks[i].distance, 20.0 + 10.0 * i);
    EXPECT_NEAR(ticks[i].column, (ticks[i].distance - 17.0) / 0.5, 1e-9);
  }
  EXPECT_TRUE(shapeton::RulerTicks({}, 10.0).empty());
  EXPECT_THROW(shapeton::RulerTicks(distances, 0.0), shapeton::ParameterError);
}

TEST(FlatColonRows, ADistanceThatStandsStillHasOneTick)
{
  const auto ticks = shapeton::RulerTicks({ 8.0, 10.0, 10.0, 10.0, 31.0 }, 10.0);
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_NEAR(ticks[0].column, 1.5, 1e-12);
  EXPECT_NEAR(ticks[1].column, 3.5 + 10.0 / 21.0, 1e-12);
  EXPECT_NEAR(ticks[2].column, 3.5 + 20.0 / 21.0, 1e-12);
}
