#ifndef shapetonFlatPictureSize_h
#define shapetonFlatPictureSize_h

namespace shapeton
{
/** Number of pixels around the colon in a flat picture of a report. */
constexpr int pixelsAround = 200;
/** Number of pixels along a row of a flat picture: pages show pictures no wider than 992 pixels. */
constexpr int pixelsOfRow = 900;
} // namespace shapeton

#endif
