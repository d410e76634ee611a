#include "shapetonFlatColonOverlay.h"

#include "shapetonFlatColonLocator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shapeton
{
namespace
{
void
RequireSize(const Picture * strip, const FlatColonGrid & grid)
{
  const auto size = strip->GetLargestPossibleRegion().GetSize();
  if (size[0] != static_cast<itk::SizeValueType>(grid.Columns()) ||
      size[1] != static_cast<itk::SizeValueType>(grid.Rows()))
  {
    throw std::invalid_argument("the strip does not have the size of the grid");
  }
}

/** Column and row of a position on the map; (0, 0) is the center of the first pixel. */
Eigen::Vector2d
PictureOfUv(const FlatColonGrid & grid, const Eigen::Vector2d & uv)
{
  const double down = grid.IsMirrored() ? grid.Circumference() - uv.y() : uv.y();
  const double turn = down / grid.Circumference() - std::floor(down / grid.Circumference());
  return { uv.x() / grid.PixelSize() - 0.5, turn * grid.Rows() - 0.5 };
}
} // namespace

void
DrawFlatOutlines(Picture * strip, const FlatColonGrid & grid, const FlatOutlines & outlines)
{
  RequireSize(strip, grid);
  if (outlines.columns < 1 || outlines.rows < 1 || !outlines.labels || !outlines.colorOf)
  {
    throw std::invalid_argument("there are no labels to outline");
  }
  const auto labelAt = [&](int column, int row) -> int {
    const int wrapped = (row % grid.Rows() + grid.Rows()) % grid.Rows();
    const int within = std::clamp(column, 0, grid.Columns() - 1);
    const int x = std::min(outlines.columns - 1, static_cast<int>((within + 0.5) * outlines.columns / grid.Columns()));
    const int y = std::min(outlines.rows - 1, static_cast<int>((wrapped + 0.5) * outlines.rows / grid.Rows()));
    return outlines.labels[static_cast<std::size_t>(y) * outlines.columns + x];
  };
  const auto isAtBorder = [&](int column, int row, int label) {
    const int reach = outlines.thickness;
    return labelAt(column - reach, row) != label || labelAt(column + reach, row) != label ||
           labelAt(column, row - reach) != label || labelAt(column, row + reach) != label;
  };
  for (int row = 0; row < grid.Rows(); ++row)
  {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const int label = labelAt(column, row);
      if (label > 0 && isAtBorder(column, row, label))
      {
        strip->GetBufferPointer()[static_cast<std::size_t>(row) * grid.Columns() + column] = outlines.colorOf(label);
      }
    }
  }
}

void
DrawFlatLine(Picture * strip, const FlatColonGrid & grid, const FlatLine & line)
{
  RequireSize(strip, grid);
  const double turn = grid.Rows();
  for (std::size_t i = 0; i + 1 < line.places.size(); ++i)
  {
    if (!line.places[i].allFinite() || !line.places[i + 1].allFinite())
    {
      continue;
    }
    const Eigen::Vector2d from = PictureOfUv(grid, line.places[i]);
    Eigen::Vector2d       to = PictureOfUv(grid, line.places[i + 1]);
    to.y() = from.y() + std::remainder(to.y() - from.y(), turn);
    for (const double shift : { -turn, 0.0, turn }) // wrap around the tube
    {
      DrawLine(strip, from.x(), from.y() + shift, to.x(), to.y() + shift, line.color, line.thickness);
    }
  }
}

void
DrawFlatDot(Picture * strip, const FlatColonGrid & grid, const FlatDot & dot)
{
  RequireSize(strip, grid);
  static const RGBColor rim = MakeColor(20, 20, 24);
  const Eigen::Vector2d place = PictureOfUv(grid, dot.uv);
  for (const double shift : { -1.0 * grid.Rows(), 0.0, 1.0 * grid.Rows() })
  {
    const double y = place.y() + shift;
    DrawLine(strip, place.x(), y, place.x(), y, rim, 2.0 * dot.radius + 2.0);
    DrawLine(strip, place.x(), y, place.x(), y, dot.color, 2.0 * dot.radius);
  }
}

void
DrawFlatHatching(Picture *                            strip,
                 const FlatColonGrid &                grid,
                 const std::vector<double> &          distanceOfColumns,
                 const std::vector<HinderedStretch> & stretches)
{
  constexpr int  period = 8;
  const RGBColor hatch = MakeColor(90, 94, 106);
  RequireSize(strip, grid);
  for (std::size_t column = 0; column < distanceOfColumns.size(); ++column)
  {
    if (HindranceAt(stretches, distanceOfColumns[column]) == ColonHindrance::None)
    {
      continue;
    }
    const auto x = static_cast<int>(column);
    for (int row = (x + period - 1) % period; row < grid.Rows(); row += period)
    {
      strip->SetPixel({ { x, row } }, hatch);
      strip->SetPixel({ { x, (row + 1) % grid.Rows() } }, hatch);
    }
  }
}

std::vector<Eigen::Vector2d>
PlacesOfCurve(const FlatColonGrid & grid, const std::vector<Eigen::Vector3d> & points, double step, double farthest)
{
  const FlatColonLocator       locator(grid);
  std::vector<Eigen::Vector2d> places;
  const auto                   add = [&](const Eigen::Vector3d & point) {
    const FlatPlace place = locator.Find(point);
    places.push_back(place.distance <= farthest
                       ? place.uv
                       : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()).eval());
  };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d next = points[std::min(i + 1, points.size() - 1)];
    const int             parts = std::max(1, static_cast<int>(std::ceil((next - points[i]).norm() / step)));
    for (int part = 0; part < parts; ++part)
    {
      add(points[i] + (next - points[i]) * part / parts);
    }
  }
  return places;
}
} // namespace shapeton
