#ifndef shapetonWallTurns_h
#define shapetonWallTurns_h

#include "shapetonFlatColonGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shapeton
{
/** \class WallTurns
 * \brief Angles around the tube by the length of the wall, in turns: what lies between two of them is their difference
 * times the girth.
 *
 * Angles of the flat map are not that: where a section is flat, a conformal map draws the side that is farther away
 * apart. Taeniae divide the wall in space into thirds, and the map into anything from 45 to 225 degrees. The two kinds
 * of angles agree in the mean over the wall of each row, so that what runs along the tube does so in both. */
class WallTurns
{
public:
  /** Of no row. */
  WallTurns() = default;

  /** For rows of so many columns of the grid. */
  WallTurns(const FlatColonGrid & grid, int rows, int columnsPerRow);

  /** Those of the map itself. */
  static WallTurns
  OfMap(const FlatColonGrid & grid, int rows);

  /** Of an angle of the map in turns, in the direction of the grid's rows; rises by 1 with each turn. */
  double
  FromMap(int row, double turns) const;

  /** The inverse. */
  double
  ToMap(int row, double turns) const;

  /** Calls take(cell, share) for each of so many cells around the wall that a pixel of the grid lies in; shares are of
   * a cell. */
  template <typename TTake>
  void
  ForCellsOfPixel(int row, int pixelRow, int cells, const TTake & take) const
  {
    const double begin = cells * this->Border(row, pixelRow);
    const double end = cells * this->Border(row, pixelRow + 1);
    for (auto cell = static_cast<int>(std::floor(begin)); cell < end; ++cell)
    {
      const double share = std::min(end, cell + 1.0) - std::max(begin, static_cast<double>(cell));
      take((cell % cells + cells) % cells, share);
    }
  }

private:
  WallTurns(int rows, int pixels);

  double
  Border(int row, int pixelRow) const
  {
    return m_Borders[static_cast<std::size_t>(row) * (m_Pixels + 1) + pixelRow];
  }

  int m_Pixels{ 0 };
  /** Where each pixel of the grid begins, and at last where the turn ends. */
  std::vector<double> m_Borders;
};
} // namespace shapeton

#endif
