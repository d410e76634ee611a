#ifndef shapetonFoldHeight_h
#define shapetonFoldHeight_h

#include "shapetonFoldCrest.h"

namespace shapeton
{
/** Maximum height of a fold above the wall, mm. Perpendicular to the crest, the surface is followed on both sides to
 * the foot, the point of lowest curvature; the top is the point farthest from the line between the feet. Returns the
 * 90th percentile along the crest; NaN if both feet are found at fewer than three points. */
double
HeightOfFold(const FlatColonGrid & grid, const FoldPicture & picture, const FoldCrest & crest);
} // namespace shapeton

#endif
