#ifndef shapetonFlatPageRow_h
#define shapetonFlatPageRow_h

#include "shapetonFlatColonPage.h"
#include "shapetonFlatColonRows.h"

namespace shapeton
{
/** An annotation with its place in columns and rows of the grid. */
struct PlacedAnnotation
{
  FlatAnnotation annotation;
  double         column{ 0.0 };
  double         row{ 0.0 };
  /** Of a polyp, in pixels. */
  double diameter{ 0.0 };
};

/** A row of the page: where it lies, and what it shows. */
struct FlatPageRow
{
  static constexpr int header = 50; ///< pixels above the strip: the scale, and below it names
  static constexpr int ruler = 44;  ///< below it

  FlatColonRow row;
  int          left{ 0 };    ///< of the first column
  int          top{ 0 };     ///< of the header
  int          overlap{ 0 }; ///< pixels above and below one turn
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
  /** The picture's x of a place in columns of the grid (0: the left border of the first one). */
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

/** The strip, hatched where the wall is bridged, broken where a bridge is cut short, paler beyond one turn. */
void
DrawStripOfRow(Picture * picture, const FlatPageRow & place, const Picture * strip, const FlatColonGrid & grid);

/** Ticks every cm, with numbers where there is room. */
void
DrawRulerOfRow(Picture * picture, const FlatPageRow & place, const std::vector<double> & distanceOfColumns, bool isArc);

/** The bar of the local scale, at the right above the names. */
void
DrawScaleOfRow(Picture * picture, const FlatPageRow & place, double pixelSize);

/** Names of segments above the strip, polyps and marks on it. */
void
DrawAnnotationsOfRow(Picture * picture, const FlatPageRow & place, const std::vector<PlacedAnnotation> & annotations);
} // namespace shapeton

#endif
