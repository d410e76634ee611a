#ifndef itkFlatColonRows_h
#define itkFlatColonRows_h

#include "itkFlatColonGrid.h"

#include <vector>

namespace itk
{
/** A part of the flat map that is one row of a picture. \ingroup FlatColonGrid */
struct FlatColonRow
{
  int firstColumn{ 0 };
  int columns{ 0 };
  /** mm on the surface for each mm of the map: the median over the row, and the values that 10 % and 90 % of its pixels
   * do not exceed. Bridged pixels are left aside where there are others. */
  double scale{ 1.0 };
  double lowScale{ 1.0 };
  double highScale{ 1.0 };
};

/** Rows of nearly equal length, as few as have at most `greatestColumns` columns each, in order, without overlap.
 * \ingroup FlatColonGrid */
FlatColonGrid_EXPORT std::vector<FlatColonRow>
                     BreakIntoRows(const FlatColonGrid & grid, int greatestColumns);

/** A mark of a ruler. \ingroup FlatColonGrid */
struct FlatColonTick
{
  /** Where it lies, in columns; 0 is the left border of the first one. */
  double column{ 0.0 };
  /** mm; a multiple of the step. */
  double distance{ 0.0 };
};

/** Where the distance along the centreline is a multiple of `step` (mm, greater than 0). A value that holds on over
 * several columns has its mark at the first. \ingroup FlatColonGrid */
FlatColonGrid_EXPORT std::vector<FlatColonTick>
                     RulerTicks(const std::vector<double> & distanceOfColumns, double step);
} // namespace itk

#endif
