#include "shapetonFlatColonOverlay.h"

#include "shapetonFlatTestTubes.h"

#include <gtest/gtest.h>

namespace
{
const shapeton::FlatColonGrid &
Grid()
{
  static const shapeton::FlatColonGrid grid(flattubes::MakeCylinder({}));
  return grid;
}
} // namespace

TEST(FlatColonPlaces, DotsLieWhereTheyShould)
{
  const shapeton::RGBColor  red = shapeton::MakeColor(255, 0, 0);
  const auto                strip = shapeton::NewPicture(Grid().Columns(), Grid().Rows(), shapeton::MakeColor(0, 0, 0));
  const shapeton::FlatPixel pixel = Grid().PixelOfUv({ 40.0, 30.0 });
  shapeton::DrawFlatDot(strip, Grid(), { { 40.0, 30.0 }, red, 3.0 });
  EXPECT_EQ(strip->GetPixel({ { pixel.column, pixel.row } }), red);
  EXPECT_EQ(strip->GetPixel({ { pixel.column + 10, pixel.row } })[0], 0);
}

TEST(FlatColonPlaces, CurvesInSpaceBecomePlaces)
{
  const double                       radius = Grid().Circumference() / (2.0 * flattubes::pi);
  const std::vector<Eigen::Vector3d> points{ flattubes::OnCylinder(radius, 20.0, -1.0),
                                             flattubes::OnCylinder(radius, 100.0, -1.0),
                                             flattubes::OnCylinder(500.0, 100.0, -1.0) };
  const auto                         places = shapeton::PlacesOfCurve(Grid(), points, 1.0, 15.0);
  ASSERT_GE(places.size(), 80u);
  EXPECT_NEAR(places.front().x(), 20.0, 0.1);
  EXPECT_NEAR(places.front().y(), radius, 0.2);
  EXPECT_NEAR(places[79].x(), 99.0, 1.1);
  EXPECT_FALSE(places.back().allFinite()); // far from the surface
}
