#ifndef shapetonFlatColonRows_h
#define shapetonFlatColonRows_h

#include "shapetonFlatColonGrid.h"

#include <vector>

namespace shapeton
{
/** Columns that a picture leaves out. \ingroup FlatColon */
struct FlatColonCut
{
  int firstColumn{ 0 };
  int columns{ 0 };
};

/** A part of the flat map that is one row of a picture. \ingroup FlatColon */
struct FlatColon_EXPORT FlatColonRow
{
  /** Of the grid; `columns` counts those left out, too. */
  int firstColumn{ 0 };
  int columns{ 0 };
  /** Within the row, in order: the middle of long bridges. */
  std::vector<FlatColonCut> cuts;
  /** mm on the surface for each mm of the map: the median over the row, and the values that 10 % and 90 % of its pixels
   * do not exceed. Bridged pixels are left aside where there are others. */
  double scale{ 1.0 };
  double lowScale{ 1.0 };
  double highScale{ 1.0 };

  /** Pixels of the row. */
  int
  ShownColumns() const;
  /** The place in the row, in pixels from its left border, of a place in columns of the grid; what is left out lies at
   * the cut. */
  double
  PlaceOf(double column) const;
  /** The column of the grid that a pixel of the row shows. */
  int
  ColumnAt(int place) const;
  /** Whether a place in columns of the grid is in the row and shown. */
  bool
  Shows(double column) const;
};

/** Rows of nearly equal length, as few as have at most `greatestColumns` pixels each, in order, without overlap. Of a
 * stretch that is bridged all around and longer than `longestBridge` pixels only that many are shown, half at each end;
 * 0 shows all. \ingroup FlatColon */
FlatColon_EXPORT std::vector<FlatColonRow>
                 BreakIntoRows(const FlatColonGrid & grid, int greatestColumns, int longestBridge = 0);

/** A mark of a ruler. \ingroup FlatColon */
struct FlatColonTick
{
  /** Where it lies, in columns; 0 is the left border of the first one. */
  double column{ 0.0 };
  /** mm; a multiple of the step. */
  double distance{ 0.0 };
};

/** Where the distance along the centreline is a multiple of `step` (mm, greater than 0). A value that holds on over
 * several columns has its mark at the first. \ingroup FlatColon */
FlatColon_EXPORT std::vector<FlatColonTick>
                 RulerTicks(const std::vector<double> & distanceOfColumns, double step);
} // namespace shapeton

#endif
