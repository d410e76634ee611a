#ifndef shapetonFoldHeight_h
#define shapetonFoldHeight_h

#include "shapetonFoldCrest.h"

namespace shapeton
{
/** Maximum height of a fold above the wall, mm. Across the crest the surface is followed on both sides to its most
 * convex place, the foot; the point farthest from the line between the feet is the top. Returns the 90th percentile
 * over the crest; NaN if fewer than three places have two feet. */
double
HeightOfFold(const FlatColonGrid & grid, const FoldPicture & picture, const FoldCrest & crest);
} // namespace shapeton

#endif
