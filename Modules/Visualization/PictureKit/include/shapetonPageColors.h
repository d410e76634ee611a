#ifndef shapetonPageColors_h
#define shapetonPageColors_h

#include "shapetonPicture.h"

namespace shapeton
{
/** Background of pages and charts. \ingroup ShapetonPictureKit */
inline const RGBColor PaperColor = MakeColor(255, 255, 255);
/** Text and axes on PaperColor. \ingroup ShapetonPictureKit */
inline const RGBColor InkColor = MakeColor(30, 32, 38);
/** Less important text on PaperColor. \ingroup ShapetonPictureKit */
inline const RGBColor FaintInkColor = MakeColor(112, 116, 126);
} // namespace shapeton

#endif
