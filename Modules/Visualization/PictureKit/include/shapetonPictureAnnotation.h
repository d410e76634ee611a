#ifndef shapetonPictureAnnotation_h
#define shapetonPictureAnnotation_h

#include "shapetonColorMap.h"
#include "shapetonPicture.h"

#include "itkVector.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
/** Draws a bar of a round number of millimetres, at most `greatestLength` pixels long, with its lower left corner at
 * (left, bottom), and its length above it.
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawScaleBar(Picture *        picture,
             int              left,
             int              bottom,
             int              greatestLength,
             double           millimetresPerPixel,
             const RGBColor & color);

/** How the letters of the patient's sides look.
 * \ingroup PictureKit */
struct OrientationLettersStyle
{
  int      size{ 20 };
  RGBColor color;
  /** Pixels to the left and right border; three quarters of it to the upper and lower one. */
  int margin{ 8 };
  /** A black copy one pixel beside each letter, for pictures that may be bright there. */
  bool hasShadow{ false };
};

/** Writes at the four borders where they lie in the patient (see OrientationLetters); `right` and `up` are the
 * directions of the picture in LPS.
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawOrientationLetters(Picture *                       picture,
                       const itk::Vector<double, 3> &  right,
                       const itk::Vector<double, 3> &  up,
                       const OrientationLettersStyle & style);

/** Colours for values, for example millimetres: `lower` and all below has the map's colour at 0, `upper` that at 1.
 * \ingroup PictureKit */
struct ColorScale
{
  /** What is shown, with its unit. */
  std::string                     title;
  double                          lower{ 0.0 };
  double                          upper{ 1.0 };
  std::function<RGBColor(double)> map{ HeatColor };

  /** Grey for a value that is not finite. */
  PictureKit_EXPORT RGBColor
  ColorOf(double value) const;
};

/** The colours of `number` values. \ingroup PictureKit */
PictureKit_EXPORT std::vector<RGBColor>
                  ColorsOf(const double * values, std::size_t number, const ColorScale & scale);

/** Pixels that a colour bar takes across, with ticks and title. \ingroup PictureKit */
constexpr int colorBarWidth = 96;

/** Draws an upright bar with round values beside it and the title at its right, in the pixels
 * [left, left + colorBarWidth) x [top, top + height).
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawColorBar(Picture * picture, int left, int top, int height, const ColorScale & scale, const RGBColor & color);

/** A colour and what it stands for.
 * \ingroup PictureKit */
struct LegendEntry
{
  RGBColor    color;
  std::string text;
};

/** Draws a legend, one entry below the other, downwards from (left, top); returns the height it takes.
 * \ingroup PictureKit */
PictureKit_EXPORT int
DrawLegend(Picture *                        picture,
           const std::vector<LegendEntry> & legend,
           int                              left,
           int                              top,
           int                              bottom,
           const RGBColor &                 color = MakeColor(30, 32, 38));
} // namespace shapeton

#endif
