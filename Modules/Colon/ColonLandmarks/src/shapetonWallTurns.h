#ifndef shapetonWallTurns_h
#define shapetonWallTurns_h

#include "shapetonFlatColonGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shapeton
{
/** \class WallTurns
 * \brief Angles around the tube measured by wall length, in turns: their difference times the girth is the length of
 * wall in between.
 *
 * The angles of the flat map differ: where a section is flat, a conformal map stretches the far side. Taeniae divide
 * the wall in space into thirds, but the map into anything from 45 to 225 degrees. The two kinds of angles agree on
 * average over the wall of each row, so a line along the tube is one in both. */
class WallTurns
{
public:
  /** Without rows. */
  WallTurns() = default;

  /** Measures rows of `columnsPerRow` columns of the grid. */
  WallTurns(const FlatColonGrid & grid, int rows, int columnsPerRow);

  /** The angles of the map itself. */
  static WallTurns
  OfMap(const FlatColonGrid & grid, int rows);

  /** Converts an angle of the map in turns, in the direction of the grid rows; increases by 1 per turn. */
  double
  FromMap(int row, double turns) const;

  /** Inverse of the above. */
  double
  ToMap(int row, double turns) const;

  /** Calls take(cell, share) for each of the cells around the wall that overlap a pixel of the grid; shares are
   * relative to a cell. */
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
  /** Start of each pixel of the grid, and the end of the turn. */
  std::vector<double> m_Borders;
};
} // namespace shapeton

#endif
