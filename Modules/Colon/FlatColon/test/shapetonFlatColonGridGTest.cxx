#include "shapetonFlatColonLocator.h"

#include "shapetonFlatTestTubes.h"
#include "shapetonTestErrors.h"
#include "shapetonTestSurfaces.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

namespace
{
using namespace flattubes;
using shapeton::FlatColonGrid;
using shapeton::FlatSample;

/** Point of a pixel on the cylinder mesh, on the chord between two vertices. */
Eigen::Vector3d
PointOnPolygon(const TubeForm & form, double u, double v)
{
  const double radius = form.circumference / (2.0 * pi);
  const double place = v / form.circumference * form.around;
  const double i = std::floor(place);
  const auto   corner = [&](double k) { return OnCylinder(radius, u, -2.0 * pi * k / form.around); };
  return corner(i) + (place - i) * (corner(i + 1.0) - corner(i));
}

double
Jitter(int i)
{
  const double x = 1e4 * std::sin(12.9898 * i + 0.7);
  return x - std::floor(x) - 0.5;
}

/** Moves vertices on the map; duplicates along the cut are moved together. */
shapeton::SurfaceMesh
MakeIrregularCylinder(const TubeForm & form, double amount)
{
  shapeton::SurfaceMesh mesh = MakeCylinder(form);
  auto &                uv = mesh.pointArrays[0].values;
  for (Eigen::Index vertex = 0; vertex < uv.rows(); ++vertex)
  {
    const int    source = static_cast<int>(mesh.pointArrays[1].values(vertex, 0));
    const bool   isEnd = uv(vertex, 0) == 0.0 || uv(vertex, 0) == form.length;
    const double cell = form.circumference / form.around;
    uv(vertex, 0) += isEnd ? 0.0 : amount * cell * Jitter(2 * source);
    uv(vertex, 1) += amount * cell * Jitter(2 * source + 1);
  }
  return mesh;
}

std::vector<int>
FacesOf(const FlatColonGrid & grid)
{
  std::vector<int> faces;
  ForPixels(grid, [&](int column, int row) { faces.push_back(grid.FaceOfPixel(column, row)); });
  return faces;
}
} // namespace

TEST(FlatColonGrid, CylinderClosedForms)
{
  const TubeForm      form;
  const FlatColonGrid grid(MakeCylinder(form));
  ASSERT_EQ(grid.Rows(), 120);
  ASSERT_EQ(grid.Columns(), 150);
  EXPECT_EQ(grid.UncoveredPixels(), 0);
  EXPECT_FALSE(grid.IsMirrored());
  const double radius = form.circumference / (2.0 * pi);
  const double scale = std::sqrt(2.0 * radius * std::sin(pi / form.around) * form.around / form.circumference);
  ForPixels(grid, [&](int column, int row) {
    const Eigen::Vector2d uv = grid.UvOfPixel(column, row);
    ASSERT_DOUBLE_EQ(uv.x(), column + 0.5);
    ASSERT_DOUBLE_EQ(uv.y(), row + 0.5);
    const FlatSample      sample = grid.SampleOfPixel(column, row);
    const Eigen::Vector3d expected = PointOnPolygon(form, uv.x(), uv.y());
    ASSERT_LT((sample.point - expected).norm(), 1e-11);
    ASSERT_NEAR(sample.scale, scale, 1e-12);
    ASSERT_NEAR(sample.arcLength, 10.0 + uv.x(), 1e-10);
    ASSERT_FALSE(sample.isBridged);
    if (column > 2 && column < 147) // at the ends, half of the neighborhood is missing
    {
      const Eigen::Vector3d inward = -Eigen::Vector3d(expected.x(), expected.y(), 0.0).normalized();
      ASSERT_LT((sample.inwardNormal - inward).norm(), 1e-11);
      ASSERT_NEAR(sample.curvature, -0.5 / radius, 1e-12);
    }
  });
}

TEST(FlatColonGrid, CurvatureOfARingFold)
{
  const TubeForm form{ 120, 300 };
  const double   radius = form.circumference / (2.0 * pi);
  const auto     mesh = MakeFlatTube(
    form, [=](double u, double angle) { return OnCylinder(radius - 2.0 * std::cos(2.0 * pi * u / 30.0), u, angle); });
  const FlatColonGrid grid(mesh);
  const double        bend = 2.0 * std::pow(2.0 * pi / 30.0, 2);
  const double        crest = grid.SampleOfPixel(59, 20).curvature; // u = 59.5: half a pixel from the crest
  const double        trough = grid.SampleOfPixel(74, 20).curvature;
  EXPECT_NEAR(crest, 0.5 * (bend - 1.0 / (radius - 2.0)), 0.04 * crest);
  EXPECT_NEAR(trough, 0.5 * (-bend - 1.0 / (radius + 2.0)), -0.04 * trough);
}

TEST(FlatColonGrid, AveragedCurvatureKeepsItsMean)
{
  const TubeForm                 form{ 60 };
  const auto                     mesh = MakeFlatTube(form, [](double u, double angle) {
    return OnCylinder(19.0 - std::cos(2.0 * pi * u / 6.0) * std::cos(3.0 * angle), u, angle);
  });
  shapeton::FlatColonGridOptions options;
  const FlatColonGrid            sharp(mesh, options);
  options.curvatureLength = 3.0;
  const FlatColonGrid soft(mesh, options);
  double              sums[2] = { 0.0, 0.0 };
  double              squares[2] = { 0.0, 0.0 };
  for (int row = 0; row < sharp.Rows(); ++row)
  {
    for (int column = 30; column < 120; ++column)
    {
      const double values[2] = { sharp.SampleOfPixel(column, row).curvature,
                                 soft.SampleOfPixel(column, row).curvature };
      for (int k = 0; k < 2; ++k)
      {
        sums[k] += values[k];
        squares[k] += values[k] * values[k];
      }
    }
  }
  EXPECT_NEAR(sums[1], sums[0], 0.1 * std::abs(sums[0]));
  EXPECT_LT(squares[1], 0.5 * squares[0]);
}

TEST(FlatColonGrid, AveragedNormalsForgetSmallWaves)
{
  const TubeForm form{ 60, 150 };
  const auto     mesh = MakeFlatTube(
    form, [](double u, double angle) { return OnCylinder(19.0 - 0.2 * std::cos(2.0 * pi * u / 5.0), u, angle); });
  double steepest[2] = { 0.0, 0.0 };
  for (const int k : { 0, 1 })
  {
    shapeton::FlatColonGridOptions options;
    options.normalLength = 2.0 * k;
    const FlatColonGrid grid(mesh, options);
    for (int column = 20; column < 130; ++column)
    {
      const Eigen::Vector3d normal = grid.SampleOfPixel(column, 33).inwardNormal;
      ASSERT_NEAR(normal.norm(), 1.0, 1e-12);
      steepest[k] = std::max(steepest[k], std::abs(normal.z()));
    }
  }
  EXPECT_GT(steepest[0], 0.14);
  EXPECT_LT(steepest[1], 0.5 * steepest[0]);
}

TEST(FlatColonGrid, SeenFromInsideWhateverTheOrientation)
{
  TubeForm            form;
  const FlatColonGrid plain(MakeCylinder(form));
  for (const bool isInsideOut : { false, true })
  {
    for (const bool isMirrored : { false, true })
    {
      form.isInsideOut = isInsideOut;
      form.isMirrored = isMirrored;
      const FlatColonGrid grid(MakeCylinder(form));
      EXPECT_EQ(grid.IsMirrored(), isMirrored);
      for (int i = 0; i < 2000; ++i)
      {
        const int        column = (37 * i) % 150, row = (53 * i) % 120;
        const FlatSample expected = plain.SampleOfPixel(column, row);
        const FlatSample sample = grid.SampleOfPixel(column, row);
        ASSERT_LT((sample.point - expected.point).norm(), 1e-10);
        ASSERT_LT((sample.inwardNormal - expected.inwardNormal).norm(), 1e-10);
        ASSERT_NEAR(sample.curvature, expected.curvature, 1e-12);
        ASSERT_EQ(grid.PixelOfUv(grid.UvOfPixel(column, row)).row, row);
      }
    }
  }
}

TEST(FlatColonGrid, TheWayAroundIsPeriodicAcrossACrookedCut)
{
  TubeForm form;
  form.cutSway = 1.7;
  shapeton::FlatColonGridOptions options;
  options.pixelSize = 0.37;
  const FlatColonGrid grid(MakeCylinder(form), options);
  EXPECT_EQ(grid.UncoveredPixels(), 0);
  EXPECT_DOUBLE_EQ(grid.PixelSize() * grid.Rows(), form.circumference);
  EXPECT_NEAR(grid.PixelSize(), 0.37, 0.37 / grid.Rows());
  for (int column = 0; column < grid.Columns(); ++column)
  {
    for (const int row : { -3, -1, 0, 1, grid.Rows() - 1 })
    {
      const Eigen::Vector3d point = grid.PointOfPixel(column, row);
      ASSERT_EQ(point, grid.PointOfPixel(column, row + grid.Rows()));
      const double step = (grid.PointOfPixel(column, row + 1) - point).norm();
      ASSERT_NEAR(step, grid.PixelSize(), 0.05 * grid.PixelSize()) << "a jump at the cut";
    }
  }
}

TEST(FlatColonGrid, EveryPixelHasTheFaceThatItsMiddleLiesIn)
{
  const TubeForm              form{ 14, 18, 56.0, 72.0, 0.6 };
  const shapeton::SurfaceMesh mesh = MakeIrregularCylinder(form, 0.5);
  const FlatColonGrid         grid(mesh);
  const auto &                uv = mesh.pointArrays[0].values;
  ASSERT_EQ(grid.UncoveredPixels(), 0);
  ForPixels(grid, [&](int column, int row) {
    const int face = grid.FaceOfPixel(column, row);
    int       holders = 0;
    for (int other = 0; other < mesh.F.rows(); ++other)
    {
      for (const double turn : { -1.0, 0.0, 1.0 })
      {
        const Eigen::Vector2d p(column + 0.5, row + 0.5 + turn * form.circumference);
        double                least = 1.0;
        for (int k = 0; k < 3; ++k)
        {
          const Eigen::Vector2d a = uv.row(mesh.F(other, k)), b = uv.row(mesh.F(other, (k + 1) % 3));
          least = std::min(least, (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x());
        }
        holders += least > 1e-3;
        ASSERT_TRUE(least <= 1e-3 || other == face) << column << " " << row;
      }
    }
    ASSERT_LE(holders, 1);
  });
}

TEST(FlatColonGrid, PixelsOnSharedEdgesBelongToOneFace)
{
  TubeForm            form{ 60, 75, 60.0, 75.0 }; // cells of one pixel: pixel centers are on diagonals
  const FlatColonGrid grid(MakeCylinder(form));
  EXPECT_EQ(grid.UncoveredPixels(), 0);
  ForPixels(grid, [&](int column, int row) {
    const int first = 2 * (column * form.around + row);
    ASSERT_EQ(grid.FaceOfPixel(column, row) - first, grid.FaceOfPixel(0, 0));
  });
  form.around = 30; // cells of two pixels, shifted by half a pixel: pixel centers are on vertices
  shapeton::SurfaceMesh moved = MakeCylinder(form);
  moved.pointArrays[0].values.col(1).array() += 0.5;
  EXPECT_EQ(FlatColonGrid(moved).UncoveredPixels(), 0);
}

TEST(FlatColonGrid, FromPixelsToSpaceAndBack)
{
  TubeForm form;
  form.cutSway = 1.3;
  const shapeton::SurfaceMesh mesh =
    MakeBentTube(form, 90.0, [](double u, double) { return 18.0 + std::sin(0.2 * u); });
  const FlatColonGrid              grid(mesh);
  const shapeton::FlatColonLocator locator(grid);
  for (int i = 0; i < 3000; ++i)
  {
    const int                 column = (37 * i) % grid.Columns(), row = (53 * i) % grid.Rows();
    const FlatSample          sample = grid.SampleOfPixel(column, row);
    const shapeton::FlatPlace place = locator.Find(sample.point);
    ASSERT_LT(place.distance, 1e-9);
    ASSERT_EQ(place.pixel.column, column);
    ASSERT_EQ(place.pixel.row, row);
    ASSERT_LT((place.uv - grid.UvOfPixel(column, row)).norm(), 1e-8);
    const shapeton::FlatPlace inside = locator.Find(sample.point + 0.01 * sample.inwardNormal);
    ASSERT_NEAR(inside.distance, 0.01, 1e-3);
    ASSERT_LE(std::abs(inside.pixel.column - column), 1);
  }
}

TEST(FlatColonGrid, WhereTheMapIsFoldedTheSideNotTurnedOverWins)
{
  const TubeForm        form;
  shapeton::SurfaceMesh mesh = MakeCylinder(form);
  const int             vertex = 30 * (form.around + 1) + 20;
  const auto            home = mesh.pointArrays[0].values.row(vertex).eval();
  mesh.pointArrays[0].values(vertex, 0) += 4.0; // beyond the next vertices
  const FlatColonGrid grid(mesh);
  EXPECT_EQ(grid.UncoveredPixels(), 0);
  const auto & uv = mesh.pointArrays[0].values;
  for (const int face : FacesOf(grid))
  {
    const Eigen::Vector2d a = uv.row(mesh.F(face, 0)), b = uv.row(mesh.F(face, 1)), c = uv.row(mesh.F(face, 2));
    ASSERT_GT((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x(), 0.0);
  }
  EXPECT_NE(uv(vertex, 0), home(0));
}

TEST(FlatColonGrid, HolesStayHoles)
{
  const FlatColonGrid grid(testsurfaces::FacesWhere(MakeCylinder({}), [](int face) { return face / 2 != 1000; }));
  EXPECT_GT(grid.UncoveredPixels(), 3);
  EXPECT_LT(grid.UncoveredPixels(), 12);
  ForPixels(grid, [&](int column, int row) {
    const bool isHole = grid.FaceOfPixel(column, row) < 0;
    ASSERT_EQ(isHole, !grid.PointOfPixel(column, row).allFinite());
    ASSERT_EQ(isHole, grid.SampleOfPixel(column, row).face < 0);
  });
}

TEST(FlatColonGrid, BridgesAreTold)
{
  shapeton::SurfaceMesh mesh = MakeCylinder({});
  mesh.cellArrays[0].values.block(0, 0, 10 * 2 * 48, 1).setOnes(); // the first ten rings: 25 mm
  const FlatColonGrid grid(mesh);
  EXPECT_TRUE(grid.SampleOfPixel(24, 7).isBridged);
  EXPECT_FALSE(grid.SampleOfPixel(25, 7).isBridged);
}

TEST(FlatColonGrid, ThreadsDoNotMatter)
{
  TubeForm form;
  form.cutSway = 1.1;
  const shapeton::SurfaceMesh    mesh = MakeIrregularCylinder(form, 0.9);
  shapeton::FlatColonGridOptions options;
  options.pixelSize = 0.21;
  basetest::ExpectSameWithAnyThreads([&] { return FacesOf(FlatColonGrid(mesh, options)); }, { 3, 8 });
}

TEST(FlatColonGrid, RefusesWhatIsNoFlatTube)
{
  const shapeton::SurfaceMesh good = MakeCylinder({});
  const auto                  refuses = [](const shapeton::SurfaceMesh & mesh, const std::string & words) {
    const std::string message = basetest::ErrorOf([&] { const FlatColonGrid grid(mesh, {}, "flat.vtp"); });
    return message.rfind("flat.vtp", 0) == 0 && message.find(words) != std::string::npos;
  };
  for (const std::size_t array : { 0, 1 })
  {
    shapeton::SurfaceMesh bad = good;
    bad.pointArrays.erase(bad.pointArrays.begin() + static_cast<std::ptrdiff_t>(array));
    EXPECT_TRUE(refuses(bad, good.pointArrays[array].name));
    bad = good;
    bad.fieldArrays[array].values(0, 0) = 0.0;
    EXPECT_TRUE(refuses(bad, "not positive"));
  }
  shapeton::SurfaceMesh bad = good;
  bad.pointArrays[0].values(7, 0) = std::nan("");
  EXPECT_TRUE(refuses(bad, "not finite"));
  bad = good;
  bad.fieldArrays[1].values(0, 0) = 100.0;
  EXPECT_TRUE(refuses(bad, "u is out of the range"));
  bad.fieldArrays[1].values(0, 0) = 1000.0;
  EXPECT_TRUE(refuses(bad, "less than half"));
  bad = good;
  bad.pointArrays[0].values.col(1) *= 1000.0;
  EXPECT_TRUE(refuses(bad, "v is more than"));
}

TEST(FlatColonGrid, RefusesPixelsTooLargeOrTooSmall)
{
  const shapeton::SurfaceMesh mesh = MakeCylinder({});
  for (const double size : { 0.0, -1.0, 1e-3, 50.0, std::nan("") })
  {
    shapeton::FlatColonGridOptions options;
    options.pixelSize = size;
    EXPECT_THROW(FlatColonGrid(mesh, options), shapeton::ParameterError) << size;
  }
}
