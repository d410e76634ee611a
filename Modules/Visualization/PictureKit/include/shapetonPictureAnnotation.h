#ifndef shapetonPictureAnnotation_h
#define shapetonPictureAnnotation_h

#include "shapetonColorMap.h"
#include "shapetonPageColors.h"
#include "shapetonPicture.h"

#include "itkVector.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** Draws a scale bar of a round number of millimeters, at most `greatestLength` pixels long, with its lower left corner
 * at (left, bottom) and its length above it.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawScaleBar(Picture *        picture,
             int              left,
             int              bottom,
             int              greatestLength,
             double           millimetersPerPixel,
             const RGBColor & color);

/** Style of the orientation letters.
 * \ingroup ShapetonPictureKit */
struct OrientationLettersStyle
{
  int      size{ 20 };
  RGBColor color;
  /** Distance to the left and right border, pixels; the distance to the upper and lower border is three quarters of
   * it. */
  int margin{ 8 };
  /** Adds a black copy offset by one pixel, for pictures with bright borders. */
  bool hasShadow{ false };
};

/** Draws the orientation letters at the four borders (see OrientationLetters); `right` and `up` are the directions of
 * the picture in LPS.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawOrientationLetters(Picture *                       picture,
                       const itk::Vector<double, 3> &  right,
                       const itk::Vector<double, 3> &  up,
                       const OrientationLettersStyle & style);

/** Color scale, for example in millimeters: values up to `lower` have the map's color at 0, values from `upper` its
 * color at 1.
 * \ingroup ShapetonPictureKit */
struct ColorScale
{
  /** Title, with the unit. */
  std::string                     title;
  double                          lower{ 0.0 };
  double                          upper{ 1.0 };
  std::function<RGBColor(double)> map{ HeatColor };
  /** Factor from values to the numbers at the ticks: 0.1 to show values in mm as cm. */
  double shownPerValue{ 1.0 };

  /** Color of a value; gray if it is not finite. */
  ShapetonPictureKit_EXPORT RGBColor
  ColorOf(double value) const;
};

/** ColorScale::shownPerValue and PlotAxis::shownPerValue to show mm as cm. \ingroup ShapetonPictureKit */
constexpr double MillimetersAsCentimeters = 0.1;

/** Colors of `number` values. \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::vector<RGBColor>
                          ColorsOf(const double * values, std::size_t number, const ColorScale & scale);

/** Width of a color bar with ticks and title, pixels. \ingroup ShapetonPictureKit */
constexpr int colorBarWidth = 96;

/** Draws a vertical color bar with round values and the title at its right, in the pixels
 * [left, left + colorBarWidth) x [top, top + height).
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawColorBar(Picture * picture, int left, int top, int height, const ColorScale & scale, const RGBColor & color);

/** A legend entry: a color and its meaning.
 * \ingroup ShapetonPictureKit */
struct LegendEntry
{
  RGBColor    color;
  std::string text;
};

/** Draws a legend downwards from (left, top); returns its height.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT int
DrawLegend(Picture *                        picture,
           const std::vector<LegendEntry> & legend,
           int                              left,
           int                              top,
           int                              bottom,
           const RGBColor &                 color = InkColor);
} // namespace shapeton

#endif
