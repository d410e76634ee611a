#include "shapetonFlatColon.h"

#include "shapetonFlatTestTubes.h"
#include "shapetonTestErrors.h"

#include <gtest/gtest.h>

#include <future>

namespace
{
using flattubes::MakeCylinder;
using shapeton::CurvatureUnit;
using shapeton::FlatColon;
using shapeton::FlatColonGrid;
using shapeton::FlatColonGridOptions;

FlatColonGridOptions
PixelsOf(double size)
{
  FlatColonGridOptions options;
  options.pixelSize = size;
  return options;
}
} // namespace

TEST(FlatColon, MakesEachGridOnce)
{
  const FlatColon flat(MakeCylinder({}), PixelsOf(2.0));
  EXPECT_EQ(&flat.Grid(), &flat.Grid(PixelsOf(2.0)));
  EXPECT_EQ(&flat.Axis(), &flat.Axis(PixelsOf(2.0)));
  const FlatColonGrid & fine = flat.Grid(PixelsOf(0.5));
  EXPECT_NE(&fine, &flat.Grid());
  EXPECT_EQ(&fine, &flat.Grid(PixelsOf(0.5)));
  EXPECT_EQ(fine.Rows(), 4 * flat.Grid().Rows());
  FlatColonGridOptions smoother = PixelsOf(0.5);
  smoother.normalLength = 1.0;
  EXPECT_NE(&fine, &flat.Grid(smoother));
}

TEST(FlatColon, HasTheGridAndTheAxisOfItsSurface)
{
  const shapeton::SurfaceMesh mesh = MakeCylinder({});
  const FlatColon             flat(mesh);
  const FlatColonGrid         grid(mesh);
  ASSERT_EQ(flat.Grid().Columns(), grid.Columns());
  ASSERT_EQ(flat.Grid().Rows(), grid.Rows());
  flattubes::ForPixels(grid, [&](int column, int row) {
    ASSERT_EQ(flat.Grid().FaceOfPixel(column, row), grid.FaceOfPixel(column, row));
    ASSERT_EQ(flat.Grid().PointOfPixel(column, row), grid.PointOfPixel(column, row));
  });
  const shapeton::FlatColonAxis axis = MakeFlatColonAxis(grid);
  EXPECT_EQ(flat.Axis().centers, axis.centers);
  EXPECT_EQ(flat.Axis().radii, axis.radii);
  EXPECT_EQ(flat.Surface().V, mesh.V);
}

// The curvature of a cylinder of radius R is -1/(2R), including along the cut and for either face orientation.
TEST(FlatColon, KnowsTheCurvatureOfTheTubeWithoutItsCut)
{
  for (const bool isInsideOut : { false, true })
  {
    flattubes::TubeForm form;
    form.isInsideOut = isInsideOut;
    const FlatColon         flat(MakeCylinder(form));
    const Eigen::VectorXd & curvature = flat.Curvature(0.0);
    EXPECT_EQ(&curvature, &flat.Curvature(0.0));
    EXPECT_NE(&curvature, &flat.Curvature(0.0, CurvatureUnit::Published));
    ASSERT_EQ(curvature.size(), form.around * (form.along + 1));
    const double expected = -flattubes::pi / form.circumference;
    for (Eigen::Index i = form.around; i < curvature.size() - form.around; ++i)
    {
      ASSERT_NEAR(curvature[i], expected, 1e-9);
    }
  }
}

TEST(FlatColon, ServesSeveralThreadsAtOnce)
{
  const FlatColon                                 flat(MakeCylinder({}));
  std::vector<std::future<const FlatColonGrid *>> grids;
  std::vector<std::future<const double *>>        curvatures;
  for (int i = 0; i < 8; ++i)
  {
    grids.push_back(std::async(std::launch::async, [&flat] { return &flat.Grid(); }));
    curvatures.push_back(std::async(std::launch::async, [&flat] { return flat.Curvature(2.0).data(); }));
  }
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_EQ(grids[i].get(), &flat.Grid());
    EXPECT_EQ(curvatures[i].get(), flat.Curvature(2.0).data());
  }
}

TEST(FlatColon, NamesTheSurfaceThatIsNotFlat)
{
  shapeton::SurfaceMesh mesh = MakeCylinder({});
  mesh.pointArrays.clear();
  const FlatColon flat(mesh, {}, "flat.vtp");
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    EXPECT_EQ(basetest::ErrorOf([&] { flat.Grid(); }).rfind("flat.vtp", 0), 0u);
  }
  EXPECT_THROW(FlatColon(MakeCylinder({})).Grid(PixelsOf(0.0)), shapeton::ParameterError);
  EXPECT_THROW(FlatColon(MakeCylinder({})).Curvature(-1.0), shapeton::ParameterError);
}
