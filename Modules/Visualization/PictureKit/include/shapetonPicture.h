#ifndef shapetonPicture_h
#define shapetonPicture_h

#include "PictureKitExport.h"

#include "itkImage.h"
#include "itkRGBPixel.h"

#include <string>

namespace shapeton
{
/** An sRGB colour, 0 to 255 for each channel.
 * \ingroup PictureKit */
using RGBColor = itk::RGBPixel<unsigned char>;

/** The colour with these channels.
 * \ingroup PictureKit */
PictureKit_EXPORT RGBColor
MakeColor(unsigned char red, unsigned char green, unsigned char blue);

/** The colour `share` of the way from `from` (0) to `to` (1).
 * \ingroup PictureKit */
PictureKit_EXPORT RGBColor
MixColors(const RGBColor & from, const RGBColor & to, double share);

/** A picture: index (0, 0) is the upper left pixel, the second index grows downwards.
 * All drawing functions clip at its borders.
 * \ingroup PictureKit */
using Picture = itk::Image<RGBColor, 2>;

/** A picture of one colour. Throws std::invalid_argument when a side is 0.
 * \ingroup PictureKit */
PictureKit_EXPORT Picture::Pointer
                  NewPicture(unsigned int width, unsigned int height, const RGBColor & background);

/** Writes PNG, whatever the extension of `path`. Throws OutputError, also when the disk is full.
 * \ingroup PictureKit */
PictureKit_EXPORT void
WritePng(const Picture * picture, const std::string & path);

/** A picture that is still to be drawn, and the file that it goes to. \ingroup PictureKit */
struct PictureFile
{
  std::string                       path;
  std::function<Picture::Pointer()> draw;
};

/** Draws pictures beside each other and writes each as PNG. Throws what drawing and WritePng() throw.
 * \ingroup PictureKit */
PictureKit_EXPORT void
WritePngs(const std::vector<PictureFile> & files);

/** Fills the pixels [left, left + width) x [top, top + height); `opacity` in [0, 1].
 * \ingroup PictureKit */
PictureKit_EXPORT void
FillRectangle(Picture *        picture,
              int              left,
              int              top,
              int              width,
              int              height,
              const RGBColor & color,
              double           opacity = 1.0);

/** The outermost pixels, `thickness` deep, of that rectangle.
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawRectangle(Picture * picture, int left, int top, int width, int height, const RGBColor & color, int thickness = 1);

/** A straight antialiased line, `thickness` pixels wide; (x, y) is the centre of pixel (x, y).
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawLine(Picture *        picture,
         double           x0,
         double           y0,
         double           x1,
         double           y1,
         const RGBColor & color,
         double           thickness = 1.0,
         double           opacity = 1.0);

/** Copies `source` with its upper left pixel to (left, top).
 * \ingroup PictureKit */
PictureKit_EXPORT void
PastePicture(Picture * picture, const Picture * source, int left, int top);

/** Where a text lies relative to its anchor point.
 * \ingroup PictureKit */
enum class HorizontalAnchor
{
  Left,
  Center,
  Right
};
/** Which part of a text its vertical place means. \ingroup PictureKit */
enum class VerticalAnchor
{
  Top,
  Center,
  Bottom
};

/** How a text is set: the sans-serif face inside VTK, so that it looks the same on every machine.
 * \ingroup PictureKit */
struct TextStyle
{
  /** Height of the face in pixels. */
  int              size{ 16 };
  RGBColor         color; ///< black
  bool             bold{ false };
  HorizontalAnchor horizontal{ HorizontalAnchor::Left };
  VerticalAnchor   vertical{ VerticalAnchor::Top };
  /** Turned by a quarter, reading upwards; the anchors then refer to the turned text. */
  bool upwards{ false };
};

/** The box of a drawn text, pixels. \ingroup PictureKit */
struct TextExtent
{
  int width{ 0 };
  int height{ 0 };
};

/** The pixels that a text takes; the height depends on the style alone. One line of UTF-8.
 * \ingroup PictureKit */
PictureKit_EXPORT TextExtent
MeasureText(const std::string & text, const TextStyle & style);

/** The style with the largest size, at most its own and at least 8, at which the text is no wider than `width` pixels.
 * \ingroup PictureKit */
PictureKit_EXPORT TextStyle
FitText(const std::string & text, TextStyle style, int width);

/** Draws one line of UTF-8 text at the anchor point (x, y). Needs no display. Throws std::runtime_error when the text
 * cannot be set.
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawText(Picture * picture, const std::string & text, int x, int y, const TextStyle & style);

/** DrawText() with a rim, one pixel wide, of another colour, for grounds that may be bright or dark.
 * \ingroup PictureKit */
PictureKit_EXPORT void
DrawRimmedText(Picture *           picture,
               const std::string & text,
               int                 x,
               int                 y,
               const TextStyle &   style,
               const RGBColor &    rim);
} // namespace shapeton

#endif
