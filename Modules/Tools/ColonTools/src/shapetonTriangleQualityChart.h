#ifndef shapetonTriangleQualityChart_h
#define shapetonTriangleQualityChart_h

#include "shapetonColonFlattening.h"
#include "shapetonPicture.h"

namespace shapeton
{
/** The histogram of 2r/R over the faces, in space and in the metric of the map; its threshold of 0.6. */
Picture::Pointer
DrawTriangleQualities(const ColonFlattening & flattening);
} // namespace shapeton

#endif
