#ifndef shapetonPicture_h
#define shapetonPicture_h

#include "ShapetonPictureKitExport.h"

#include "itkImage.h"
#include "itkRGBPixel.h"

#include <string>

namespace shapeton
{
/** An sRGB color, 0 to 255 for each channel.
 * \ingroup ShapetonPictureKit */
using RGBColor = itk::RGBPixel<unsigned char>;

/** The color with these channels.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT RGBColor
MakeColor(unsigned char red, unsigned char green, unsigned char blue);

/** Color interpolated between `from` (`share` 0) and `to` (1).
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT RGBColor
MixColors(const RGBColor & from, const RGBColor & to, double share);

/** A picture: index (0, 0) is the upper left pixel, the second index grows downwards.
 * All drawing functions clip at its borders.
 * \ingroup ShapetonPictureKit */
using Picture = itk::Image<RGBColor, 2>;

/** A picture filled with one color. Throws std::invalid_argument if a side is 0.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT Picture::Pointer
                          NewPicture(unsigned int width, unsigned int height, const RGBColor & background);

/** Writes PNG, regardless of the extension of `path`. Throws OutputError, for example if the disk is full.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
WritePng(const Picture * picture, const std::string & path);

/** The bytes of a JPEG file; `quality` in [1, 100].
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT std::string
                          EncodeJpeg(const Picture * picture, int quality);

/** A function that draws a picture, and the file to write it to. \ingroup ShapetonPictureKit */
struct PictureFile
{
  std::string                       path;
  std::function<Picture::Pointer()> draw;
  std::string                       caption{}; ///< on a page
};

/** Draws pictures in parallel and writes each as PNG. Throws the exceptions of the drawing functions and of WritePng().
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
WritePngs(const std::vector<PictureFile> & files);

/** Fills the pixels [left, left + width) x [top, top + height); `opacity` in [0, 1].
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
FillRectangle(Picture *        picture,
              int              left,
              int              top,
              int              width,
              int              height,
              const RGBColor & color,
              double           opacity = 1.0);

/** Draws the border of that rectangle, `thickness` pixels wide, inside it.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawRectangle(Picture * picture, int left, int top, int width, int height, const RGBColor & color, int thickness = 1);

/** Draws a straight antialiased line, `thickness` pixels wide; (x, y) is the center of pixel (x, y).
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawLine(Picture *        picture,
         double           x0,
         double           y0,
         double           x1,
         double           y1,
         const RGBColor & color,
         double           thickness = 1.0,
         double           opacity = 1.0);

/** Copies `source` with its upper left pixel at (left, top).
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
PastePicture(Picture * picture, const Picture * source, int left, int top);

/** Horizontal position of text relative to its anchor point.
 * \ingroup ShapetonPictureKit */
enum class HorizontalAnchor
{
  Left,
  Center,
  Right
};
/** The part of the text at its vertical anchor. \ingroup ShapetonPictureKit */
enum class VerticalAnchor
{
  Top,
  Center,
  Bottom
};

/** Text style. The font is VTK's built-in sans-serif font, so that pictures are identical on every machine.
 * \ingroup ShapetonPictureKit */
struct TextStyle
{
  /** Font height in pixels. */
  int              size{ 16 };
  RGBColor         color; ///< black
  bool             bold{ false };
  HorizontalAnchor horizontal{ HorizontalAnchor::Left };
  VerticalAnchor   vertical{ VerticalAnchor::Top };
  /** Rotated by 90 degrees, reading upwards; the anchors then refer to the rotated text. */
  bool upwards{ false };
};

/** Bounding box of drawn text, pixels. \ingroup ShapetonPictureKit */
struct TextExtent
{
  int width{ 0 };
  int height{ 0 };
};

/** Size of one line of UTF-8 text in pixels; the height depends only on the style.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT TextExtent
MeasureText(const std::string & text, const TextStyle & style);

/** The style with the largest size, at least 8 and at most the given one, at which the text fits in `width` pixels.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT TextStyle
FitText(const std::string & text, TextStyle style, int width);

/** Draws one line of UTF-8 text at the anchor point (x, y). Does not require a display. Throws std::runtime_error if
 * the text cannot be rendered.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawText(Picture * picture, const std::string & text, int x, int y, const TextStyle & style);

/** DrawText() with a one-pixel outline in another color, for backgrounds that may be bright or dark.
 * \ingroup ShapetonPictureKit */
ShapetonPictureKit_EXPORT void
DrawRimmedText(Picture *           picture,
               const std::string & text,
               int                 x,
               int                 y,
               const TextStyle &   style,
               const RGBColor &    rim);
} // namespace shapeton

#endif
