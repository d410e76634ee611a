#ifndef shapetonFlatPictureSize_h
#define shapetonFlatPictureSize_h

namespace shapeton
{
/** Pixels of a flat picture around the colon, in the reports. */
constexpr int pixelsAround = 200;
/** Pixels of a row of a flat picture: pages show pictures no wider than 992 pixels. */
constexpr int pixelsOfRow = 900;
} // namespace shapeton

#endif
