#ifndef shapetonFoldShape_h
#define shapetonFoldShape_h

#include "shapetonFoldCrest.h"

namespace shapeton
{
/** A fold with all that is known of it. */
struct MeasuredFold
{
  /** Without label and reliabilities. */
  HaustralFold fold;
  FoldPixels   pixels;
  FoldCrest    crest;
};

/** `floor`: see TraceCrest(); the published scheme takes the axis of the ellipse for the crest. */
MeasuredFold
MeasureFold(const FlatColonGrid & grid, const FoldPicture & picture, FoldPixels pixels, HaustralFoldScheme scheme);
} // namespace shapeton

#endif
