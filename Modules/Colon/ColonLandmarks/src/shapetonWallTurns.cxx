#include "shapetonWallTurns.h"

#include "shapetonSmoothedRows.h"

namespace shapeton
{
namespace
{
/** Standard deviation (rows) of the smoothing along the tube, required since folds lengthen the wall locally. */
constexpr double smoothingOfTurns = 6.0;

/** Circumferential wall length per pixel, averaged over the columns of a row; in holes, the mean of the row. */
std::vector<double>
LengthsOfWall(const FlatColonGrid & grid, int rows, int columnsPerRow)
{
  const int           pixels = grid.Rows();
  std::vector<double> lengths(static_cast<std::size_t>(rows) * pixels, 0.0);
  for (int row = 0; row < rows; ++row)
  {
    double total = 0.0;
    int    seen = 0;
    for (int pixel = 0; pixel < pixels; ++pixel)
    {
      double sum = 0.0;
      int    count = 0;
      for (int column = row * columnsPerRow; column < (row + 1) * columnsPerRow; ++column)
      {
        if (grid.FaceOfPixel(column, pixel) >= 0)
        {
          sum += grid.SampleOfPixel(column, pixel).scale;
          ++count;
        }
      }
      lengths[static_cast<std::size_t>(row) * pixels + pixel] = count > 0 ? sum / count : 0.0;
      total += count > 0 ? sum / count : 0.0;
      seen += count > 0 ? 1 : 0;
    }
    const double mean = seen > 0 ? total / seen : 1.0;
    for (int pixel = 0; pixel < pixels; ++pixel)
    {
      double & length = lengths[static_cast<std::size_t>(row) * pixels + pixel];
      length = length > 0.0 ? length : mean;
    }
  }
  return lengths;
}
} // namespace

WallTurns::WallTurns(int rows, int pixels)
  : m_Pixels(pixels), m_Borders(static_cast<std::size_t>(rows) * (pixels + 1), 0.0)
{}

WallTurns::WallTurns(const FlatColonGrid & grid, int rows, int columnsPerRow) : WallTurns(rows, grid.Rows())
{
  const std::vector<double> lengths = SmoothedRows(LengthsOfWall(grid, rows, columnsPerRow), rows, smoothingOfTurns);
  for (int row = 0; row < rows; ++row)
  {
    const double * const ofRow = &lengths[static_cast<std::size_t>(row) * m_Pixels];
    double * const       borders = &m_Borders[static_cast<std::size_t>(row) * (m_Pixels + 1)];
    double               total = 0.0;
    for (int pixel = 0; pixel < m_Pixels; ++pixel)
    {
      total += ofRow[pixel];
    }
    double offset = 0.0; // map turns minus wall turns, averaged over the wall
    for (int pixel = 0; pixel < m_Pixels; ++pixel)
    {
      const double share = ofRow[pixel] / total;
      borders[pixel + 1] = borders[pixel] + share;
      offset += share * ((pixel + 0.5) / m_Pixels - (borders[pixel] + 0.5 * share));
    }
    borders[m_Pixels] = 1.0;
    for (int pixel = 0; pixel <= m_Pixels; ++pixel)
    {
      borders[pixel] += offset;
    }
  }
}

WallTurns
WallTurns::OfMap(const FlatColonGrid & grid, int rows)
{
  WallTurns turns(rows, grid.Rows());
  for (std::size_t i = 0; i < turns.m_Borders.size(); ++i)
  {
    turns.m_Borders[i] = static_cast<double>(i % (turns.m_Pixels + 1)) / turns.m_Pixels;
  }
  return turns;
}

double
WallTurns::FromMap(int row, double turns) const
{
  const double whole = std::floor(turns);
  const double place = (turns - whole) * m_Pixels;
  const int    pixel = std::min(static_cast<int>(place), m_Pixels - 1);
  const double begin = this->Border(row, pixel);
  return whole + begin + (place - pixel) * (this->Border(row, pixel + 1) - begin);
}

double
WallTurns::ToMap(int row, double turns) const
{
  const double * const borders = &m_Borders[static_cast<std::size_t>(row) * (m_Pixels + 1)];
  const double         whole = std::floor(turns - borders[0]);
  const double         rest = turns - whole;
  const auto           next = std::upper_bound(borders + 1, borders + m_Pixels, rest);
  const double         begin = *(next - 1);
  return whole + (static_cast<double>(next - 1 - borders) + (rest - begin) / (*next - begin)) / m_Pixels;
}
} // namespace shapeton
