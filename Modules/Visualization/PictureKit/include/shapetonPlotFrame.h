#ifndef shapetonPlotFrame_h
#define shapetonPlotFrame_h

#include "shapetonPicture.h"

#include <string>

namespace shapeton
{
/** One axis of a chart: its values and pixels. \ingroup ShapetonPictureKit */
struct PlotAxis
{
  std::string title;
  double      lower{ 0.0 };
  double      upper{ 1.0 };
  /** Factor from values to the numbers at the ticks: 0.1 to show values in mm as cm. */
  double shownPerValue{ 1.0 };
};

/** A chart with two linear axes: the pixels of its area, and the values at its borders. \ingroup ShapetonPictureKit */
struct PlotFrame
{
  int      left{ 0 };
  int      top{ 0 };
  int      width{ 1 };
  int      height{ 1 };
  PlotAxis x; ///< to the right
  PlotAxis y; ///< upwards

  /** Pixel position of a value; the ends are at the centers of the first and the last pixel. */
  double
  PixelOfX(double value) const
  {
    return left + (value - x.lower) / (x.upper - x.lower) * (width - 1.0);
  }
  double
  PixelOfY(double value) const
  {
    return top + (y.upper - value) / (y.upper - y.lower) * (height - 1.0);
  }
};

/** Draws grid lines, the border, ticks with numbers at round values, and titles. Labels extend at most 74 pixels to the
 * left of the area and 52 below it. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawPlotFrame(Picture * picture, const PlotFrame & frame);
} // namespace shapeton

#endif
