#include "shapetonPolypCandidatePictures.h"

#include "shapetonPerspectiveRendering.h"
#include "shapetonPolypTubes.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
using namespace polyptubes;

/** A coarse tube along x, as produced by a flattening. */
shapeton::SurfaceMesh
FlatTube()
{
  constexpr int         around = 40, along = 24;
  const double          circumference = shapeton::TwoPi * radius;
  shapeton::SurfaceMesh flat;
  flat.V.resize((around + 1) * (along + 1), 3);
  flat.F.resize(2 * around * along, 3);
  shapeton::SurfaceArray uv{ "uv", Eigen::MatrixXd(flat.V.rows(), 2), false };
  shapeton::SurfaceArray source{ "sourcePointId", Eigen::MatrixXd(flat.V.rows(), 1), true };
  int                    face = 0;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i <= around; ++i)
    {
      const int    vertex = j * (around + 1) + i;
      const double angle = shapeton::TwoPi * (i % around) / around - shapeton::Pi; // the seam is above
      const double x = 48.0 * j / along - 24.0;
      const double off = std::hypot(x, radius * angle) / 6.0;
      const double r = radius - (off < 1.0 ? 7.0 * std::sqrt(1.0 - off * off) : 0.0);
      flat.V.row(vertex) << x, r * std::sin(angle), -r * std::cos(angle);
      uv.values.row(vertex) << x + 24.0, circumference * i / around;
      source.values(vertex, 0) = j * around + i % around;
      if (i < around && j < along)
      {
        flat.F.row(face++) << vertex, vertex + around + 1, vertex + around + 2;
        flat.F.row(face++) << vertex, vertex + around + 2, vertex + 1;
      }
    }
  }
  flat.pointArrays = { uv, source };
  flat.fieldArrays = { { "circumference", Eigen::MatrixXd::Constant(1, 1, circumference), false },
                       { "length", Eigen::MatrixXd::Constant(1, 1, 48.0), false } };
  return flat;
}

/** Fraction of pixels in a rectangle that are more blue than red. */
double
BlueShare(const shapeton::Picture * picture, int left, int top, int width, int height)
{
  int blue = 0;
  for (int y = top; y < top + height; ++y)
  {
    for (int x = left; x < left + width; ++x)
    {
      const shapeton::RGBColor & color = picture->GetPixel({ { x, y } });
      blue += color[2] > color[0] + 20 ? 1 : 0;
    }
  }
  return blue / static_cast<double>(width * height);
}
} // namespace

/** A straight colon with bodies, its centerline and its flat map. */
shapeton::PolypColon
StraightColon(const std::vector<Body> & bodies)
{
  shapeton::PolypColon colon;
  colon.wall = MakeWall(bodies);
  colon.flat = std::make_shared<shapeton::FlatColon>(FlatTube());
  colon.centerline.V.resize(49, 3);
  for (int i = 0; i < 49; ++i)
  {
    colon.centerline.V.row(i) << i - 24.0, 0.0, 0.0;
  }
  colon.centerline.curves.emplace_back(49);
  std::iota(colon.centerline.curves[0].begin(), colon.centerline.curves[0].end(), 0);
  colon.centerline.pointArrays = { { "arcLength", Eigen::VectorXd::LinSpaced(49, 0.0, 48.0), false } };
  return colon;
}

TEST(PolypCandidatePictures, HeadIsInTheMiddleOfBothViews)
{
  shapeton::PolypColon colon = StraightColon({ Ellipsoid(Base(0.0), 6.0, 7.0) });
  auto                 candidates = shapeton::FindPolypCandidates(colon.wall);
  ASSERT_EQ(candidates.size(), 1u);
  candidates.front().uv = { 24.0, shapeton::Pi * radius };
  const shapeton::PolypCandidatePictures pictures(colon, candidates);
  for (const auto & picture : { pictures.DrawCloseUp(candidates.front()), pictures.DrawFromWithin(candidates.front()) })
  {
    EXPECT_GT(BlueShare(picture, 190, 140, 20, 20), 0.95);
    EXPECT_LT(BlueShare(picture, 0, 0, 60, 280), 0.02);
    EXPECT_LT(BlueShare(picture, 340, 0, 60, 280), 0.02);
  }
  const auto flat = pictures.DrawFlatColon();
  EXPECT_GT(flat->GetLargestPossibleRegion().GetSize(0), 100u);
  EXPECT_EQ(pictures.DrawCrops(candidates.front()), nullptr); // no CT
  EXPECT_EQ(pictures.DrawCard(candidates.front())->GetLargestPossibleRegion().GetSize(0), 400u);
  colon.flat = nullptr;
  EXPECT_THROW(shapeton::PolypCandidatePictures(colon, candidates), shapeton::InputError);
}

/** A polyp next to a higher plate, which hides it from one half of the centerline. */
TEST(PolypCandidatePictures, WholeHeadIsInTheEndoluminalViewAlsoBehindAFold)
{
  const shapeton::PolypColon colon = StraightColon({ Plate(-7.0, 14.0), Ellipsoid(Base(2.0), 4.0, 4.0) });
  auto                       candidates = shapeton::FindPolypCandidates(colon.wall);
  ASSERT_FALSE(candidates.empty());
  const shapeton::PolypCandidatePictures pictures(colon, candidates);
  for (const shapeton::PolypCandidate & candidate : candidates)
  {
    const shapeton::PerspectiveCamera camera = pictures.EndoluminalCamera(candidate);
    for (const int vertex : candidate.vertices)
    {
      const Eigen::Vector2d pixel = shapeton::ProjectPoint(colon.wall.V.row(vertex).transpose(), camera);
      EXPECT_TRUE(pixel.x() > 0.0 && pixel.x() < 399.0 && pixel.y() > 0.0 && pixel.y() < 299.0);
    }
    EXPECT_GT(BlueShare(pictures.DrawFromWithin(candidate), 100, 75, 200, 150), 0.05);
  }
}

/** Tissue is dark gray in the colon window and light in the soft-tissue window; gas is black in both. */
TEST(PolypCandidatePictures, WholeHeadIsInAllCrops)
{
  const std::vector<Body> bodies{ Ball(Base(0.0) + 4.0 * Vector3d::UnitZ(), 5.0) };
  shapeton::PolypColon    colon = StraightColon(bodies);
  colon.ct = MakeImage<itk::Image<float, 3>>(
    0.8, [](double d) { return d > 0.0 ? -950.0 : 50.0; }, bodies);
  colon.original = MakeImage<itk::Image<float, 3>>(
    0.8, [](double d) { return d > 0.0 ? 240.0 : 50.0; }, bodies); // under fluid
  auto candidates = shapeton::FindPolypCandidates(colon.wall);
  ASSERT_EQ(candidates.size(), 1u);
  const auto crops = shapeton::PolypCandidatePictures(colon, candidates).DrawCrops(candidates.front());
  ASSERT_EQ(crops->GetLargestPossibleRegion().GetSize(), (itk::Size<2>{ { 4 * 258 - 6, 22 + 4 * 258 - 6 } }));
  const auto grayAt = [&](int column, int row, int x, int y) {
    return static_cast<int>(crops->GetPixel({ { column * 258 + x, 22 + row * 258 + y } })[0]);
  };
  constexpr double pixelsPerMm = 252.0 / 60.0;
  for (int column = 0; column < 4; ++column)
  {
    EXPECT_NEAR(grayAt(column, 0, 126, 126), 255 * 210 / 400, 8);   // CT, soft-tissue window
    EXPECT_NEAR(grayAt(column, 1, 126, 126), 255 * 1000 / 1500, 8); // CT, colon window
    EXPECT_NEAR(grayAt(column, 2, 126, 126), 255 * 210 / 400, 8);
    EXPECT_NEAR(grayAt(column, 3, 126, 126), 255 * 1000 / 1500, 8);
  }
  // 12 mm to the right or left of the center of the head in the axial crop is fluid, removed by cleansing.
  for (const int side : { -1, 1 })
  {
    const int x = 126 + static_cast<int>(side * 12.0 * pixelsPerMm);
    EXPECT_GT(grayAt(0, 0, x, 126), 240);
    EXPECT_LT(grayAt(0, 2, x, 126), 10);
  }
  // Where cleansing changed nothing, the crops are not repeated.
  colon.original = colon.ct;
  const auto unchanged = shapeton::PolypCandidatePictures(colon, candidates).DrawCrops(candidates.front());
  EXPECT_EQ(unchanged->GetLargestPossibleRegion().GetSize(1), 22u + 2 * 258 - 6);
}

TEST(PerspectiveRendering, PlacesAreThoseOfAPinhole)
{
  shapeton::PerspectiveCamera camera;
  camera.focus = { 0.0, 10.0, 0.0 };
  camera.fieldOfView = 90.0;
  camera.width = 401;
  camera.height = 301;
  const Eigen::Vector2d middle = shapeton::ProjectPoint({ 0.0, 10.0, 0.0 }, camera);
  EXPECT_NEAR(middle.x(), 200.0, 1e-9);
  EXPECT_NEAR(middle.y(), 150.0, 1e-9);
  // A point 45 degrees to the side is half a width off the middle, at any distance; z is up.
  const Eigen::Vector2d side = shapeton::ProjectPoint({ 30.0, 30.0, 0.0 }, camera);
  EXPECT_NEAR(std::abs(side.x() - 200.0), 200.5, 1e-9);
  EXPECT_LT(shapeton::ProjectPoint({ 0.0, 10.0, 2.0 }, camera).y(), 150.0);
  EXPECT_TRUE(std::isnan(shapeton::ProjectPoint({ 0.0, -1.0, 0.0 }, camera).x()));
  camera.up = Eigen::Vector3d::UnitY();
  EXPECT_THROW(shapeton::ProjectPoint({ 0.0, 10.0, 0.0 }, camera), std::invalid_argument);
}

// The near square hides the far one, regardless of their order.
TEST(PerspectiveRendering, NearHidesFar)
{
  shapeton::SurfaceMesh squares;
  squares.V.resize(8, 3);
  for (int k = 0; k < 8; ++k)
  {
    const double y = k < 4 ? 40.0 : 20.0;
    const double half = k < 4 ? 30.0 : 5.0;
    squares.V.row(k) << (k % 4 == 1 || k % 4 == 2 ? half : -half), y, (k % 4 >= 2 ? half : -half);
  }
  squares.F.resize(4, 3);
  squares.F << 4, 5, 6, 4, 6, 7, 0, 1, 2, 0, 2, 3;
  std::vector<shapeton::RGBColor> colors(8, shapeton::MakeColor(250, 20, 20));
  std::fill(colors.begin() + 4, colors.end(), shapeton::MakeColor(20, 20, 250));
  shapeton::PerspectiveCamera camera;
  camera.focus = { 0.0, 10.0, 0.0 };
  camera.width = 200;
  camera.height = 200;
  for (int turn = 0; turn < 2; ++turn)
  {
    const auto picture = shapeton::RenderPerspective(squares, colors, camera);
    // 5 / 20 of half the width of the picture.
    EXPECT_DOUBLE_EQ(BlueShare(picture, 77, 77, 46, 46), 1.0);
    EXPECT_DOUBLE_EQ(BlueShare(picture, 30, 77, 42, 46), 0.0);
    squares.F = squares.F.colwise().reverse().eval();
  }
}
