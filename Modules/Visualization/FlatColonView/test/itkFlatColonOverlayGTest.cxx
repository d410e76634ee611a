#include "itkFlatColonOverlay.h"

#include "itkFlatCoordinateMap.h"
#include "itkFlatTestColon.h"
#include "itkPictureTestUtilities.h"

#include <stdexcept>

namespace
{
using itk::At;
using itk::FlatColonGrid;
using Regions = itk::Image<unsigned short, 2>;

const itk::RGBColor paper = itk::MakeColor(0, 0, 0);
const itk::RGBColor ink = itk::MakeColor(200, 0, 0);

itk::Picture::Pointer
StripOf(const FlatColonGrid & grid)
{
  return itk::NewPicture(grid.Columns(), grid.Rows(), paper);
}

/** 0 everywhere; on the map of another grid. */
Regions::Pointer
RegionsOf(const FlatColonGrid & grid)
{
  const auto map = itk::MakeFlatCoordinateMap(grid);
  auto       regions = Regions::New();
  regions->CopyInformation(map);
  regions->SetRegions(map->GetBufferedRegion());
  regions->Allocate();
  regions->FillBuffer(0);
  return regions;
}
} // namespace

TEST(FlatColonOverlay, OutlinesRegionsAlsoAcrossTheCut)
{
  const FlatColonGrid   grid(flatcolon::Wall());
  const auto            regions = RegionsOf(grid);
  itk::FlatColonOverlay overlay;
  overlay.regions = regions;
  overlay.regionColor = ink;
  for (int column = 40; column < 60; ++column)
  {
    for (const int row : { grid.Rows() - 3, grid.Rows() - 2, grid.Rows() - 1, 0, 1, 2 })
    {
      regions->SetPixel({ { column, row } }, 7);
    }
  }
  auto strip = StripOf(grid);
  PaintFlatOverlay(strip, grid, overlay);
  for (const int row : { grid.Rows() - 3, 2 })
  {
    EXPECT_GT(At(strip, 50, row)[0], 100) << "the rim";
  }
  for (const int row : { grid.Rows() - 4, 3, grid.Rows() - 1, 0 })
  {
    EXPECT_EQ(At(strip, 50, row), paper) << "outside, and inside on both sides of the cut";
  }
  EXPECT_GT(At(strip, 40, 0)[0], 100);
  EXPECT_EQ(At(strip, 39, 0), paper);
}

TEST(FlatColonOverlay, RegionsMayHaveAnotherPixelSize)
{
  const itk::SurfaceMesh    wall = flatcolon::Wall();
  itk::FlatColonGridOptions coarse;
  coarse.pixelSize = 3.0;
  const FlatColonGrid   grid(wall);
  const auto            regions = RegionsOf(FlatColonGrid(wall, coarse));
  itk::FlatColonOverlay overlay;
  overlay.regions = regions;
  overlay.regionColor = ink;
  regions->SetPixel({ { 20, 10 } }, 1);
  auto strip = StripOf(grid);
  PaintFlatOverlay(strip, grid, overlay);
  int painted = 0;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      if (At(strip, column, row) != paper)
      {
        ++painted;
        EXPECT_NEAR(column, 61, 2);
        EXPECT_NEAR(row, 31, 2);
      }
    }
  }
  EXPECT_GE(painted, 6);
}

TEST(FlatColonOverlay, LinesGoTheShorterWayAround)
{
  const FlatColonGrid   grid(flatcolon::Wall());
  const double          around = grid.Circumference();
  itk::FlatColonOverlay overlay;
  overlay.curves.push_back({ { { 50.0, 0.05 * around }, { 60.0, 0.95 * around } }, ink, 2.0 });
  auto strip = StripOf(grid);
  PaintFlatOverlay(strip, grid, overlay);
  bool isAtTop = false;
  bool isAtBottom = false;
  for (int column = 45; column < 65; ++column)
  {
    isAtTop = isAtTop || At(strip, column, 1) != paper;
    isAtBottom = isAtBottom || At(strip, column, grid.Rows() - 2) != paper;
    EXPECT_EQ(At(strip, column, grid.Rows() / 2), paper);
  }
  EXPECT_TRUE(isAtTop);
  EXPECT_TRUE(isAtBottom);
}

TEST(FlatColonOverlay, NeedsAStripOfTheGrid)
{
  const FlatColonGrid grid(flatcolon::Wall());
  EXPECT_THROW(PaintFlatOverlay(itk::NewPicture(3, 3, paper), grid, {}), std::invalid_argument);
}
