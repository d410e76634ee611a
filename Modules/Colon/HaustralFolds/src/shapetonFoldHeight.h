#ifndef shapetonFoldHeight_h
#define shapetonFoldHeight_h

#include "shapetonFoldCrest.h"

namespace shapeton
{
/** How far a fold stands above the wall, mm, at its highest: across the crest the surface is followed to both sides to
 * where it is curved outwards most, the foot; what lies farthest from the line between the feet is the top. Nine tenths
 * of the places of the crest are no higher. Not a number where fewer than three places have two feet. */
double
HeightOfFold(const FlatColonGrid & grid, const FoldPicture & picture, const FoldCrest & crest);
} // namespace shapeton

#endif
