#ifndef shapetonWallTurns_h
#define shapetonWallTurns_h

#include "shapetonFlatColonGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shapeton
{
/** \class WallTurns
 * \brief Angles around the tube (in turns) measured by wall length: the difference between two angles times the girth
 * is a length of wall.
 *
 * Map angles differ, since a conformal map is distorted where the cross-section is flat. Taeniae divide the wall into
 * thirds, but the map into sectors of 45 to 225 degrees. The two angles agree on average in each row, so a longitudinal
 * line is longitudinal in both. */
class WallTurns
{
public:
  /** Creates an object that has no rows. */
  WallTurns() = default;

  /** Measures rows of `columnsPerRow` columns of the grid. */
  WallTurns(const FlatColonGrid & grid, int rows, int columnsPerRow);

  /** Uses the map angles unchanged. */
  static WallTurns
  OfMap(const FlatColonGrid & grid, int rows);

  /** Converts a map angle (turns, in grid row direction) to a wall angle; increases by 1 per turn. */
  double
  FromMap(int row, double turns) const;

  /** Converts a wall angle to a map angle. */
  double
  ToMap(int row, double turns) const;

  /** Calls take(cell, share) for each wall cell that overlaps a grid pixel; `share` is the overlap as a fraction of the
   * cell. */
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
  /** Start of each grid pixel, and the end of the turn. */
  std::vector<double> m_Borders;
};
} // namespace shapeton

#endif
