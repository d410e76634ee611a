#include "itkFlatColonOverlay.h"

#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
/** Regions by the pixels of the grid. */
class RegionsOnGrid
{
public:
  RegionsOnGrid(const Image<unsigned short, 2> * regions, const FlatColonGrid & grid) : m_Regions(regions), m_Grid(grid)
  {}

  /** 0 beyond the ends of the tube. */
  unsigned short
  At(int column, int row) const
  {
    if (column < 0 || column >= m_Grid.Columns())
    {
      return 0;
    }
    const int             wrapped = (row + m_Grid.Rows()) % m_Grid.Rows();
    const Eigen::Vector2d uv = m_Grid.UvOfPixel(column, wrapped);
    Point<double, 2>      place;
    place[0] = uv.x();
    place[1] = uv.y();
    Index<2>   index;
    const bool isInside = m_Regions->TransformPhysicalPointToIndex(place, index);
    return isInside ? m_Regions->GetPixel(index) : 0;
  }

private:
  const Image<unsigned short, 2> * m_Regions;
  const FlatColonGrid &            m_Grid;
};

/** The inner rim of each region. */
void
PaintOutlines(Picture * strip, const FlatColonGrid & grid, const FlatColonOverlay & overlay)
{
  const RegionsOnGrid regions(overlay.regions, grid);
  for (int row = 0; row < grid.Rows(); ++row)
  {
    for (int column = 0; column < grid.Columns(); ++column)
    {
      const unsigned short here = regions.At(column, row);
      if (here != 0 && (regions.At(column - 1, row) != here || regions.At(column + 1, row) != here ||
                        regions.At(column, row - 1) != here || regions.At(column, row + 1) != here))
      {
        FillRectangle(strip, column, row, 1, 1, overlay.regionColor, 0.85);
      }
    }
  }
}

void
PaintCurve(Picture * strip, const FlatColonGrid & grid, const FlatCurve & curve)
{
  const Eigen::Vector2d first = grid.UvOfPixel(0, 0);
  const double          step = grid.PixelSize();
  const double          down = grid.IsMirrored() ? -step : step;
  const auto            placeOf = [&](const Eigen::Vector2d & uv) {
    return Eigen::Vector2d((uv.x() - first.x()) / step, (uv.y() - first.y()) / down);
  };
  const double rows = grid.Rows();
  for (std::size_t i = 1; i < curve.uv.size(); ++i)
  {
    Eigen::Vector2d a = placeOf(curve.uv[i - 1]);
    Eigen::Vector2d b = placeOf(curve.uv[i]);
    a.y() -= rows * std::floor(a.y() / rows);
    b.y() -= rows * std::round((b.y() - a.y()) / rows);
    for (const double turn : { -rows, 0.0, rows })
    {
      DrawLine(strip, a.x(), a.y() + turn, b.x(), b.y() + turn, curve.color, curve.width);
    }
  }
}
} // namespace

void
PaintFlatOverlay(Picture * strip, const FlatColonGrid & grid, const FlatColonOverlay & overlay)
{
  const auto size = strip->GetBufferedRegion().GetSize();
  if (static_cast<int>(size[0]) != grid.Columns() || static_cast<int>(size[1]) != grid.Rows())
  {
    throw std::invalid_argument("the strip has not the size of the grid");
  }
  if (overlay.regions)
  {
    PaintOutlines(strip, grid, overlay);
  }
  for (const FlatCurve & curve : overlay.curves)
  {
    PaintCurve(strip, grid, curve);
  }
}
} // namespace itk
