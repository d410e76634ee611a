#include "shapetonFlatColonOverlay.h"

#include "shapetonFlatTestColon.h"
#include "shapetonPictureTestUtilities.h"

#include <limits>
#include <stdexcept>

namespace
{
using shapeton::At;
using shapeton::FlatColonGrid;

const shapeton::RGBColor paper = shapeton::MakeColor(0, 0, 0);
const shapeton::RGBColor ink = shapeton::MakeColor(200, 0, 0);

shapeton::Picture::Pointer
StripOf(const FlatColonGrid & grid)
{
  return shapeton::NewPicture(grid.Columns(), grid.Rows(), paper);
}

/** Empty label image of a grid of this size. */
struct Labels
{
  Labels(int columns, int rows) : columns(columns), rows(rows), values(columns * rows, 0) {}

  shapeton::FlatOutlines
  Outlines() const
  {
    return { values.data(), columns, rows, [](int label) { return label == 7 ? ink : paper; }, 1 };
  }

  int                         columns;
  int                         rows;
  std::vector<unsigned short> values;
};
} // namespace

TEST(FlatColonOverlay, OutlinesLabelsAlsoAcrossTheCut)
{
  const FlatColonGrid grid(flatcolon::Wall());
  Labels              labels(grid.Columns(), grid.Rows());
  for (int column = 40; column < 60; ++column)
  {
    for (const int row : { grid.Rows() - 3, grid.Rows() - 2, grid.Rows() - 1, 0, 1, 2 })
    {
      labels.values[row * grid.Columns() + column] = 7;
    }
  }
  auto strip = StripOf(grid);
  DrawFlatOutlines(strip, grid, labels.Outlines());
  for (const int row : { grid.Rows() - 3, 2 })
  {
    EXPECT_EQ(At(strip, 50, row), ink) << "the rim";
  }
  for (const int row : { grid.Rows() - 4, 3, grid.Rows() - 1, 0 })
  {
    EXPECT_EQ(At(strip, 50, row), paper) << "outside, and inside on both sides of the cut";
  }
  EXPECT_EQ(At(strip, 40, 0), ink);
  EXPECT_EQ(At(strip, 39, 0), paper);
}

TEST(FlatColonOverlay, LabelsMayHaveAnotherPixelSize)
{
  const FlatColonGrid grid(flatcolon::Wall());
  Labels              labels(grid.Columns() / 3, grid.Rows() / 3);
  labels.values[10 * labels.columns + 20] = 7;
  auto strip = StripOf(grid);
  DrawFlatOutlines(strip, grid, labels.Outlines());
  int painted = 0;
  for (int row = 0; row < grid.Rows(); ++row)
  {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      if (At(strip, column, row) != paper)
      {
        ++painted;
        EXPECT_NEAR(column, 20.5 * grid.Columns() / labels.columns, 2.0);
        EXPECT_NEAR(row, 10.5 * grid.Rows() / labels.rows, 2.0);
      }
    }
  }
  EXPECT_GE(painted, 6);
}

TEST(FlatColonOverlay, LinesGoTheShorterWayAroundAndBreak)
{
  const FlatColonGrid   grid(flatcolon::Wall());
  const double          around = grid.Circumference();
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  auto                  strip = StripOf(grid);
  DrawFlatLine(strip, grid, { { { 50.0, 0.05 * around }, { 60.0, 0.95 * around }, nowhere, { 90.0, 1.0 } }, ink, 2.0 });
  bool isAtTop = false;
  bool isAtBottom = false;
  for (int column = 0; column < grid.Columns(); ++column)
  {
    isAtTop = isAtTop || At(strip, column, 1) != paper;
    isAtBottom = isAtBottom || At(strip, column, grid.Rows() - 2) != paper;
    EXPECT_EQ(At(strip, column, grid.Rows() / 2), paper);
    EXPECT_TRUE(column < 65 || At(strip, column, 1) == paper);
  }
  EXPECT_TRUE(isAtTop);
  EXPECT_TRUE(isAtBottom);
}

TEST(FlatColonOverlay, NeedsAStripOfTheGrid)
{
  const FlatColonGrid grid(flatcolon::Wall());
  const auto          small = shapeton::NewPicture(3, 3, paper);
  EXPECT_THROW(DrawFlatOutlines(small, grid, Labels(3, 3).Outlines()), std::invalid_argument);
  EXPECT_THROW(DrawFlatLine(small, grid, {}), std::invalid_argument);
  EXPECT_THROW(DrawFlatDot(small, grid, {}), std::invalid_argument);
}
