#include "shapetonFlatColonStrip.h"

#include "shapetonFlatTestColon.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonExceptions.h"
#include "shapetonTestThreads.h"

namespace
{
using namespace flattubes;
using shapeton::At;
using shapeton::FlatColonGrid;

int
Brightness(const shapeton::RGBColor & color)
{
  return color[0] + color[1] + color[2];
}

/** A ring fold at u = 75 mm. */
double
RingFold(double u)
{
  return 19.0 - 5.0 * std::exp(-std::pow((u - 75.0) / 5.0, 2));
}

struct Painted
{
  explicit Painted(const shapeton::SurfaceMesh & mesh)
    : grid(mesh), axis(MakeFlatColonAxis(grid)), relief(PaintFlatRelief(grid, axis))
  {}
  FlatColonGrid              grid;
  shapeton::FlatColonAxis    axis;
  shapeton::Picture::Pointer relief;
};
} // namespace

TEST(FlatColonStrip, FoldsAreBrightAtTheLeftAndDarkAtTheRight)
{
  TubeForm form;
  form.around = 90;
  form.along = 150;
  const Painted straight(MakeFlatTube(form, [](double u, double angle) { return OnCylinder(RingFold(u), u, -angle); }));
  const Painted bent(MakeBentTube(form, 120.0, [](double u, double) { return RingFold(u); }));
  for (const Painted * painted : { &straight, &bent })
  {
    for (int row = 0; row < painted->grid.Rows(); row += 7)
    {
      const int level = Brightness(At(painted->relief, 40, row));
      EXPECT_GT(Brightness(At(painted->relief, 71, row)), level + 10) << row;
      EXPECT_LT(Brightness(At(painted->relief, 80, row)), level - 50) << row;
    }
  }
}

TEST(FlatColonStrip, ALevelTubeIsEvenWhateverItsBends)
{
  TubeForm      form;
  const Painted straight(MakeCylinder(form));
  EXPECT_LE(shapeton::GreatestDifference(straight.relief, PaintFlatRelief(straight.grid, straight.axis)), 0);
  const auto    colorOf = [](const Painted & painted, int column, int row) { return At(painted.relief, column, row); };
  const Painted bent(MakeBentTube(form, 120.0, [](double, double) { return 19.0; }));
  const int     expected = Brightness(colorOf(straight, 75, 60));
  for (int row = 0; row < 120; row += 5)
  {
    for (int column = 20; column < 130; column += 5)
    {
      ASSERT_NEAR(Brightness(colorOf(straight, column, row)), expected, 6);
      ASSERT_NEAR(Brightness(colorOf(bent, column, row)), expected, 60) << column << " " << row;
    }
  }
}

TEST(FlatColonStrip, CurvatureColorsAreThoseOfTheScale)
{
  const TubeForm                form;
  const FlatColonGrid           grid(MakeCylinder(form));
  const shapeton::FlatColonAxis axis = MakeFlatColonAxis(grid);
  const shapeton::ColorScale    scale = shapeton::CurvatureScale(0.05);
  const auto                    strip = PaintFlatCurvature(grid, axis, scale, 0.0);
  const shapeton::RGBColor      expected = scale.ColorOf(-pi / form.circumference);
  for (int column = 5; column < 145; column += 10)
  {
    for (unsigned int channel = 0; channel < 3; ++channel)
    {
      EXPECT_NEAR(At(strip, column, 33)[channel], expected[channel], 1);
    }
  }
  EXPECT_GT(scale.ColorOf(0.05)[0], scale.ColorOf(0.05)[2] + 80) << "into the lumen: red";
  EXPECT_GT(scale.ColorOf(-0.05)[2], scale.ColorOf(-0.05)[0] + 80) << "outwards: blue";
  EXPECT_THROW(shapeton::CurvatureScale(0.0), shapeton::ParameterError);
  EXPECT_THROW(PaintFlatCurvature(grid, axis, scale, 1.5), shapeton::ParameterError);
}

TEST(FlatColonStrip, HolesAreGray)
{
  shapeton::SurfaceMesh mesh = MakeCylinder({});
  std::vector<int>      faces(static_cast<std::size_t>(mesh.F.rows() - 2000));
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    faces[i] = static_cast<int>(i);
  }
  const Painted painted(shapeton::FacesOfSurface(mesh, faces));
  EXPECT_EQ(At(painted.relief, 140, 50), shapeton::MakeColor(96, 96, 96));
  EXPECT_NE(At(painted.relief, 40, 50), shapeton::MakeColor(96, 96, 96));
}

TEST(FlatColonStrip, ThreadsDoNotMatter)
{
  const shapeton::SurfaceMesh mesh = flatcolon::Wall();
  basetest::ExpectSameWithAnyThreads(
    [&] {
      const Painted painted(mesh);
      return basetest::BytesOf(painted.relief) + basetest::BytesOf(PaintFlatCurvature(painted.grid, painted.axis));
    },
    { 3 });
}

TEST(FlatColonStrip, ReducingTakesTheMeanLight)
{
  const auto strip = shapeton::NewPicture(7, 4, shapeton::MakeColor(0, 0, 0));
  for (int y = 0; y < 4; ++y)
  {
    for (int x = y % 2; x < 7; x += 2)
    {
      strip->SetPixel({ { x, y } }, shapeton::MakeColor(255, 255, 255));
    }
  }
  const auto reduced = shapeton::ReduceStrip(strip, 2, 4, 2);
  EXPECT_EQ(At(reduced, 0, 0), shapeton::MakeColor(188, 188, 188)) << "half of the light in sRGB";
  EXPECT_EQ(At(reduced, 3, 1), shapeton::MakeColor(188, 188, 188)) << "the last column has one half only";
  EXPECT_EQ(shapeton::GreatestDifference(shapeton::ReduceStrip(strip, 1, 7, 4), strip), 0);
  EXPECT_THROW(shapeton::ReduceStrip(strip, 2, 5, 2), std::invalid_argument);
  EXPECT_THROW(shapeton::ReduceStrip(strip, 0, 5, 2), std::invalid_argument);
}
