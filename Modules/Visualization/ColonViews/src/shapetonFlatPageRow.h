#ifndef shapetonFlatPageRow_h
#define shapetonFlatPageRow_h

#include "shapetonFlatColonPage.h"
#include "shapetonFlatColonRows.h"

namespace shapeton
{
/** An annotation with its position in columns and rows of the grid. */
struct PlacedAnnotation
{
  FlatAnnotation annotation;
  double         column{ 0.0 };
  double         row{ 0.0 };
  /** Diameter of a polyp, pixels. */
  double diameter{ 0.0 };
};

/** Layout and content of a row of the page. */
struct FlatPageRow
{
  static constexpr int header = 50; ///< pixels above the strip: the scale bar, and names below it
  static constexpr int ruler = 44;  ///< pixels below the strip

  FlatColonRow row;
  int          left{ 0 };    ///< left edge of the first column
  int          top{ 0 };     ///< top edge of the header
  int          overlap{ 0 }; ///< repeated pixels above and below one turn
  int          turn{ 0 };    ///< rows of the grid

  int
  StripTop() const
  {
    return top + header;
  }
  int
  StripHeight() const
  {
    return turn + 2 * overlap;
  }
  int
  Bottom() const
  {
    return this->StripTop() + this->StripHeight() + ruler;
  }
  /** Converts grid columns (0: left edge of the first column) to an x coordinate of the picture. */
  double
  XOf(double column) const
  {
    return left + row.PlaceOf(column) - 0.5;
  }
  int
  Width() const
  {
    return row.ShownColumns();
  }
};

/** Draws the strip: hatched where the wall is bridged, broken at shortened bridges, paler beyond one turn. */
void
DrawStripOfRow(Picture * picture, const FlatPageRow & place, const Picture * strip, const FlatColonGrid & grid);

/** Draws ticks every cm, with numbers where they fit. */
void
DrawRulerOfRow(Picture * picture, const FlatPageRow & place, const std::vector<double> & distanceOfColumns, bool isArc);

/** Draws the local scale bar, at the right above the names. */
void
DrawScaleOfRow(Picture * picture, const FlatPageRow & place, double pixelSize);

/** Draws segment names above the strip, and polyps and marks on it. */
void
DrawAnnotationsOfRow(Picture * picture, const FlatPageRow & place, const std::vector<PlacedAnnotation> & annotations);
} // namespace shapeton

#endif
