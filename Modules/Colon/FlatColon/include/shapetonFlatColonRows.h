#ifndef shapetonFlatColonRows_h
#define shapetonFlatColonRows_h

#include "shapetonFlatColonGrid.h"

#include <vector>

namespace shapeton
{
/** Columns omitted from a picture. \ingroup ShapetonFlatColon */
struct FlatColonCut
{
  int firstColumn{ 0 };
  int columns{ 0 };
};

/** A part of the flat map shown as one row of a picture. \ingroup ShapetonFlatColon */
struct ShapetonFlatColon_EXPORT FlatColonRow
{
  /** Columns of the grid; `columns` includes omitted ones. */
  int firstColumn{ 0 };
  int columns{ 0 };
  /** Omitted columns in order: the middle of long bridges. */
  std::vector<FlatColonCut> cuts;
  /** mm on the surface per mm of the map: median, 10th and 90th percentile over the row. Bridged pixels are excluded
   * unless all are bridged. */
  double scale{ 1.0 };
  double lowScale{ 1.0 };
  double highScale{ 1.0 };

  /** Number of pixels in the row. */
  int
  ShownColumns() const;
  /** Converts a position in grid columns to pixels from the left border of the row; omitted columns are mapped to the
   * cut. */
  double
  PlaceOf(double column) const;
  /** The grid column shown by a pixel of the row. */
  int
  ColumnAt(int place) const;
  /** Whether a position in columns of the grid is in the row and visible. */
  bool
  Shows(double column) const;
};

/** Splits the grid into the minimum number of consecutive rows of nearly equal length with at most `greatestColumns`
 * pixels. Completely bridged stretches are shortened to `longestBridge` pixels, half at each end; 0 disables
 * shortening. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<FlatColonRow>
                         BreakIntoRows(const FlatColonGrid & grid, int greatestColumns, int longestBridge = 0);

/** A tick of a ruler. \ingroup ShapetonFlatColon */
struct FlatColonTick
{
  /** Position in columns; 0 is the left border of the first one. */
  double column{ 0.0 };
  /** Distance in mm; a multiple of the step. */
  double distance{ 0.0 };
};

/** Ticks at multiples of `step` (mm, greater than 0) of the distance along the centerline; where the distance is
 * constant, at the first column. \ingroup ShapetonFlatColon */
ShapetonFlatColon_EXPORT std::vector<FlatColonTick>
                         RulerTicks(const std::vector<double> & distanceOfColumns, double step);
} // namespace shapeton

#endif
