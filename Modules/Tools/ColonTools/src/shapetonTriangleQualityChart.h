#ifndef shapetonTriangleQualityChart_h
#define shapetonTriangleQualityChart_h

#include "shapetonColonFlattening.h"
#include "shapetonPicture.h"

namespace shapeton
{
/** Histogram of 2r/R over the faces, in space and in the metric of the map, with the threshold 0.6. */
Picture::Pointer
DrawTriangleQualities(const ColonFlattening & flattening);
} // namespace shapeton

#endif
